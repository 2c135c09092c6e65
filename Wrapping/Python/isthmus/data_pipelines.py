"""Whole pipelines with good defaults, on data: the pipelines of the toolbar's buttons, without ParaView.

Each function takes data or the path of a file. Their filters and settings are those of steps.PIPELINES,
which the buttons use as well; impossible requests raise ValueError.
"""
import collections
import os
import warnings

from . import functions, notebooks, steps


def _read(source):
    """A path is read by the reader of its ending; data are returned as they are."""
    if isinstance(source, (str, os.PathLike)):
        return read(source)
    return source


# File extensions, including those of gzip- or bzip2-compressed files, and their readers.
READERS = {
    "mrc_map_reader": (".mrc", ".map", ".ccp4", ".mrcs", ".rec", ".st", ".ali", ".mrcz"),
    "macromolecule_reader": tuple(functions.table()["functions"]["macromolecule_reader"]["endings"]),
    "open_dx_reader": (".dx", ".dxbin"), "off_surface_reader": (".off",), "msms_reader": (".vert", ".face"),
    "medit_reader": (".mesh",), "tet_gen_mesh_reader": (".ele", ".node"), "volume_text_reader": (".dat",)}
VTK_READERS = {".vtp": "vtkXMLPolyDataReader", ".vti": "vtkXMLImageDataReader", ".vtu": "vtkXMLUnstructuredGridReader",
               ".stl": "vtkSTLReader", ".ply": "vtkPLYReader", ".obj": "vtkOBJReader"}


def read(path):
    """Reads a map, a molecule, a surface or a mesh, by the ending of the file's name.

    Parameters
    ----------
    path : str or os.PathLike
        Maps (.mrc .map .ccp4), molecules (.pdb .cif .pqr ..., as Macromolecule Reader), potentials (.dx .dxbin),
        surfaces (.off .vert .stl .ply .obj .vtp), meshes (.mesh .ele .vtu) and VTK's volumes (.vti); those of
        Isthmus' own readers also gzipped or bzipped.

    Returns
    -------
    data
        A volume, points with one vertex per atom, a surface or a mesh. Lengths are in angstrom where the format
        says so. Of molecules, the atoms.

    Raises
    ------
    FileNotFoundError
        There is no such file.
    ValueError
        The ending is not known, or the file is damaged.

    Examples
    --------
    >>> import isthmus, os, tempfile
    >>> path = os.path.join(tempfile.mkdtemp(), "torus.off")
    >>> isthmus.off_surface_writer(isthmus.samples.torus(), path)
    >>> isthmus.read(path).GetNumberOfCells()
    2304
    """
    path = os.fspath(path)
    if not os.path.exists(path):
        raise FileNotFoundError(2, "No such file", path)
    name = os.path.basename(path).lower()
    for packed in (".gz", ".bz2"):
        name = name[:-len(packed)] if name.endswith(packed) else name
    ending = os.path.splitext(name)[1]
    for reader, endings in READERS.items():
        if ending in endings:
            made = functions.function(reader)(path)
            return made.atoms if reader == "macromolecule_reader" else made
    if ending in VTK_READERS:
        import importlib
        module = "vtkIOXML" if "XML" in VTK_READERS[ending] else "vtkIOPLY" if ending == ".ply" else "vtkIOGeometry"
        reader = getattr(importlib.import_module(f"vtkmodules.{module}"), VTK_READERS[ending])()
        reader.SetFileName(path)
        _check_surface_file(path, ending)
        functions.run(reader, "read")
        data = reader.GetOutputDataObject(0)
        if ending in (".stl", ".ply", ".obj") and not data.GetNumberOfCells():
            raise ValueError(f"read(): {path}: no polygons were found. The file is damaged, or stores its surface in a form "
                             "that VTK's reader does not support (strips, splines): write it as polygons.")
        return functions.give(data)
    known = sorted({end for endings in READERS.values() for end in endings} | set(VTK_READERS))
    raise ValueError(f"read(): {path}: no reader for the ending {ending or 'of this name'!r}; known are "
                     f"{' '.join(known)}.")


def _check_surface_file(path, ending):
    """Raises ValueError for files that VTK's readers misread or crash on."""
    if ending == ".stl":
        size = os.path.getsize(path)
        with open(path, "rb") as file:
            start = file.read(512)
        triangles = int.from_bytes(start[80:84], "little")
        is_text = start.lstrip()[:5].lower() == b"solid" and b"facet" in start.lower()
        if len(start) >= 84 and not is_text and size != 84 + 50 * triangles:
            raise ValueError(f"read(): {path}: {triangles} triangles of 50 bytes need {84 + 50 * triangles} bytes, but the "
                             f"file has {size}. It is truncated, or not a plain binary STL file: write it again.")
    elif ending == ".ply":
        with open(path, "rb") as file:
            header = file.read(65536).split(b"end_header")[0]
        elements = [words[1] for words in map(bytes.split, header.splitlines()) if words[:1] == [b"element"] and words[1:]]
        if b"face" in elements and b"vertex" in elements and elements.index(b"face") < elements.index(b"vertex"):
            raise ValueError(f"read(): {path}: its faces come before its vertices, which VTK's reader does not support: "
                             "write it with the vertices first.")


def _step(pipeline, name, *inputs, **more):
    """Runs a step of steps.PIPELINES."""
    step = steps.PIPELINES[pipeline][name]
    function = functions.function(_snake_case(step.proxy))
    given = {_snake_case(key): value for key, value in step.properties.items()}
    return function(*inputs, **{**given, **more})


def _snake_case(name):
    import re
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])", "_", name).lower()


def _field(data, name):
    array = data.GetFieldData().GetArray(name)
    return array.GetValue(0) if array is not None and array.GetNumberOfValues() else None


def _volume(source, function):
    inputs = functions.table()["functions"]["map_surface"]["inputs"][0]
    return functions.take_input(_read(source), inputs, function)


def _atoms(source, function):
    inputs = functions.table()["functions"]["molecular_pockets"]["inputs"][0]
    atoms = functions.take_input(_read(source), inputs, function)
    if not atoms.GetPointData().HasArray("Radius"):
        raise ValueError(f"{function}(): the atoms have no array Radius: read them with isthmus.read(), or give a "
                         "numpy array of rows x, y, z, radius.")
    return atoms


def _require(data, what):
    if not data.GetNumberOfCells():
        raise ValueError(steps.NOTHING[what])
    return data


def _surface_of_map(pipeline, volume, level):
    given = {} if level is None else {"level": level}
    surface = _step(pipeline, "surface", volume, **given)
    if surface.GetFieldData().GetAbstractArray("InvertedContrast") is not None:
        surface = _step(pipeline, "surface", volume, inside_is_higher=False, **given)
        warnings.warn(steps.INVERTED, functions.IsthmusWarning, stacklevel=3)
    return _require(surface, "surface")


def map_to_surface(volume, level=None):
    """The closed surface of a density map, without dust.

    Parameters
    ----------
    volume : vtkImageData, pyvista.ImageData, numpy array [x, y, z], or path of a map
        One number at each node.
    level : float, optional
        Value of the level set, in the unit of the map; by default the one that the depositors recommend, or one
        that separates the molecule from its surroundings. It is the field array Level of the result.

    Returns
    -------
    data
        The surface, lengths in the unit of the map (angstrom).

    Raises
    ------
    TypeError, ValueError
        The input is not a volume, is empty, or has nothing above the level.

    Examples
    --------
    >>> import isthmus
    >>> isthmus.map_to_surface(isthmus.samples.volume(), level=0.5).GetNumberOfCells() > 1000
    True
    """
    return _surface_of_map("map_to_surface", _volume(volume, "map_to_surface"), level)


MapToCurvature = notebooks.shows_html(collections.namedtuple("MapToCurvature", "surface curvature"))


def map_to_curvature(volume, level=None):
    """The surface of a density map with the curvature of the map there, smoothed by the automatic scale.

    Parameters
    ----------
    volume, level
        As in map_to_surface().

    Returns
    -------
    MapToCurvature
        The surface, and the same with point arrays MeanCurvature, GaussianCurvature (1/angstrom, 1/angstrom^2;
        a sphere has positive ones), ShapeIndex and so on.

    Raises
    ------
    TypeError, ValueError
        As map_to_surface(), or where the map is too small for curvature.

    Examples
    --------
    >>> import isthmus
    >>> made = isthmus.map_to_curvature(isthmus.samples.volume(), level=0.5)
    >>> made.curvature.GetPointData().HasArray("MeanCurvature")
    1
    """
    volume = _volume(volume, "map_to_curvature")
    surface = _surface_of_map("map_to_curvature", volume, level)
    curvature = _step("map_to_curvature", "curvature", surface, volume)
    values = curvature.GetPointData().GetArray("MeanCurvature")
    if values is None or not any(value == value for value in (values.GetValue(i) for i in range(values.GetNumberOfValues()))):
        raise ValueError(steps.NOTHING["curvature"])
    return MapToCurvature(surface, curvature)


MapToLoops = notebooks.shows_html(collections.namedtuple(
    "MapToLoops", "surface loops membranes choke_points persistence_diagram"))


def _denoised(volume, denoise):
    if denoise is False or denoise is None and volume.GetNumberOfPoints() > steps.MOST_NODES:
        return volume
    with warnings.catch_warnings():
        if not denoise:  # its warning about a map without noise does not concern the loops
            warnings.simplefilter("ignore", functions.IsthmusWarning)
        made = _step("map_to_loops", "denoised", volume)
    scalars = volume.GetPointData().GetScalars() or volume.GetPointData().GetArray(0)
    if denoise or steps.asks_for_denoising(_field(made, "EstimatedGain"), _field(made, "NoiseLevel"),
                                           *scalars.GetRange()):
        return made
    return volume


def map_to_loops(volume, level=None, denoise=None):
    """The choking loops of a density map: the rings where its inside or its outside narrows.

    Parameters
    ----------
    volume, level
        As in map_to_surface().
    denoise : bool, optional
        Whether the map is denoised first, as by denoise_map(). By default it is denoised if its noise requires that:
        at least half a percent of the map's range, and an estimated gain of at least 3 dB. The field arrays
        EstimatedGain and NoiseLevel of the surface show this.

    Returns
    -------
    MapToLoops
        The surface (its ten largest components) and the outputs of choking_loops() of it: loops, membranes,
        choke_points, persistence_diagram.

    Raises
    ------
    TypeError, ValueError
        As map_to_surface(), or where the surface cannot be analysed.

    Examples
    --------
    >>> import isthmus
    >>> isthmus.map_to_loops(isthmus.samples.volume(), level=0.5).loops.GetNumberOfCells() >= 2
    True
    """
    volume = _denoised(_volume(volume, "map_to_loops"), denoise)
    surface = _surface_of_map("map_to_loops", volume, level)
    return MapToLoops(surface, *_loops("map_to_loops", surface))


def _loops(pipeline, surface):
    try:
        return _step(pipeline, "loops", surface)
    except ValueError:
        # Closes holes and orients all triangles consistently; a warning reports the changes.
        return _step(pipeline, "loops", surface, cap_holes=True)


def surface_to_loops(surface):
    """The choking loops of a closed surface; holes are closed first.

    Parameters
    ----------
    surface : vtkPolyData, pyvista.PolyData, (points, triangles), or path of a surface
        Closed surfaces of triangles.

    Returns
    -------
    ChokingLoopsResult
        loops, membranes, choke_points, persistence_diagram: as choking_loops().

    Raises
    ------
    TypeError, ValueError
        The input is not a surface, is empty, or cannot be analysed.

    Examples
    --------
    >>> import isthmus
    >>> isthmus.surface_to_loops(isthmus.samples.torus()).loops.GetNumberOfCells()
    2
    """
    return _loops("surface_to_loops", _read(surface))


def _parts(atoms, pipeline):
    """Chains, and ligands with ions; the latter None where there are none."""
    if not atoms.GetPointData().HasArray("Element"):
        return atoms, None
    chains = _step(pipeline, "chains", atoms)
    if not chains.GetNumberOfPoints():
        raise ValueError(steps.NOTHING["chains"])
    ligands = _step(pipeline, "ligands", atoms)
    return chains, ligands if ligands.GetNumberOfPoints() else None


ProteinToSurface = notebooks.shows_html(collections.namedtuple("ProteinToSurface", "surface density chains ligands"))


def protein_to_surface(atoms):
    """The smooth molecular surface of the chains of a molecule.

    Parameters
    ----------
    atoms : vtkPointSet, pyvista.PolyData, numpy array of rows x, y, z, radius, or path of a molecule
        Atoms with the array Radius (angstrom), as isthmus.read() gives them.

    Returns
    -------
    ProteinToSurface
        The surface, the density that it is a level of, the chains, and the ligands with ions or None.

    Raises
    ------
    TypeError, ValueError
        The input has no atoms, or they have no radii.

    Examples
    --------
    >>> import isthmus
    >>> isthmus.protein_to_surface(isthmus.samples.atoms()).surface.GetNumberOfCells() > 100
    True
    """
    chains, ligands = _parts(_atoms(atoms, "protein_to_surface"), "protein_to_surface")
    density, surface = _molecule("protein_to_surface", chains)
    return ProteinToSurface(surface, density, chains, ligands)


def _molecule(pipeline, chains):
    density = _step(pipeline, "density", chains)
    return density, _require(_step(pipeline, "surface", density, scalars="Density"), "surface")


ProteinToPockets = notebooks.shows_html(collections.namedtuple(
    "ProteinToPockets", "residues pockets ranking mouths alpha_balls lining_residues lining_atoms site_surface"))


def protein_to_pockets(atoms):
    """The pockets of a molecule, the best one first.

    Parameters
    ----------
    atoms
        As in protein_to_surface().

    Returns
    -------
    ProteinToPockets
        residues: the atoms that line the best pocket; then the outputs of molecular_pockets(): pockets, ranking
        (a table: a row for each site, with its probability and its volume in cubic angstrom), mouths, alpha_balls,
        lining_residues, lining_atoms, site_surface (empty here, where no surface is given).

    Raises
    ------
    TypeError, ValueError
        They are no atoms, or the molecule has no pocket.

    Examples
    --------
    >>> import isthmus
    >>> isthmus.protein_to_pockets(isthmus.samples.atoms()).ranking.GetNumberOfRows() > 0
    True
    """
    found = _step("protein_to_pockets", "pockets", _atoms(atoms, "protein_to_pockets"))
    if not found.ranking.GetNumberOfRows():
        raise ValueError(steps.NOTHING["pockets"])
    return ProteinToPockets(_of_first(found.lining_atoms, "PocketId"), *found)


def _of_first(points, name):
    """The points of feature 1."""
    from vtkmodules.vtkCommonDataModel import vtkDataObject
    from vtkmodules.vtkFiltersCore import vtkThreshold
    threshold = vtkThreshold()
    threshold.SetInputDataObject(points)
    threshold.SetInputArrayToProcess(0, 0, 0, vtkDataObject.FIELD_ASSOCIATION_POINTS, name)
    threshold.SetThresholdFunction(vtkThreshold.THRESHOLD_BETWEEN)
    threshold.SetLowerThreshold(1)
    threshold.SetUpperThreshold(1)
    functions.run(threshold, "protein_to_pockets")
    return functions.give(threshold.GetOutputDataObject(0))


ProteinToPores = notebooks.shows_html(collections.namedtuple(
    "ProteinToPores", "lines profile pores bottlenecks lining_residues tubes lining_atoms"))


def protein_to_pores(atoms):
    """The channels that run through a molecule, the longest one first.

    Parameters
    ----------
    atoms
        As in protein_to_surface().

    Returns
    -------
    ProteinToPores
        The outputs of pore_profile(): lines, profile (a table: radius along each), pores (a table), bottlenecks,
        lining_residues, tubes, lining_atoms.

    Raises
    ------
    TypeError, ValueError
        They are no atoms, or no channel runs through the molecule.

    Examples
    --------
    >>> import isthmus
    >>> try:
    ...     isthmus.protein_to_pores(isthmus.samples.atoms())
    ... except ValueError as error:
    ...     print(str(error)[:40])
    No channel runs through the molecule. Po
    """
    found = _step("protein_to_pores", "pores", _atoms(atoms, "protein_to_pores"))
    if not found.pores.GetNumberOfRows():
        raise ValueError(steps.NOTHING["pores"])
    return ProteinToPores(*found)


ProteinToPotential = notebooks.shows_html(collections.namedtuple("ProteinToPotential", "potential surface sites ligands"))


def protein_to_potential(atoms, potential=None):
    """The electrostatic potential of a molecule, polarized curvature at its surface, and likely binding sites.

    Parameters
    ----------
    atoms
        As those of protein_to_surface(), with the array Charge (e); where the file has none, those of a force
        field are computed by the program pdb2pqr.
    potential : vtkImageData, pyvista.ImageData, or path of a .dx or .dxbin file, optional
        A potential (kT/e) on a grid; by default it is computed in 0.15 mol/l of salt.

    Returns
    -------
    ProteinToPotential
        potential (kT/e) on a grid; surface with the point arrays Potential, PolarizedCurvature (kT/(e angstrom))
        and BindingSite; sites (a table: a row for each, the best first); ligands with ions, or None.

    Raises
    ------
    TypeError, ValueError
        They are no atoms, or have no charges and none can be computed.

    Examples
    --------
    >>> import isthmus
    >>> made = isthmus.protein_to_potential(isthmus.samples.atoms())
    >>> made.surface.GetPointData().HasArray("PolarizedCurvature")
    1
    """
    pipeline = "protein_to_potential"
    chains, ligands = _parts(_atoms(atoms, pipeline), pipeline)
    if potential is None and not _has_charges(chains):
        chains = _step(pipeline, "charges", chains)
        if not chains.GetNumberOfPoints():
            raise ValueError(steps.NOTHING["charges"])
    density, surface = _molecule(pipeline, chains)
    if potential is None:
        potential = _step(pipeline, "potential", chains, density).potential
    else:
        potential = _read(potential)
    curvature = _step(pipeline, "curvature", surface, density, scalars="Density")
    polarized = _step(pipeline, "polarized", curvature, potential)
    given = {}
    if not _step("protein_to_pockets", "pockets", chains, find_sites=False).ranking.GetNumberOfRows():
        given["use_pockets"] = False
        warnings.warn(steps.NO_POCKETS, functions.IsthmusWarning, stacklevel=2)
    found = _step(pipeline, "sites", polarized, chains, **given)
    return ProteinToPotential(potential, found.surface, found.sites, ligands)


def _has_charges(atoms):
    charges = atoms.GetPointData().GetArray("Charge")
    return charges is not None and all(
        charges.GetValue(i) == charges.GetValue(i) for i in range(charges.GetNumberOfValues()))


NAMES = ("map_to_surface", "map_to_curvature", "map_to_loops", "surface_to_loops", "protein_to_surface",
         "protein_to_pockets", "protein_to_pores", "protein_to_potential")

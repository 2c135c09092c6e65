"""Numbers of a curvature-coloured isosurface: report.json and report.txt."""

import json

import numpy
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkFiltersCore import vtkPolyDataConnectivityFilter


def triangles_of(surface):
    """#triangles x 3 point indices."""
    return vtk_to_numpy(surface.GetPolys().GetConnectivityArray()).reshape(-1, 3)


def edge_use(triangles):
    """Distinct edges, and how many triangles use each (2 everywhere on a closed surface)."""
    pairs = numpy.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    return numpy.unique(pairs, axis=0, return_counts=True)


def areas_and_volume(points, triangles):
    """Area of each triangle, and the volume they enclose (divergence theorem), in A^2 and A^3."""
    corner = points[triangles].astype(float)
    normal = numpy.cross(corner[:, 1] - corner[:, 0], corner[:, 2] - corner[:, 0])
    # About the centroid, so that a far origin costs no digits.
    volume = numpy.einsum("ij,ij->", corner[:, 0] - points.mean(axis=0), normal) / 6
    return numpy.linalg.norm(normal, axis=1) / 2, abs(float(volume))


def point_areas(count, triangles, areas):
    """A third of the area of the triangles around each point."""
    return numpy.bincount(triangles.ravel(), numpy.repeat(areas / 3, 3), minlength=count)


def component_count(surface):
    connectivity = vtkPolyDataConnectivityFilter()
    connectivity.SetInputData(surface)
    connectivity.SetExtractionModeToAllRegions()
    connectivity.Update()
    return connectivity.GetNumberOfExtractedRegions()


def topology(surface, triangles, gaussian, weights):
    """Euler number and genus, counted and from the integral of Gaussian curvature."""
    edges, use = edge_use(triangles)
    euler = surface.GetNumberOfPoints() - len(edges) + len(triangles)
    components = component_count(surface)
    closed = bool((use == 2).all())
    result = {"components": components, "closed": closed, "euler_number": euler}
    if closed:
        # Gauss-Bonnet: the integral is 2 pi times the Euler number, 2 (components - genus).
        integral = float((gaussian * weights).sum())
        result["genus_from_euler_number"] = components - euler // 2
        result["genus_from_gaussian_curvature"] = components - integral / (4 * numpy.pi)
    return result


def measure(path, image, level, noise, surface, names):
    """All numbers of the report as a dictionary ready for JSON; lengths in angstrom."""
    points = vtk_to_numpy(surface.GetPoints().GetData())
    triangles = triangles_of(surface)
    areas, volume = areas_and_volume(points, triangles)
    arrays = {name: vtk_to_numpy(surface.GetPointData().GetArray(name)) for name in names}
    valid = vtk_to_numpy(surface.GetPointData().GetArray("CurvatureValid")) != 0
    weights = point_areas(len(points), triangles, areas) * valid
    return {
        "map": {
            "file": path.name,
            "dimensions": image.GetDimensions(),
            "spacing_A": image.GetSpacing(),
            "origin_A": image.GetOrigin(),
            "range": image.GetScalarRange(),
        },
        "level": level,
        "noise_level": noise,
        "surface": {
            "points": len(points),
            "triangles": len(triangles),
            "area_A2": float(areas.sum()),
            "enclosed_volume_A3": volume,
            "points_without_curvature": int((~valid).sum()),
            **topology(surface, triangles, arrays["GaussianCurvature"], weights),
        },
        "descriptors": {
            name: {
                "minimum": float(values[valid].min()),
                "maximum": float(values[valid].max()),
                "area_weighted_mean": float((values * weights).sum() / weights.sum()),
            }
            for name, values in arrays.items()
        },
    }


def as_text(report):
    """The same as text."""
    grid, level, surface = report["map"], report["level"], report["surface"]
    lines = [
        f"Map       {grid['file']}: {' x '.join(map(str, grid['dimensions']))} nodes, "
        f"spacing {' x '.join(f'{s:.4g}' for s in grid['spacing_A'])} A, "
        f"values {grid['range'][0]:.4g} to {grid['range'][1]:.4g}",
        f"Level     {level['value']:.6g} ({level['source']})",
        *(f"Noise     {value:.4g} ({name})" for name, value in report["noise_level"].items()),
        f"Surface   {surface['triangles']} triangles, {surface['components']} components, "
        f"{'closed' if surface['closed'] else 'open at the border of the map'}",
        f"Area      {surface['area_A2']:.6g} A^2",
    ]
    if surface["closed"]:
        lines += [
            f"Volume    {surface['enclosed_volume_A3']:.6g} A^3",
            f"Genus     {surface['genus_from_euler_number']} (Euler number "
            f"{surface['euler_number']}); {surface['genus_from_gaussian_curvature']:.2f} "
            "from the integral of Gaussian curvature",
        ]
        if abs(surface["genus_from_euler_number"] - surface["genus_from_gaussian_curvature"]) > 0.5:
            lines.append("          (the first counts handles; the second is too small where the surface bends within "
                         "a voxel or two)")
    lines.append(f"{'':20}{'minimum':>13}{'maximum':>13}{'area mean':>13}")
    for name, row in report["descriptors"].items():
        lines.append(f"{name:20}" + "".join(f"{value:13.5g}" for value in row.values()))
    return "\n".join(lines) + "\n"


def summary(report):
    """The text without the map and its noise, which the steps of map_to_curvature.py print."""
    return "".join(line for line in as_text(report).splitlines(True) if not line.startswith(("Map", "Noise")))


def write(path, image, level, noise, surface, names, folder):
    report = measure(path, image, level, noise, surface, names)
    (folder / "report.json").write_text(json.dumps(report, indent=2) + "\n")
    (folder / "report.txt").write_text(as_text(report))
    print(summary(report), end="")

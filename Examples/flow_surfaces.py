"""Shows molecular flow surfaces side by side for different enlargements, times and isovalues, and next to the
solvent-excluded surface.

Usage: pvpython flow_surfaces.py MOLECULE [FOLDER]

MOLECULE: PDB, mmCIF or PQR file, plain or compressed. Writes flow_multiresolution.png and
flow_beside_ses.png into FOLDER (default: a temporary one, which is printed) and prints area, volume and genus of
each. Without a screen, prefix the command with xvfb-run -a.
"""

import sys

import find_isthmus  # noqa: F401 (before isthmus)
import isthmus
import vtkmodules.vtkInteractionStyle  # noqa: F401
import vtkmodules.vtkRenderingFreeType  # noqa: F401
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkFiltersCore import vtkProbeFilter
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import (vtkActor, vtkPolyDataMapper, vtkRenderer, vtkRenderWindow,
                                         vtkTextActor, vtkWindowToImageFilter)

from output_folder import output_folder

METHODS = {"flow": 0, "thesis": 1, "SES": 2}


def flow_of(atoms, method="flow", **properties):
    """The filter after its update, and a line with area, volume, genus and number of components of its surface."""
    flow = isthmus.vtkMolecularFlowSurface()
    flow.SetInputConnection(atoms)
    flow.SetMethod(METHODS[method])
    for name, value in properties.items():
        getattr(flow, f"Set{name}")(value)
    measures = isthmus.vtkSurfaceMeasures()
    measures.SetInputConnection(flow.GetOutputPort())
    measures.Update()
    field = measures.GetOutput().GetFieldData()
    area, volume, genus, pieces = (field.GetArray(name).GetComponent(0, 0)
                                   for name in ("Area", "Volume", "Genus", "Components"))
    told = f"{area:.0f} A^2, {volume:.0f} A^3, genus {genus:.0f}, {pieces:.0f} pieces"
    return flow, told


def distance_colours():
    """Colours by signed distance: blue inside, white on and red outside the reference surface."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        t = i / 255.0
        low, high = min(1.0, 2.0 * t), min(1.0, 2.0 - 2.0 * t)
        table.SetTableValue(i, 0.25 + 0.75 * low if t < 0.5 else 1.0, 0.35 + 0.65 * min(low, high),
                            0.25 + 0.75 * high if t > 0.5 else 1.0, 1.0)
    return table


def picture(panels, columns, path, size=250):
    """Panels (surface, text, whether it is coloured by distance) in rows, all with the same camera."""
    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    rows = (len(panels) + columns - 1) // columns
    window.SetSize(columns * size, rows * size)
    window.SetMultiSamples(4)
    camera = None
    for i, (surface, text, coloured) in enumerate(panels):
        column, row = i % columns, rows - 1 - i // columns
        renderer = vtkRenderer()
        renderer.SetViewport(column / columns, row / rows, (column + 1) / columns, (row + 1) / rows)
        renderer.SetBackground(1, 1, 1)
        mapper = vtkPolyDataMapper()
        mapper.SetInputData(surface)
        if coloured:
            mapper.SelectColorArray("SignedDistance")
            mapper.SetScalarModeToUsePointFieldData()
            mapper.SetLookupTable(distance_colours())
            mapper.SetScalarRange(-1.0, 1.0)
        else:
            mapper.ScalarVisibilityOff()
        actor = vtkActor()
        actor.SetMapper(mapper)
        actor.GetProperty().SetColor(0.62, 0.72, 0.86)
        actor.GetProperty().SetSpecular(0.2)
        renderer.AddActor(actor)
        label = vtkTextActor()
        label.SetInput(text)
        label.GetTextProperty().SetColor(0, 0, 0)
        label.GetTextProperty().SetFontSize(13)
        label.SetPosition(8, 6)
        renderer.AddActor2D(label)
        window.AddRenderer(renderer)
        if camera is None:
            renderer.ResetCamera()
            camera = renderer.GetActiveCamera()
            camera.Zoom(1.35)
        renderer.SetActiveCamera(camera)
        renderer.ResetCameraClippingRange()
    window.Render()
    image = vtkWindowToImageFilter()
    image.SetInput(window)
    image.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetInputConnection(image.GetOutputPort())
    writer.SetFileName(str(path))
    writer.Write()


def main(molecule, folder):
    reader = isthmus.vtkMacromoleculeReader()
    reader.SetFileName(molecule)
    atoms = reader.GetOutputPort()

    panels = []
    for text, properties in (
            ("eta 1.0, T 2.5", {"Enlargement": 1.0}), ("eta 1.3, T 2.5", {}),
            ("eta 1.6, T 2.5", {"Enlargement": 1.6}), ("eta 2.0, T 2.5", {"Enlargement": 2.0}),
            ("eta 1.3, T 0.5", {"EvolutionTime": 0.5}), ("eta 1.3, T 2.5", {}),
            ("eta 1.3, T 10", {"EvolutionTime": 10.0}), ("eta 1.3, converged", {"Steady": True}),
            ("isovalue 0.1", {"Level": 0.1}), ("isovalue 0.37", {"Level": 0.37}),
            ("isovalue 0.63", {"Level": 0.63}), ("isovalue 0.9", {"Level": 0.9})):
        flow, told = flow_of(atoms, **properties)
        print(f"{text:18} {told}", flush=True)
        panels.append((flow.GetOutput(), text, False))
    picture(panels, 4, folder / "flow_multiresolution.png")

    excluded, told = flow_of(atoms, "SES", ProbeRadius=1.4)
    print(f"SES, probe 1.4     {told}", flush=True)
    panels = []
    for text, properties in (("fine", {"Preset": 1}), ("coarse", {"Preset": 2}),
                             ("hull", {"Preset": 3}), ("channel", {"Preset": 4})):
        flow, told = flow_of(atoms, **properties)
        print(f"{text:18} {told}", flush=True)
        probe = vtkProbeFilter()
        probe.SetInputData(flow.GetOutput())
        probe.SetSourceData(excluded.GetImage())
        probe.PassPointArraysOn()
        probe.Update()
        panels.append((flow.GetOutput(), text, False))
        panels.append((probe.GetOutput(), f"{text}, by its distance to the SES", True))
    order = [panels[0], panels[2], (excluded.GetOutput(), "solvent-excluded, probe 1.4", False),
             panels[6], panels[1], panels[3], panels[5], panels[7]]
    picture(order, 4, folder / "flow_beside_ses.png")
    print("Pictures:", folder)


if __name__ == "__main__":
    if {"-h", "--help"} & set(sys.argv[1:]):
        print(__doc__)
        sys.exit()
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    main(sys.argv[1], output_folder(sys.argv[2] if len(sys.argv) > 2 else None))

"""A ring of residues that widens and narrows, as a PDB file with models. For tests of trajectories."""

import numpy

RESIDUES = 40


def radii(frames):
    """Of the ring in each model, in angstrom."""
    return 8.0 + 1.5 * numpy.sin(2.0 * numpy.pi * numpy.arange(frames) / frames)


def write(path, frames):
    lines = []
    for model, radius in enumerate(radii(frames), 1):
        lines.append(f"MODEL     {model:4d}")
        for i in range(RESIDUES):
            angle = 2.0 * numpy.pi * i / RESIDUES
            x, y = radius * numpy.cos(angle), radius * numpy.sin(angle)
            lines.append(f"ATOM  {i + 1:5d}  CA  ALA A{i + 1:4d}    {x:8.3f}{y:8.3f}{0.0:8.3f}  1.00  0.00           C")
        lines.append("ENDMDL")
    path.write_text("\n".join(lines) + "\nEND\n")

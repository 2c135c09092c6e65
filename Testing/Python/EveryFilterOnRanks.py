"""Every filter of the plugin on 2 and 3 ranks: what one rank says, or a sentence.

Small data all on the first rank, the others without any; then dealt out. Each must give, over the
ranks together, the bounds and the ranges of all arrays that one rank gives, or refuse on the ranks
with a sentence that names them, and be empty. Blocks that one rank lacks end in a result or such a
sentence, and not in waiting without end. rank_filters.py runs the filters.
"""

import json
import os
import subprocess
import sys
import tempfile
from pathlib import Path


def run_on(ranks, layout, names):
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    with tempfile.TemporaryDirectory() as made:
        folder = Path(made)
        try:
            subprocess.run(["mpirun", "--oversubscribe", "-np", str(ranks), "pvbatch", "--sym",
                            str(Path(__file__).parent / "rank_filters.py"), made, layout, *names],
                           check=True, timeout=180, env=environment, capture_output=True)
        except subprocess.SubprocessError as error:
            last = [file.read_text() for file in sorted(folder.glob("*.now"))]
            said = (error.stderr or b"").decode("utf-8", "replace")[-2000:]
            raise AssertionError(f"{ranks} ranks, {layout}: ended at {last}: {said}") from error
        return [json.loads((folder / f"{ranks}.{rank}.json").read_text()) for rank in range(ranks)]


def near(a, b, scale):
    return a == b or abs(a - b) <= 1e-6 * max(scale, abs(a), abs(b), 1e-300)


def together(parts):
    """One output of all ranks."""
    low, high, found = None, None, {}
    for part in parts:
        if part["bounds"]:
            low = [min(a, b) for a, b in zip(low or part["bounds"][0], part["bounds"][0])]
            high = [max(a, b) for a, b in zip(high or part["bounds"][1], part["bounds"][1])]
        for name, (least, greatest) in part["ranges"].items():
            old = found.get(name, [least, greatest])
            found[name] = [min(least, old[0]), max(greatest, old[1])]
    return low, high, found


def differences(one, parts):
    """What of an output is not as on one rank."""
    (low, high, found), (low1, high1, found1) = together(parts), together([one])
    if (low is None) != (low1 is None):
        return ["nothing" if low is None else "something, where one rank has nothing"]
    wrong = []
    if low:
        size = max(b - a for a, b in zip(low1, high1))
        if not all(near(a, b, size) for a, b in zip(low + high, low1 + high1)):
            wrong.append(f"bounds {low} to {high}, not {low1} to {high1}")
    for name in sorted(set(found) | set(found1)):
        if name not in found or name not in found1:
            wrong.append(f"{name} {'is missing' if name not in found else 'is new'}")
            continue
        scale = found1[name][1] - found1[name][0]
        if not all(near(a, b, scale) for a, b in zip(found[name], found1[name])):
            wrong.append(f"{name} {found[name]}, not {found1[name]}")
    return wrong


def complaints_of(name, one, parts):
    sentences = [sentence for part in parts for sentence in part["errors"]]
    if one["errors"] and not sentences:
        return ["says nothing, where one rank refuses"]
    if sentences:
        wrong = [f"says {sentence!r}" for sentence in sentences
                 if "rank" not in sentence and not one["errors"]]
        if any(output["size"] for part in parts for output in part["outputs"]):
            wrong.append("refuses, but is not empty")
        return wrong
    wrong = []
    for port, output in enumerate(one["outputs"]):
        mine = [part["outputs"][port] for part in parts]
        wrong += [f"port {port}: {said}" for said in differences(output, mine)]
        # Pieces of images share nodes, and images are whole where a rank asks for all.
        size = sum(part["size"] for part in mine)
        if output["type"] != "vtkImageData" and size != output["size"]:
            wrong.append(f"port {port}: {size} elements together, not {output['size']}")
    return wrong


def blocks_on_two(names):
    """What becomes of blocks that the second rank lacks: the end, first of all."""
    return run_on(2, "blocks", names)[0]


def main(names):
    whole = run_on(1, "first", names)[0]
    refused, wrong = {}, []
    for layout in ("first", "pieces"):
        for ranks in (2, 3):
            parts = run_on(ranks, layout, names)
            for name, one in whole.items():
                mine = [part[name] for part in parts]
                if any(part["errors"] for part in mine) and not one["errors"]:
                    refused.setdefault(layout, set()).add(name)
                for complaint in complaints_of(name, one, mine):
                    wrong.append(f"{name}, {layout}, {ranks} ranks: {complaint}")
                    print(wrong[-1], flush=True)
    for layout, of_layout in refused.items():
        print(f"refused with a sentence, {layout}: {', '.join(sorted(of_layout))}")
    lost = [name for name, one in whole.items() if one["errors"]]
    wrong += [f"{name}, blocks: says {sentence!r}" for name, part in blocks_on_two(names).items()
              for sentence in part["errors"] if not ("rank" in sentence or whole[name]["errors"])]
    print("\n".join(said for said in wrong if ", blocks:" in said))
    print(f"{len(whole)} filters, of which refuse these data on one rank already: {lost}")
    assert not wrong, f"{len(wrong)} differences"
    assert names or len(whole) - len(lost) > 30


if __name__ == "__main__":
    main(sys.argv[1:])

"""Strong scaling of the image filters on 1, 2 and 4 ranks of 1 and 2 threads, as a table.

Usage: ranks.py [NODES]    a map of NODES^3 (256), with PV_PLUGIN_PATH and PYTHONPATH as for any script

Seconds of the slowest rank, the median of three turns after one that is not counted, the input
in memory; in brackets the seconds of all processors, those that ranks spend waiting for others among
them. `exchange` is one exchange of faces two nodes deep
between neighbours, as one evaluation of a diffusion needs it; `read` is how many nodes the curvature's
input has in all, over those of the map: what ghost layers cost. More ranks times threads than the
machine has cores say what sharing costs, not how it scales.
"""

import json
import os
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

RUNS = ((1, 1), (1, 2), (2, 1), (2, 2), (4, 1), (4, 2))
FILTERS = ("denoise", "high-pass", "curvature")


def run(ranks, threads, nodes, folder):
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       VTK_SMP_BACKEND_IN_USE="STDThread", VTK_SMP_MAX_THREADS=str(threads),
                       OMPI_MCA_mpi_yield_when_idle="1")
    stem = Path(folder, f"{ranks}x{threads}")
    # Bound to a core each, ranks would have one for all of their threads.
    subprocess.run(["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), "pvbatch", "--sym",
                    str(Path(__file__).with_name("rank_times.py")), str(nodes), str(stem)],
                   check=True, timeout=1800, env=environment, stdout=subprocess.DEVNULL)
    return [json.loads(Path(f"{stem}.{rank}.json").read_text(encoding="utf-8")) for rank in range(ranks)]


def line(ranks, threads, parts, nodes):
    cells = [str(ranks), str(threads)]
    for name in FILTERS:
        # Barriers make every rank's turn as long as the slowest's.
        wall = statistics.median(map(max, zip(*(part[name]["walls"] for part in parts))))
        used = statistics.median(map(sum, zip(*(part[name]["processors"] for part in parts))))
        cells.append(f"{wall:.3g} ({used:.3g})")
    cells.append(f"{1e3 * max(part['exchange'] for part in parts):.2g} ms" if ranks > 1 else "")
    cells.append(f"{sum(part['curvature']['read'] for part in parts) / nodes ** 3:.3f}")
    return "| " + " | ".join(cells) + " |"


def main(nodes):
    print(f"{nodes}^3 floats, {os.cpu_count()} cores")
    print("| ranks | threads | " + " | ".join(f"{name}, s" for name in FILTERS) + " | exchange | read |")
    print("|" + "---|" * (len(FILTERS) + 4))
    with tempfile.TemporaryDirectory() as folder:
        for ranks, threads in RUNS:
            print(line(ranks, threads, run(ranks, threads, nodes, folder), nodes), flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 256)

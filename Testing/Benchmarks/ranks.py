"""Scaling of the image filters over ranks and threads, as two tables.

Usage: ranks.py [--nodes 256] [--weak 192] [--run "pvbatch --sym"]

The first table shares a map of NODES^3 among all, the second gives WEAK^3 nodes to each rank. PV_PLUGIN_PATH
and PYTHONPATH as for any script; `--run python3` needs no ParaView, only VTK's Python modules and Open MPI.

Seconds of the slowest rank, the median of three turns after one that is not counted, the input
in memory; in brackets the seconds of all processors, those that ranks spend waiting for others among
them. `memory` is what the largest rank had resident at most in any of the filters, the program and the map
among it, and the sum over ranks. `exchange` is one exchange of faces two nodes deep
between neighbours, as one evaluation of a diffusion needs it; `read` is how many nodes the curvature's
input has in all, over those of the map: what ghost layers cost. Runs of more ranks times threads than the
machine has cores are left out: they would say what sharing costs, not how it scales.
"""

import argparse
import json
import os
import statistics
import subprocess
import tempfile
from pathlib import Path

RUNS = ((1, 1), (2, 1), (4, 1), (8, 1), (1, 2), (1, 4), (1, 8), (2, 4), (4, 2))
WEAK_RUNS = ((1, 1), (2, 1), (4, 1), (8, 1))
FILTERS = ("denoise", "high-pass", "curvature")


def run(program, ranks, threads, nodes, folder):
    environment = {name: value for name, value in os.environ.items()
                   if not name.startswith(("OMPI_", "PMIX_", "ORTE_"))}
    environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                       VTK_SMP_BACKEND_IN_USE="STDThread", VTK_SMP_MAX_THREADS=str(threads),
                       OMPI_MCA_mpi_yield_when_idle="1")
    stem = Path(folder, f"{ranks}x{threads}")
    # Bound to a core each, ranks would have one for all of their threads.
    subprocess.run(["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks), *program,
                    str(Path(__file__).with_name("rank_times.py")), *map(str, nodes), str(stem)],
                   check=True, timeout=1800, env=environment, stdout=subprocess.DEVNULL)
    return [json.loads(Path(f"{stem}.{rank}.json").read_text(encoding="utf-8")) for rank in range(ranks)]


def line(ranks, threads, parts, nodes):
    cells = [str(ranks), str(threads)]
    for name in FILTERS:
        # Barriers make every rank's turn as long as the slowest's.
        wall = statistics.median(map(max, zip(*(part[name]["walls"] for part in parts))))
        used = statistics.median(map(sum, zip(*(part[name]["processors"] for part in parts))))
        cells.append(f"{wall:.3g} ({used:.3g})")
    peaks = [max(part[name]["peak"] for name in FILTERS) for part in parts]
    cells.append(f"{max(peaks) / 1e6:.0f}, {sum(peaks) / 1e6:.0f}")
    cells.append(f"{1e3 * max(part['exchange'] for part in parts):.2g} ms" if ranks > 1 else "")
    cells.append(f"{sum(part['curvature']['read'] for part in parts) / (nodes[0] * nodes[1] * nodes[2]):.3f}")
    return "| " + " | ".join(cells) + " |"


def table(title, program, runs, nodes_of):
    print(f"{title}, {os.cpu_count()} cores")
    print("| ranks | threads | " + " | ".join(f"{name}, s" for name in FILTERS)
          + " | memory: a rank, all, MB | exchange | read |")
    print("|" + "---|" * (len(FILTERS) + 5))
    with tempfile.TemporaryDirectory() as folder:
        for ranks, threads in runs:
            if ranks * threads <= os.cpu_count():
                nodes = nodes_of(ranks)
                print(line(ranks, threads, run(program, ranks, threads, nodes, folder), nodes), flush=True)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--nodes", type=int, default=256, help="along each axis of the map that is shared")
    parser.add_argument("--weak", type=int, default=192, help="along each axis of a rank's part")
    parser.add_argument("--run", default="pvbatch --sym", help="what runs a script on each rank")
    arguments = parser.parse_args()
    program = arguments.run.split()
    table(f"{arguments.nodes}^3 floats", program, RUNS, lambda ranks: 3 * [arguments.nodes])
    table(f"{arguments.weak}^3 floats a rank", program, WEAK_RUNS,
          lambda ranks: [arguments.weak, arguments.weak, arguments.weak * ranks])

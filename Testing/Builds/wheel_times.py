"""Size and times of an installed wheel: a row of the table in Documentation/installation.md.

    wheel_times.py WHEEL    times are medians of nine processes, for an idle machine: `import isthmus`, the first filter (choking
                            loops of a torus, by which libraries are loaded), and the same filter again
"""
import pathlib
import statistics
import subprocess
import sys

RUN = """
from time import perf_counter as now
start = now()
import isthmus
imported = now()
torus = isthmus.samples.torus()
isthmus.choking_loops(torus)
first = now()
isthmus.choking_loops(torus)
print(imported - start, first - imported, now() - first)
"""


def main():
    wheel = pathlib.Path(sys.argv[1])
    runs = [subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True, check=True).stdout for _ in range(9)]
    times = [statistics.median(column) for column in zip(*(map(float, run.split()) for run in runs))]
    version = subprocess.run([sys.executable, "-c", "from vtkmodules.vtkCommonCore import vtkVersion as v; print(v.GetVTKVersion())"],
                             capture_output=True, text=True, check=True).stdout.strip()
    print("| Python, VTK | wheel | import | first filter | again |")
    print(f"| {sys.version_info[0]}.{sys.version_info[1]}, {version} | {wheel.stat().st_size / 1e6:.1f} MB | "
          + " | ".join(f"{time:.2f} s" for time in times) + " |")


if __name__ == "__main__":
    main()

"""Size and times of an installed wheel: a row of the table in Documentation/installation.md.

    wheel_times.py WHEEL    `import isthmus`, the first filter (choking loops of a torus, by which libraries are loaded), and the
                            same filter again: medians of nine processes, in seconds of the clock and, in parentheses, of CPU
"""
import pathlib
import statistics
import subprocess
import sys

RUN = """
from time import perf_counter, process_time
times = [(perf_counter(), process_time())]
import isthmus
times.append((perf_counter(), process_time()))
torus = isthmus.samples.torus()
isthmus.choking_loops(torus)
times.append((perf_counter(), process_time()))
isthmus.choking_loops(torus)
times.append((perf_counter(), process_time()))
print(*(after[clock] - before[clock] for before, after in zip(times, times[1:]) for clock in (0, 1)))
"""


def main():
    wheel = pathlib.Path(sys.argv[1])
    runs = [subprocess.run([sys.executable, "-c", RUN], capture_output=True, text=True, check=True).stdout for _ in range(9)]
    times = [statistics.median(column) for column in zip(*(map(float, run.split()) for run in runs))]
    version = subprocess.run([sys.executable, "-c", "from vtkmodules.vtkCommonCore import vtkVersion as v; print(v.GetVTKVersion())"],
                             capture_output=True, text=True, check=True).stdout.strip()
    print("| Python, VTK | wheel | import | first filter | again |")
    print(f"| {sys.version_info[0]}.{sys.version_info[1]}, {version} | {wheel.stat().st_size / 1e6:.1f} MB | "
          + " | ".join(f"{times[at]:.3f} ({times[at + 1]:.3f})" for at in (0, 2, 4)) + " |")


if __name__ == "__main__":
    main()

"""The command `isthmus` of an installed wheel: results, tables, exit codes, help.

    wheel_command.py DATA      (folder of the shared data; without it a map is written)
"""
import csv
import json
import os
import shutil
import subprocess
import sys
import tempfile

import isthmus


def run(*words, code=0):
    made = subprocess.run([os.path.join(os.path.dirname(sys.executable), "isthmus"), *words],
                          capture_output=True, text=True, timeout=600, check=False)
    assert made.returncode == code, f"isthmus {' '.join(words)}: {made.returncode}\n{made.stdout}{made.stderr}"
    return made


def check_help():
    for words in ([], *([name] for name in ("loops", "pockets", "pores", "surface", "curvature", "potential"))):
        said = run(*words, "--help").stdout
        assert "exit codes:" in said and "usage: isthmus" in said, said
    assert isthmus.__version__ in run("--version").stdout


def check_faults(folder):
    for words, code, message in (
            (("loops", os.path.join(folder, "none.mrc")), 1, "No such file"),
            (("loops", __file__), 1, "no reader for the ending"),
            (("loops",), 2, "usage"), (("dance", "x"), 2, "invalid choice"),
            (("loops", "x.mrc", "--level", "high"), 2, "invalid float")):
        said = run(*words, code=code)
        assert message in said.stderr and "Traceback" not in said.stderr, said.stderr


def check_surface(folder):
    path = os.path.join(folder, "torus.off")
    isthmus.off_surface_writer(isthmus.samples.torus(), path)
    out, table = os.path.join(folder, "loops.vtp"), os.path.join(folder, "loops.csv")
    said = run("loops", path, "-o", out, "--table", table)
    assert "loops 2, handles 1, tunnels 1" in said.stdout, said.stdout
    assert isthmus.read(out).GetNumberOfCells() == 2
    with open(table, encoding="utf-8") as file:
        rows = list(csv.DictReader(file))
    assert sorted(row["KindName"] for row in rows) == ["handle", "tunnel"]
    printed = json.loads(run("loops", path, "--json").stdout)
    assert printed["loops"] == 2 and len(printed["rows"]) == 2
    assert run("loops", path, "--quiet").stdout == ""
    assert run("loops", path, "--table", "-").stdout.startswith("FeatureId,")
    run("loops", path, "-o", os.path.join(folder, "no", "folder.vtp"), code=1)


def check_shared(data, folder):
    path = os.path.join(data, "maps", "EMD-3197.map")
    if os.path.exists(path):
        out = os.path.join(folder, "map.vtp")
        run("loops", path, "-o", out)
        assert isthmus.read(out).GetNumberOfCells() > 0
    path = os.path.join(data, "molecules", "1UBI.pdb")
    if os.path.exists(path):
        printed = json.loads(run("pockets", path, "--json").stdout)
        chances = [row["Probability"] for row in printed["rows"]]
        assert printed["pockets"] == len(chances) > 1 and chances == sorted(chances, reverse=True), printed


def main():
    folder = tempfile.mkdtemp()
    try:
        check_help()
        check_faults(folder)
        check_surface(folder)
        check_shared(sys.argv[1] if len(sys.argv) > 1 else "", folder)
    finally:
        shutil.rmtree(folder)
    print("The command works.")


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Builds the guide: pages, drawing of the modules, Sphinx, Doxygen, and a check of all internal links.

    build_guide.py OUTPUT [--version VERSION] [--pages-only] [--no-api] [--may-skip]

The site is OUTPUT/html/index.html; it shows the scenes that Examples/scenes.py wrote to OUTPUT/scenes. The exit
status is 1 where anything warned. Needs Sphinx with MyST and Furo, Doxygen, Graphviz and MathJax 2
(cmake/setup.sh: guide_packages).
"""

import argparse
import html
import re
import shutil
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
SITE = Path(__file__).resolve().parent / "site"
sys.path.insert(0, str(SITE))
import links  # noqa: E402
import pages  # noqa: E402

MATHJAX = Path("/usr/share/javascript/mathjax")
# What TeX formulas as SVG need of it.
MATHJAX_PARTS = ("MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX",
                 "jax/output/SVG/autoload", "jax/output/SVG/fonts/TeX", "jax/output/SVG/config.js",
                 "jax/output/SVG/jax.js")


def version_of_project():
    """The version in the root CMakeLists.txt, its only place."""
    return re.search(r"^project\(Isthmus VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text(),
                     re.MULTILINE).group(1)


def run(*command):
    """Runs a program, shows its output, and returns whether it succeeded."""
    done = subprocess.run([str(part) for part in command], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, check=False)
    if done.stdout.strip():
        print(done.stdout.strip())
    if done.returncode != 0:
        print(f"{command[0]} ended with {done.returncode}")
    return done.returncode == 0


def scenes_in(folder):
    """(name, title) of each page of Examples/scenes.py in a folder."""
    return [(page.stem, html.unescape(re.search("<title>(.*?)</title>", page.read_text())[1]))
            for page in sorted(folder.glob("*.html"))]


def copy_mathjax(target):
    for part in MATHJAX_PARTS:
        source = MATHJAX / part
        if source.is_dir():
            shutil.copytree(source, target / part, dirs_exist_ok=True)
        else:
            (target / part).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(source, target / part)


# What VTK's macros declare, as Doxygen shall show it.
DECLARATIONS = {
    "vtkTypeMacro(name, base)": "", "vtkAbstractTypeMacro(name, base)": "",
    "vtkSetMacro(name, type)": "virtual void Set##name(type value);",
    "vtkSetClampMacro(name, type, lowest, highest)": "virtual void Set##name(type value);",
    "vtkGetMacro(name, type)": "virtual type Get##name();",
    "vtkBooleanMacro(name, type)": "virtual void name##On(); virtual void name##Off();",
    "vtkSetFilePathMacro(name)": "virtual void Set##name(const char* value);",
    "vtkGetFilePathMacro(name)": "virtual char* Get##name();",
    "vtkGetObjectMacro(name, type)": "virtual type* Get##name();",
    "vtkGetVectorMacro(name, type, count)": "virtual type* Get##name();",
    **{f"vtkSetVector{n}Macro(name, type)": "virtual void Set##name("
       + ", ".join(f"type value{i}" for i in range(n)) + ");" for n in (2, 3, 4, 6)},
    **{f"vtkGetVector{n}Macro(name, type)": "virtual type* Get##name();" for n in (2, 3, 4, 6)},
    "ISTHMUS_PARAMETER(name, type)": "virtual void Set##name(type value); virtual type Get##name();",
    "ISTHMUS_PARAMETER_OF(parameters, name, type)":
        "virtual void Set##name(type value); virtual type Get##name();",
    "ISTHMUS_PARAMETER_SWITCH_OF(parameters, name)": "virtual void Set##name(bool value); "
        "virtual bool Get##name(); virtual void name##On(); virtual void name##Off();",
    "ISTHMUS_PARAMETER_SWITCH(name)": "virtual void Set##name(bool value); virtual bool Get##name(); "
        "virtual void name##On(); virtual void name##Off();",
    **{f"ISTHMUS_PARAMETER_VECTOR{n}(name, type)": "virtual void Set##name("
       + ", ".join(f"type value{i}" for i in range(n)) + "); virtual type* Get##name();" for n in (3, 4)},
}


def predefined_macros():
    """Macros for Doxygen: those that export nothing to it, and those that declare methods."""
    names = set()
    for header in ROOT.glob("[FR]*/*/*.h"):
        names.update(re.findall(r"\bVTKISTHMUS\w+_EXPORT\b", header.read_text()))
    return " ".join([*(f"{name}=" for name in sorted(names)),
                     *(f'"{macro}={text}"' for macro, text in DECLARATIONS.items())])


def write_doxyfile(output, version):
    text = (SITE / "Doxyfile.in").read_text()
    for name, value in {"VERSION": version, "ROOT": ROOT, "MAINPAGE": SITE / "api.md",
                        "OUTPUT": output / "html", "PREDEFINED": predefined_macros()}.items():
        text = text.replace(f"@{name}@", str(value))
    (output / "Doxyfile").write_text(text)
    return output / "Doxyfile"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("output", type=Path)
    parser.add_argument("--version", default=version_of_project())
    parser.add_argument("--pages-only", action="store_true", help="write the source of the pages, no more")
    parser.add_argument("--no-api", action="store_true", help="leave the C++ reference as it is")
    parser.add_argument("--may-skip", action="store_true", help="exit status 77 where a program is missing")
    options = parser.parse_args()
    output = options.output.resolve()

    source = output / "source"
    shutil.rmtree(source, ignore_errors=True)
    for part in (output / "html").glob("*"):  # pages that are no more
        if part.name != "api" or not options.no_api:
            shutil.rmtree(part) if part.is_dir() else part.unlink()
    site = pages.Site(ROOT, options.version, scenes_in(output / "scenes"))
    site.write(source)
    print(f"{len(site.pages)} pages, {len(site.panels)} of them of filters, readers and writers")
    if options.pages_only:
        return 0

    missing = [package for package, there in (
        ("python3-sphinx, python3-myst-parser, furo", shutil.which("sphinx-build")),
        ("doxygen", shutil.which("doxygen")), ("graphviz", shutil.which("dot")),
        ("libjs-mathjax", MATHJAX.is_dir())) if not there]
    if missing:
        print("Not installed: " + ", ".join(missing))
        return 77 if options.may_skip else 1
    static = source / "_static"
    copy_mathjax(static / "mathjax")
    shutil.copyfile(SITE / "guide.css", static / "guide.css")
    good = run("dot", "-Tsvg", source / "modules.dot", "-o", source / "modules.svg")
    if not options.no_api:
        (output / "html").mkdir(parents=True, exist_ok=True)
        good &= run("doxygen", write_doxyfile(output, options.version))
    good &= run("sphinx-build", "-q", "-n", "-W", "--keep-going", "-b", "html", "-d", output / "doctrees",
                "-D", f"release={options.version}", "-D", f"version={options.version}", source,
                output / "html")
    if site.scenes:
        shutil.copytree(output / "scenes", output / "html" / "scenes")
    complaints, looked_at = links.check(output / "html")
    for complaint in complaints:
        print(complaint)
    print(f"{looked_at} internal links checked, {len(complaints)} broken")
    print(f"The guide: {output / 'html' / 'index.html'}")
    return 0 if good and looked_at and not complaints else 1


if __name__ == "__main__":
    sys.exit(main())

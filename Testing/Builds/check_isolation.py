"""Whether modules are isolated from each other. Usage: check_isolation.py SOURCES BUILD

BUILD is a tree configured for Ninja. For each module Ninja is asked what it compiles for the module's
target. Then a source is compiled with the module's own flags that includes a header of each module
that it declares, and asks for one of each other module, which must not be found; one of those is
included, too, which must not compile.
"""
import json
import pathlib
import re
import shlex
import subprocess
import sys

sources, build = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(sources / "Testing"))
import check_modules  # noqa: E402

modules = {module.name: module for module in check_modules.modules_of(sources)}
assert len(modules) > 10, modules


def reached(name, private):
    """Modules that `name` needs: with `private`, to be linked, else those whose headers it sees."""
    seen, todo = set(), [name]
    while todo:
        module = todo.pop()
        if module not in seen:
            seen.add(module)
            todo += modules[module].declares(private=private or module == name)
    return seen


def compiled_for(target):
    """Modules whose files Ninja would compile for a target."""
    done = subprocess.run(["ninja", "-C", build, "-t", "commands", target], capture_output=True,
                          text=True, check=True)
    found = re.findall(rf"-c {re.escape(str(sources))}/(\w+)/(\w+)/\w+\.cxx", done.stdout)
    return {kind + folder for kind, folder in found}


failures = 0
for name in sorted(modules):
    extra = compiled_for(name) ^ reached(name, private=True)
    if extra:
        failures += 1
        print(f"building {name} alone: {', '.join(sorted(extra))} should (not) be built")

commands = json.loads((build / "compile_commands.json").read_text())
probe = build / "probe.cxx"
headers = {}
for name, module in modules.items():
    # The shortest one: what it includes takes the time.
    own = [path for path in module.files if path.suffix == ".h" and not path.name.startswith("vtk")]
    if own:
        shortest = min(own, key=lambda path: (path.stat().st_size, path.name))
        headers[name] = f"{module.folder.name}/{shortest.name}"


def error_of(command, lines):
    """What the compiler says of a file of these lines, with the flags of `command`."""
    probe.write_text("\n".join(lines) + "\n")
    words = shlex.split(command["command"])
    flags = [word for word in words[:words.index("-o")] if word not in ("-MD", "-Werror")]
    done = subprocess.run([*flags, "-fsyntax-only", probe], cwd=command["directory"],
                          capture_output=True, text=True)
    return done.stderr if done.returncode else ""


tried = 0
for name, module in sorted(modules.items()):
    command = next(entry for entry in commands
                   if pathlib.Path(entry["file"]).parent == module.folder)
    seen = reached(name, private=False)
    undeclared = [headers[other] for other in sorted(headers.keys() - seen)]
    tried += len(undeclared)
    lines = [f'#include "{headers[other]}"' for other in sorted(seen & headers.keys())]
    for header in undeclared:
        lines += [f'#if __has_include("{header}")', f'#error "finds {header}, which it does not declare"',
                  "#endif"]
    error = error_of(command, lines)
    if error:
        failures += 1
        print(f"{name}: {error}")
    if undeclared and "No such file" not in error_of(command, [f'#include "{undeclared[0]}"']):
        failures += 1
        print(f"{name} can include {undeclared[0]}, which it does not declare")

print(f"{len(modules)} modules, {tried} undeclared headers looked for, {failures} failures")
assert tried > 100
sys.exit(1 if failures else 0)

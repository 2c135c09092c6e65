#!/usr/bin/env python3
"""Draws mistakes at random in the sources of modules, and counts those that their tests find.

    Testing/random_mutants.py BUILD [--module NAME]... [--count 12] [--seed 1] [--long]

BUILD is a build folder of this tree with tests. Of each module, mistakes of four kinds are drawn by `--seed`:
relational (< for <=, ...), arithmetic (+ for -, ...), constant (1 for 0, ...) and a dropped statement. All of
them are compiled at once; the variable ISTHMUS_MUTANT chooses the one that acts. Those that no test of the module
reaches are not counted, nor those that mutants_equivalent.tsv lists with a reason. For each other one the module's quick tests run; where they pass, with --long the module's
other unit tests as well. Prints a table of the modules and the mistakes that no test found.

Refuses a tree with uncommitted changes, since it edits sources in place; it puts them back, also when a signal
terminates it (SIGKILL excepted). Mistakes that do not compile are dropped, and a test that takes ten times as
long as usual counts as failed.
"""
import argparse
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

import put_back

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADER = '''#ifndef isthmus_random_mutants
#define isthmus_random_mutants
#include <array>
#include <atomic>
#include <cstdio>
#include <cstdlib>
namespace isthmus_mutants
{
inline const int Active = std::getenv("ISTHMUS_MUTANT") ? std::atoi(std::getenv("ISTHMUS_MUTANT")) : 0;
inline std::array<std::atomic<bool>, 1000> Reached{};
inline bool Is(int mutant)
{
  if (Active < 0 && !Reached[static_cast<std::size_t>(mutant)].exchange(true))
  {
    if (std::FILE* file = std::fopen(std::getenv("ISTHMUS_MUTANT_TRACE"), "a"))
    {
      std::fprintf(file, "%d\\n", mutant);
      std::fclose(file);
    }
  }
  return mutant == Active;
}
}
#endif
'''

RELATIONS = {" < ": " <= ", " <= ": " < ", " > ": " >= ", " >= ": " > ", " == ": " != ", " != ": " == "}
SUMS = {" + ": " - ", " - ": " + ", " * ": " / ", " / ": " * "}
NUMBER = re.compile(r"(?<![\w.])(\d+\.\d+|\d+)(?![\w.'])")
# What a statement with a value begins with: `return`, an assignment or the definition of a variable.
VALUE = re.compile(r"\n +(?:return |(?:const )?(?:auto|double|float|int|bool|std::(?:size_t|int64_t)) \w+ = |[\w.>\-\[\]]+ [-+*/]?= )")
CONDITION = re.compile(r"\n +(?:else )?(?:if|while) \(")
CALL = re.compile(r"\n( +)((?:[\w.]|->|::)+\((?:[^;{}\"\[]|\n)*?\);)(?=\n)")
CHANGE = re.compile(r"\n( +)([\w.>\-\[\]]+ [-+*/]= [^;{}\"\[]*;|\+\+[\w.>\-]+;)(?=\n)")


def close(text, at):
    """The end of the parentheses that are open at `at`."""
    depth = 1
    while at < len(text):
        depth += {"(": 1, ")": -1}.get(text[at], 0)
        if depth == 0:
            return at
        at += 1
    return -1


def expressions(text):
    """Ranges of conditions, and of values up to the end of their statement; what is before a value."""
    for match in CONDITION.finditer(text):
        yield match.end(), close(text, match.end()), ""
    for match in VALUE.finditer(text):
        yield match.end(), text.find(";", match.end()), " ".join(match.group().split()) + " "


def changes_of(expression):
    """Kind and changed expression, one for each place where one can be changed."""
    for kind, table in (("relational", RELATIONS), ("arithmetic", SUMS)):
        for before, after in table.items():
            at = expression.find(before)
            while at >= 0:
                yield kind, expression[:at] + after + expression[at + len(before):]
                at = expression.find(before, at + 1)
    for match in NUMBER.finditer(expression):
        number = match.group()
        other = str(int(number) + 1) if number.isdigit() else "1.0" if float(number) == 0.0 else f"2.0 * {number}"
        yield "constant", expression[:match.start()] + other + expression[match.end():]


def mutants_of(path):
    """(kind, first and last character, changed text with {id}, what was changed) of a source."""
    text = path.read_text()
    begin = text.find("\nnamespace isthmus")
    for first, last, before in expressions(text):
        expression = text[first:last]
        unfit = re.search(r"[\[{\"]|//| = |nullptr|^\s*$", expression) or "constexpr" in text[text.rfind("\n", 0, first):first]
        if first < begin or last < 0 or unfit:
            continue
        for kind, changed in changes_of(expression):
            yield (kind, first, last, f"isthmus_mutants::Is({{id}}) ? ({changed}) : ({expression})",
                   f"{before}{' '.join(expression.split())}  ->  {' '.join(changed.split())}")
    for pattern in (CALL, CHANGE):
        for match in pattern.finditer(text):
            statement = match.group(2)
            if match.start() > begin and not re.match(r"(return|throw|delete|static_assert|EXPECT)\b", statement):
                yield ("dropped statement", match.start(2), match.end(2),
                       f"if (!isthmus_mutants::Is({{id}})) {{{{ {statement} }}}}".replace("{{", "{").replace("}}", "}"),
                       f"dropped: {' '.join(statement.split())}")


class Mutant:
    def __init__(self, number, path, kind, first, last, text, what):
        self.number, self.path, self.kind = number, path, kind
        self.first, self.last, self.what = first, last, what
        self.text = text.replace("{id}", str(number))
        self.line = path.read_text()[:first].count("\n") + 1

    def __str__(self):
        return f"{self.path.relative_to(ROOT)}:{self.line}: {self.kind}: {self.what}"


def draw(folder, count, chance):
    """`count` mutants of the sources of a folder, of each kind alike, no two of them at the same place."""
    found = {}
    for path in sorted(folder.glob("*.cxx")):
        if not path.name.startswith("vtk"):
            for mutant in mutants_of(path):
                found.setdefault(mutant[0], []).append((path, *mutant))
    for kind in found.values():
        chance.shuffle(kind)
    drawn = []
    while len(drawn) < count and any(found.values()):
        for kind in sorted(found):
            while found[kind] and len(drawn) < count:
                path, name, first, last, text, what = found[kind].pop()
                if all(m.path != path or m.last < first or last < m.first for m in drawn):
                    drawn.append(Mutant(len(drawn) + 1, path, name, first, last, text, what))
                    break
    return drawn


def write(mutants):
    """Writes mutants into the sources, on the lines on which they were."""
    for path in {m.path for m in mutants}:
        text = path.read_text()
        for m in sorted((m for m in mutants if m.path == path), key=lambda m: -m.first):
            lines = text[m.first:m.last].count("\n")
            changed = m.text.replace("\n", " ") + "\n" * lines
            text = text[:m.first] + changed + text[m.last:]
        path.write_text(HEADER + "#line 1\n" + text)


def restore():
    with put_back.uninterrupted():
        subprocess.run(["git", "checkout", "-q", "--", "Filters", "Readers"], cwd=ROOT, check=True)


def build(folder, targets, mutants):
    """Compiles, and drops the mutants that do not."""
    while mutants:
        write(mutants)
        done = put_back.run(["ninja", "-k", "0", "-C", folder, *targets], stdout=subprocess.PIPE, text=True,
                            stderr=subprocess.DEVNULL)
        if done.returncode == 0:
            return mutants
        wrong = set(re.findall(r"(\w+\.cxx):(\d+):\d+: error", done.stdout))
        left = [m for m in mutants if not any(
            m.path.name == name and m.line <= int(line) <= m.line + m.text.count("\n") + 3 for name, line in wrong)]
        if len(left) == len(mutants):
            print(done.stdout[-3000:])
            sys.exit("the sources with mutants do not compile, and no mutant is on the lines of the errors")
        restore()
        mutants = left
    return mutants


def run_tests(folder, chosen, mutant, trace=None, seconds=None):
    """Whether all tests pass with a mutant, and the time they take."""
    environment = dict(os.environ, ISTHMUS_MUTANT=str(mutant), ISTHMUS_MUTANT_TRACE=str(trace or os.devnull),
                       ISTHMUS_REQUIRE_DATA="1")
    limit = ["--timeout", str(seconds)] if seconds else []
    start = time.monotonic()
    stop = [] if trace else ["--stop-on-failure"]
    done = put_back.run(["ctest", "-I", str(chosen), "-j", "2", "-Q", *limit, *stop], cwd=folder,
                        env=environment, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    return done.returncode == 0, time.monotonic() - start


def numbers_in(chosen):
    """The numbers of tests in a file for `ctest -I`."""
    return set(chosen.read_text().strip().split(",")[3:])


def choose(folder, module, quick, to):
    """The numbers of a module's unit tests, for ctest."""
    put_back.run([sys.executable, "-B", str(ROOT / "Testing/select_tests.py"), folder, "--module", module,
                  *(["--quick"] if quick else []), "--write", str(to)], stdout=subprocess.DEVNULL).check_returncode()
    if not quick:
        # Not `-I` together with `-L`: with a label, ctest takes the numbers of -I as those among the labelled tests.
        listed = put_back.run(["ctest", "-N", "-L", "unit"], cwd=folder, stdout=subprocess.PIPE, text=True)
        unit = set(re.findall(r"Test +#(\d+)", listed.stdout))
        to.write_text("0,0,0," + ",".join(sorted(numbers_in(to) & unit, key=int)) + "\n")


def equivalent():
    """(file, change) of the mistakes that change no result, from mutants_equivalent.tsv."""
    lines = (ROOT / "Testing/mutants_equivalent.tsv").read_text().splitlines()
    return {tuple(line.split("\t")[:2]) for line in lines if line and not line.startswith("#")}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("--module", action="append")
    parser.add_argument("--count", type=int, default=12)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--long", action="store_true")
    options = parser.parse_args()
    if subprocess.run(["git", "status", "--porcelain", "Filters", "Readers"], cwd=ROOT, capture_output=True).stdout:
        sys.exit("the tree has uncommitted changes: commit them first, since sources are edited in place")
    modules = options.module or sorted(path.parent.name for path in ROOT.glob("*/*/vtk.module"))
    put_back.end_by_exception()
    rows = []
    known = equivalent()
    with tempfile.TemporaryDirectory() as scratch:
        quick, every, trace = (pathlib.Path(scratch) / name for name in ("quick", "every", "trace"))
        for module in modules:
            folder = next(ROOT / group / module for group in ("Filters", "Readers") if (ROOT / group / module).is_dir())
            mutants = draw(folder, options.count, random.Random(f"{options.seed} {module}"))
            try:
                mutants = build(options.build, [f"unit_tests_{module}"], mutants)
                choose(options.build, module, True, quick)
                choose(options.build, module, False, every)
                assert numbers_in(quick) <= numbers_in(every), "the quick tests are not among the module's unit tests"
                trace.write_text("")
                _, whole = run_tests(options.build, every if options.long else quick, -1, trace)
                reached = set(map(int, trace.read_text().split()))
                passed, usual = run_tests(options.build, quick, 0)
                assert passed, f"the quick tests of {module} fail without a mutant"
                counted = [m for m in mutants if m.number in reached
                           and (str(m.path.relative_to(ROOT)), m.what) not in known]
                survivors, missed = [], []
                for m in counted:
                    if run_tests(options.build, quick, m.number, seconds=int(10 + 10 * usual))[0]:
                        survivors.append(m)
                for m in survivors:
                    if not options.long or run_tests(options.build, every, m.number, seconds=int(600 + 10 * whole))[0]:
                        missed.append(m)
            finally:
                restore()
            rows.append((module, len(counted), len(counted) - len(survivors), len(counted) - len(missed)))
            print(f"{module}: {len(mutants)} compiled, {len(counted)} reached, quick tests ({usual:.0f} s) found "
                  f"{rows[-1][2]}" + (f", all unit tests {rows[-1][3]}" if options.long else ""))
            for m in missed:
                print(f"  not found: {m}")
            sys.stdout.flush()
    print("| module | mutants | found by quick tests | found by all unit tests |\n|---|---|---|---|")
    for row in rows + [("all", *(sum(column) for column in list(zip(*rows))[1:]))]:
        print("| " + " | ".join(map(str, row)) + " |")


if __name__ == "__main__":
    main()

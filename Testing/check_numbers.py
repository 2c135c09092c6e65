#!/usr/bin/env python3
"""Checks that numbers become text, and text numbers, without the locale of the program.

    check_numbers.py [ROOT]

Hosts of the library may set a locale in which numbers have commas and separators; functions of C
follow setlocale, streams std::locale::global. Of the library and the plugin (Filters, Readers,
Plugin) it therefore reports

- calls of the printf, scanf and strtod families, std::stod and the like, and streams of strings;
- messages of VTK (vtkWarningMacro, ...) to which more than one part is streamed: one text made by
  isthmus::TextOf has the numbers in it.

Filters/Core/NumberText.h has what to use instead. Which libraries call std::to_string of a floating
point number, which no text search finds, is tested by Testing/Integration/TestLocales.cxx.

Prints one line per error; the exit status is 1 if there are any.
"""
import pathlib
import re
import sys

NOT_CODE = re.compile(r'//[^\n]*|/\*.*?\*/|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])+\'', re.DOTALL)
FORBIDDEN = re.compile(r"\b(v?[sfd]?n?printf|v?[sf]?scanf|strto(?:d|f|ld)|wcsto(?:d|f|ld)|ato[fil]|atoll"
                       r"|std::sto(?:d|f|ld|i|l|ll|ul|ull)|w?[io]?stringstream|istrstream|ostrstream"
                       r"|vtkV?LogF|setprecision)\b")
MESSAGE = re.compile(r"\bvtk(?:\w*(?:Error|Warning|Debug)(?:WithObject)?Macro|V?Log(?:If)?)\s*(?=\()")


def call_at(code, begin):
    """The arguments of the call whose bracket opens at `begin`."""
    depth = 0
    for i in range(begin, len(code)):
        depth += {"(": 1, ")": -1}.get(code[i], 0)
        if depth == 0:
            return code[begin:i + 1]
    return code[begin:]


def check(root):
    errors = []
    for folder in ("Filters", "Readers", "Plugin"):
        for path in sorted((root / folder).rglob("*")):
            if path.suffix not in (".h", ".cxx", ".txx"):
                continue
            code = NOT_CODE.sub(lambda found: '""' + "\n" * found.group().count("\n"), path.read_text())

            def complain(at, words):
                line = code.count("\n", 0, at) + 1
                errors.append(f"{path.relative_to(root)}:{line}: {words}")

            for found in FORBIDDEN.finditer(code):
                complain(found.start(), f"{found.group()} follows the locale of the program: use Core/NumberText.h.")
            for found in MESSAGE.finditer(code):
                if call_at(code, found.end()).count("<<") > 1:
                    complain(found.start(), "numbers streamed to a message follow the locale of the program: "
                             "make one text of the parts by isthmus::TextOf.")
    return errors


def main():
    root = pathlib.Path(sys.argv[1]) if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent
    errors = check(root)
    print(*errors, sep="\n", end="\n" if errors else "")
    return 1 if errors else 0


if __name__ == "__main__":
    sys.exit(main())

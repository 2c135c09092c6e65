"""Every filter gives the same numbers and messages in a host that writes numbers "1.234,5".

Each runs on sound inputs, and then with each property of one number far out of its range, so that
it complains; in forked children without a locale, and with de_DE.UTF-8 as Python's setlocale and
C++'s std::locale::global set it.
"""

import ctypes
import json
import locale
import os
import re
import subprocess
import sys
import tempfile

import robustness_trials
from good_data import filters, kinds, made

NAME = "de_DE.UTF-8"


def compile_locale(folder):
    """de_DE.UTF-8 of the system's sources; where there are none, one of German numbers only."""
    target = os.path.join(folder, NAME)
    numbers = os.path.join(folder, "numbers")
    with open(numbers, "w", encoding="ascii") as source:
        source.write('LC_NUMERIC\ndecimal_point ","\nthousands_sep "."\ngrouping 3;3\nEND LC_NUMERIC\n')
    for words in (["-i", "de_DE", "-f", "UTF-8"], ["-i", numbers]):
        # The exit status is 1 for warnings as well.
        subprocess.run(["localedef", "--no-archive", "-c", *words, target],
                       stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False)
        if os.path.exists(os.path.join(target, "LC_NUMERIC")):
            return True
    return False


def set_german():
    """As a host would: for functions of C and for the streams of C++."""
    library = ctypes.CDLL("libstdc++.so.6")
    german, before = (ctypes.create_string_buffer(64) for _ in range(2))
    library._ZNSt6localeC1EPKc(german, NAME.encode())  # std::locale::locale(const char*)
    library._ZNSt6locale6globalERKS_(before, german)  # std::locale::global(const std::locale&)
    locale.setlocale(locale.LC_NUMERIC, NAME)
    assert locale.localeconv()["decimal_point"] == ","


def numbers_of(proxy):
    """Properties of one real number."""
    found = []
    for name in proxy.ListProperties():
        vector = proxy.SMProxy.GetProperty(name)
        if vector and vector.GetClassName() == "vtkSMDoubleVectorProperty" and vector.GetCommand() \
                and not vector.GetInformationOnly() and vector.GetNumberOfElements() == 1:
            found.append((vector, vector.GetElement(0)))
    return found


def trial(name, kind, german):
    proxy = made(name, kind)
    algorithm = proxy.GetClientSideObject()
    said = robustness_trials.Listener(algorithm)
    if german:
        set_german()  # ParaView itself makes no proxies in such a locale of C++
    result = []

    def update():
        proxy.SMProxy.UpdateVTKObjects()
        proxy.SMProxy.UpdatePipeline()
        result.append([robustness_trials.print_of(algorithm.GetOutputDataObject(port))
                       for port in range(algorithm.GetNumberOfOutputPorts())])

    update()
    for vector, value in numbers_of(proxy):
        vector.SetElement(0, -1234.5)
        update()
        vector.SetElement(0, value)
    messages = re.sub(r"\(0x[0-9a-f.]+\)|line [\d.]+", "", "\n".join(said.errors + said.warnings))
    return json.dumps([result, messages])


with tempfile.TemporaryDirectory() as folder:
    if not compile_locale(folder):
        print("localedef makes no German locale")
        sys.exit(1 if os.environ.get("ISTHMUS_REQUIRE_DATA") == "1" else 77)
    os.environ["LOCPATH"] = folder
    wrong, complaints = [], 0
    for filter_name in filters():
        for input_kind in kinds(filter_name)[:1]:
            plain, german = (robustness_trials.run(lambda: trial(filter_name, input_kind, is_german), seconds=60)
                             for is_german in (False, True))
            if (plain[0], german[0]) != ("done", "done"):
                wrong += [f"{filter_name}: {word}, {said[-800:]}" for word, said, _ in (plain, german) if word != "done"]
                continue
            (numbers, messages), (german_numbers, german_messages) = json.loads(plain[1]), json.loads(german[1])
            complaints += messages.count("-1234.5")
            if numbers != german_numbers:
                wrong.append(f"{filter_name}: other numbers")
            if messages != german_messages:
                lines = zip(messages.splitlines(), german_messages.splitlines())
                wrong.append(f"{filter_name}: " + next((f"{a} | {b}" for a, b in lines if a != b), "fewer messages"))
    print(*wrong, f"{len(filters())} filters, {complaints} messages with the number", sep="\n")
    assert complaints > len(filters()), "the messages do not name the number"
    assert not wrong

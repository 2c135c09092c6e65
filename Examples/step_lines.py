"""One line for each step of an example on standard error: its name, its time and what it found."""

import contextlib
import re
import sys
import time


def plain(text):
    """A message of VTK without source file, line, class and address."""
    return " ".join(re.sub(r"^.*?\): ", "", text, count=1, flags=re.DOTALL).split())


class Step:
    """The text of a step's line, and the warnings and errors of its filters, which VTK would print as lines of its log.
    """

    def __init__(self, name):
        self.name, self.facts, self._messages, self._watched = name, [], [], []

    def watch(self, proxy):
        algorithm = proxy.GetClientSideObject()
        for subject in (algorithm, algorithm.GetExecutive()):
            for kind in ("Warning", "Error"):
                self._watched.append((subject, subject.AddObserver(f"{kind}Event", self._collector(proxy, kind))))

    def _collector(self, proxy, kind):
        def collect(_, __, text):
            self._messages.append((proxy, kind, plain(text)))
        collect.CallDataType = "string0"
        return collect

    def take_warnings(self, proxy, text=None):
        """The warnings of `proxy`, or those with that text. These are not printed later: use it for
        a step whose line contains the same information."""
        taken = [message for message in self._messages
                 if message[:2] == (proxy, "Warning") and text in (None, message[2])]
        self._messages = [message for message in self._messages if message not in taken]
        return [text for _, _, text in taken]

    def end(self, seconds=None):
        """Prints the line unless the step has failed, and below it each remaining message."""
        for subject, tag in self._watched:
            subject.RemoveObserver(tag)
        lines = [] if seconds is None else [", ".join([f"{self.name}: {seconds:.1f} s", *self.facts])]
        lines += [f"{kind} of {proxy.SMProxy.GetXMLLabel()}: {text}" for proxy, kind, text in self._messages]
        print(*lines, sep="\n", end="\n" if lines else "", file=sys.stderr, flush=True)


@contextlib.contextmanager
def step(name, *filters):
    """Runs a step that executes the proxies `filters`; yields its Step."""
    made, seconds = Step(name), None
    for proxy in filters:
        made.watch(proxy)
    began = time.monotonic()
    try:
        yield made
        seconds = time.monotonic() - began
    finally:
        made.end(seconds)

"""For scripts that edit sources in place: what they put back in `finally` is put back when they are terminated, too."""
import contextlib
import os
import signal
import subprocess
import sys

SIGNALS = [number for number in (signal.SIGTERM, signal.SIGHUP, signal.SIGINT)
           if signal.getsignal(number) != signal.SIG_IGN] # nohup has SIGHUP ignored


def end(number, _):
    for each in SIGNALS:
        signal.signal(each, signal.SIG_IGN)
    sys.exit(128 + number)


def end_by_exception():
    """From now on signals that end a process raise SystemExit, the first one of them only."""
    for number in SIGNALS:
        signal.signal(number, end)


@contextlib.contextmanager
def uninterrupted():
    """Signals wait until the block has ended, in what it starts as well."""
    before = signal.pthread_sigmask(signal.SIG_BLOCK, SIGNALS)
    try:
        yield
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, before)


def run(command, timeout=None, **options):
    """subprocess.run(); if it is interrupted, all processes that the command has started are ended."""
    with subprocess.Popen(command, start_new_session=True, **options) as child:
        try:
            said = child.communicate(timeout=timeout)
        except BaseException:
            os.killpg(child.pid, signal.SIGTERM) # ninja stops its compilers itself: they are in groups of their own
            raise
    return subprocess.CompletedProcess(command, child.returncode, *said)

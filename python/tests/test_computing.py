"""Computations leave Python free, stop when it is interrupted, and never take it down."""

from __future__ import annotations

import multiprocessing
import os
import signal
import subprocess
import sys
import threading
from concurrent.futures import ThreadPoolExecutor
from typing import Any, Callable

import pytest

import fem
from fem import _fem

# Runs in an interpreter of its own: whoever computes endlessly unless stopped would hang the tests.
INTERRUPTED = """
import os, signal, threading
from fem import _fem

# A thread that runs while the other one computes: the GIL is free.
threading.Timer(0.3, os.kill, (os.getpid(), signal.SIGINT)).start()
try:
    _fem.rehearse(False)
except KeyboardInterrupt:
    print("interrupted")
"""

HANDLER = """
import signal
before = signal.getsignal(signal.SIGINT)
import fem
model, measured = fem.demo()
model.compare(measured)
assert signal.getsignal(signal.SIGINT) is before
signal.raise_signal(signal.SIGINT)
"""


def python(text: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run([sys.executable, "-c", text], capture_output=True, text=True, timeout=120, check=False)


def test_ctrl_c_stops_a_computation() -> None:
    told = python(INTERRUPTED)
    assert (told.returncode, told.stdout) == (0, "interrupted\n"), told.stderr


def test_handlers_of_signals_stay_as_they_were() -> None:
    told = python(HANDLER)
    assert "KeyboardInterrupt" in told.stderr and told.returncode in (1, 130, -signal.SIGINT)


def test_whatever_a_handler_raises_arrives() -> None:
    class Alarm(Exception):
        pass

    def ring(*_: object) -> None:
        raise Alarm

    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.3)
        with pytest.raises(Alarm):
            _fem.rehearse(False)
    finally:
        signal.signal(signal.SIGALRM, before)


def test_a_stopped_search_ends_and_the_next_one_is_whole(rigid: fem.Model, measured: dict[str, Any]) -> None:
    class Alarm(Exception):
        pass

    def ring(*_: object) -> None:
        raise Alarm

    whole = rigid.diagnose(measured).text
    before = signal.signal(signal.SIGALRM, ring)
    try:
        signal.setitimer(signal.ITIMER_REAL, 0.05)
        with pytest.raises(Alarm):
            while True:
                rigid.diagnose(measured)
    finally:
        signal.signal(signal.SIGALRM, before)
    assert rigid.diagnose(measured).text == whole


def test_a_fault_is_an_exception(rigid: fem.Model) -> None:
    with pytest.raises(fem.Fault, match="a rehearsal") as caught:
        _fem.rehearse(True)
    assert isinstance(caught.value, Exception) and "report it" in str(caught.value)
    assert rigid.run().findings.largest.value > 0


def test_threads_compute_side_by_side(rigid: fem.Model, measured: dict[str, Any]) -> None:
    alone = rigid.compare(measured).rms
    with ThreadPoolExecutor(4) as pool:
        assert set(pool.map(lambda _: rigid.compare(measured).rms, range(8))) == {alone}


def largest(model: fem.Model) -> float:
    return float(model.run().findings.largest.value)


@pytest.mark.parametrize("method", ["fork", "spawn"])
def test_other_processes_compute_too(method: str, rigid: fem.Model) -> None:
    alone = largest(rigid)
    with multiprocessing.get_context(method).Pool(2) as pool:
        assert pool.map_async(largest, [rigid] * 4).get(timeout=120) == [alone] * 4


def test_a_thread_beside_the_main_one_goes_on(rigid: fem.Model) -> None:
    steps: list[int] = []
    computing = threading.Event()

    def step() -> None:
        computing.wait()
        steps.append(1)
        os.kill(os.getpid(), signal.SIGALRM)

    def ring(*_: object) -> None:
        raise InterruptedError

    before: Callable[..., Any] | int | None = signal.signal(signal.SIGALRM, ring)
    other = threading.Thread(target=step)
    other.start()
    try:
        with pytest.raises(InterruptedError):
            computing.set()
            _fem.rehearse(False)
    finally:
        signal.signal(signal.SIGALRM, before)
        other.join()
    assert steps == [1]

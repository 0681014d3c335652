"""Compiling and executing programs, and starting up.

Run with `make bench`; figures go into docs/explanation/performance.md.
"""

import subprocess
import sys
from typing import Any

import pytest
from measuring import Measure, processor_seconds

import ropsim

UNIT = """\
task T{k}(a1: loc, a2: loc, dz: length = {k} mm)
  set speed 250 mm/s
  x = dz * 3 - 20 mm / 2
  repeat 3
    mov a1 above dz
    lin (100, {k}, 300; rpy 180 0 10) speed 150 mm/s acc 2 m/s2
    if x > 40 mm then x = x - 1 mm
  endr
  lin a2 rel (0, 0, -10 mm)
endp

T{k} (400, 0, {k}), (300, 100, 200)
"""


def program_of(lines: int) -> str:
    """Return a program of about `lines` lines."""
    head = "program large\nunits mm, deg\n"
    return head + "\n".join(UNIT.format(k=k + 1) for k in range(lines // UNIT.count("\n")))


def test_compile_10k_lines(benchmark: Any) -> None:
    measure = Measure(benchmark)
    text = program_of(10_000)
    compiled, time = measure(lambda: ropsim.language.compile(text))
    assert compiled.diagnostics == ()
    measure.figure("lines per second", text.count("\n") / time.median)


FLAT = """\
x{k} = {k} mm * 3 - 20 mm / 2
lin (100, {k}, 300; rpy 180 0 10) speed 150 mm/s acc 2 m/s2
if x{k} > 40 mm then print x{k}
mov (400, 0, x{k})
"""


def flat_program_of(lines: int) -> str:
    """Return a program of about `lines` lines without tasks."""
    head = "program large\nunits mm, deg\n"
    return head + "".join(FLAT.format(k=k + 1) for k in range(lines // FLAT.count("\n")))


def processor_time_of_edits(text: str, rounds: int = 5) -> tuple[float, float]:
    """Return the least processor seconds of compiling a text anew, and after an edit in its middle."""
    cache = ropsim.language.LineCache()
    lines = text.split("\n")
    place = next(k for k in range(len(lines) // 2, len(lines)) if "lin (100" in lines[k])
    ropsim.language.compile(text, cache=cache)
    first, second = lines[place], lines[place].replace("300", "301")

    def edited() -> None:
        lines[place] = second if lines[place] == first else first
        assert ropsim.language.compile("\n".join(lines), cache=cache).ok

    anew, after = processor_seconds(lambda: ropsim.language.compile(text), edited, rounds=rounds)
    return anew, after


@pytest.mark.parametrize("kind", ["of tasks", "flat"])
def test_edits_of_10k_lines(benchmark: Any, kind: str) -> None:
    measure = Measure(benchmark)
    text = program_of(10_000) if kind == "of tasks" else flat_program_of(10_000)
    (anew, after), _ = measure(lambda: processor_time_of_edits(text), rounds=1, warmup=0)
    measure.figure("seconds anew", anew)
    measure.figure("seconds after an edit", after)
    measure.figure("part of the work that an edit costs", after / anew, most=0.05)


LOOP = """\
ICR 1.0 loop
VAR i INT
VAR x REAL
PROC main
  PUSH INT 0
  STORE i
  PUSH REAL 0.0
  STORE x
L0:
  LOAD i
  PUSH INT 100000
  LT.I
  JF L1
  LOAD x
  PUSH REAL 0.5
  ADD.R
  STORE x
  LOAD i
  PUSH INT 1
  ADD.I
  STORE i
  JMP L0
L1:
  HALT
END
"""


def test_icr_instructions(benchmark: Any) -> None:
    measure = Measure(benchmark)
    program = ropsim.icr.assemble(LOOP)
    trace, time = measure(lambda: ropsim.icr.run(program))
    assert trace.trap is None
    measure.figure("instructions per second", trace.steps / time.median)


def start_up() -> None:
    subprocess.run([sys.executable, "-m", "ropsim", "--version"], check=True, stdout=subprocess.DEVNULL)


def test_start_up_of_version(benchmark: Any) -> None:
    measure = Measure(benchmark)
    _, time = measure(start_up, rounds=10)
    measure.figure("seconds", time.median)

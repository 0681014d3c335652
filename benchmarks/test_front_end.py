"""Compiling and executing programs, and starting up.

Run with `make bench`; figures go into docs/explanation/performance.md.
"""

import subprocess
import sys

from pytest_benchmark.fixture import BenchmarkFixture

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


def test_compile_10k_lines(benchmark: BenchmarkFixture) -> None:
    text = program_of(10_000)
    compiled = benchmark.pedantic(ropsim.language.compile, (text,), rounds=5, warmup_rounds=1)
    assert compiled.diagnostics == ()
    lines = text.count("\n")
    benchmark.extra_info["lines_per_second"] = round(lines / benchmark.stats.stats.median)


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


def test_icr_instructions(benchmark: BenchmarkFixture) -> None:
    program = ropsim.icr.assemble(LOOP)
    trace = benchmark.pedantic(ropsim.icr.run, (program,), rounds=5, warmup_rounds=1)
    assert trace.trap is None
    benchmark.extra_info["instructions_per_second"] = round(trace.steps / benchmark.stats.stats.median)


def start_up() -> None:
    subprocess.run([sys.executable, "-m", "ropsim", "--version"], check=True, stdout=subprocess.DEVNULL)


def test_start_up_of_version(benchmark: BenchmarkFixture) -> None:
    benchmark.pedantic(start_up, rounds=10, warmup_rounds=1)

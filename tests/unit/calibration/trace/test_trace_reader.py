"""Traces are read in the forms that loggers write, and mistakes are told by their line."""

import math
from collections.abc import Callable

import numpy as np
import pytest

from ropsim import robots
from ropsim.calibration import Trace, read_trace
from ropsim.core import Diagnostic

ARM = robots.load("two_link").axis_joints
TITLES = "time [s],j1 [deg],j2 [deg]"


def rows(count: int = 40, separator: str = ",") -> list[str]:
    return [separator.join(f"{value:.3f}" for value in (k * 0.01, k * 0.5, -k)) for k in range(count)]


def text(*lines: str) -> bytes:
    return "\n".join(lines).encode()


def read(content: bytes) -> Trace:
    trace, findings = read_trace(content, ARM, "t.csv")
    assert trace is not None, findings
    return trace


def refused(content: bytes) -> Diagnostic:
    trace, findings = read_trace(content, ARM, "t.csv")
    assert trace is None
    assert findings[0].code == "X888"
    return findings[0]


def test_a_table_is_read_in_si_units() -> None:
    trace = read(text(TITLES, *rows()))
    assert trace.q.shape == (40, 2)
    assert trace.period == pytest.approx(0.01)
    assert trace.q[10] == pytest.approx([math.radians(5.0), math.radians(-10.0)])


@pytest.mark.parametrize(
    "form",
    [
        lambda one: b"\xef\xbb\xbf" + one,
        lambda one: one.replace(b"\n", b"\r\n"),
        lambda one: one.replace(b"\n", b"\r"),
        lambda one: one.replace(b",", b";"),
        lambda one: one.replace(b",", b"\t"),
        lambda one: one.replace(b",", b";").replace(b".", b","),
        lambda one: one.replace(b",", b"\t").replace(b".", b","),
        lambda one: one.decode().encode("utf-16"),
        lambda one: b"# logged today\n\n" + one + b"\n\n",
        lambda one: one.replace(b"time [s]", b'"Time [s]"'),
        lambda one: one.replace(b"j1 [deg]", b"Joint 1 position [\xc2\xb0]"),
        lambda one: one.replace(b"j1 [deg]", b"q1(\xb0)"),
        lambda one: one.split(b"\n", 1)[1],
    ],
)
def test_every_form_of_a_table_gives_the_same_trace(form: Callable[[bytes], bytes]) -> None:
    plain = text(TITLES, *rows())
    assert read(form(plain)) == read(plain)


def test_units_of_the_header_hold() -> None:
    turned = [",".join(map(str, (k * 10, math.radians(-k), math.radians(k * 0.5)))) for k in range(40)]
    trace = read(text("t [ms],j2 [rad],j1 [rad]", *turned))
    assert trace.time == pytest.approx(read(text(TITLES, *rows())).time)
    assert trace.q == pytest.approx(read(text(TITLES, *rows())).q)


def test_sliding_axes_are_millimetres() -> None:
    arm = robots.load("scara").axis_joints
    names = [one.name for one in arm]
    lines = [",".join(map(str, (k * 0.01, k, 0, k, 0))) for k in range(40)]
    trace, _ = read_trace(text("time," + ",".join(names), *lines), arm, "t.csv")
    assert trace is not None
    sliding = [k for k, one in enumerate(arm) if one.measure.value == "prismatic"]
    assert sliding == [2]
    assert trace.q[10, 2] == pytest.approx(0.01)


def test_lines_without_a_value_are_left_out_and_counted() -> None:
    lines = rows(60)
    lines[20], lines[30], lines[59] = "0.200,,1", "0.300,nan,1", "0.590,3"
    trace, findings = read_trace(text(TITLES, *lines), ARM, "t.csv")
    assert trace is not None
    assert len(trace.time) == 57
    assert [(one.code, one.data["lines"]) for one in findings] == [("X898", 3)]


@pytest.mark.parametrize(
    ("content", "said", "line"),
    [
        (b"", "0 samples", 0),
        (text(TITLES), "0 samples", 0),
        (text(TITLES, *rows(19)), "19 samples", 0),
        (text(TITLES, *rows(30), *rows(2)), "must rise", 32),
        (text(TITLES, *rows(30), rows(30)[-1]), "must rise", 32),
        (text("time,j1,j2,j3", *(f"{one},0" for one in rows())), "3 columns of joints", 1),
        (text(*(f"{one},0" for one in rows())), "3 columns of joints", 1),
        (text("a,j1,j2", *rows()), "no column `time`", 1),
        (text("time [h],j1,j2", *rows()), "unit `h`", 1),
        (text("time,j1 [mm],j2", *rows()), "unit `mm`", 1),
        (text(TITLES, *rows(), "0.5,one,2"), "no number", 42),
        (
            text(TITLES, *(one.replace(",", ",x", 1) if k == 3 else one for k, one in enumerate(rows()))),
            "x1",
            5,
        ),
        (text("time [ms],j1,j2", *rows()), "samples per second", 0),
        (text(TITLES, *("0.1,,1" for _ in range(30)), *rows()), "lack a value", 0),
        (text(TITLES, *rows(), "0.9,1e9,0"), "which no joint is", 42),
        (b"\0\1\2\x80" * 50, "no text", 0),
        (b"\x89PNG\r\n\x1a\n\x81\x8d" * 9, "no text", 0),
        (text("time," * 1200), "columns", 1),
    ],
)
def test_a_mistake_is_told_by_its_line(content: bytes, said: str, line: int) -> None:
    found = refused(content)
    assert said in found.message
    assert (found.span.line if found.span else 0) == line


def test_a_trace_begins_at_time_zero() -> None:
    late = [f"{1.7e9 + k * 0.01:.3f},0,{k}" for k in range(40)]
    trace = read(text(TITLES, *late))
    assert trace.time[0] == 0.0
    assert np.diff(trace.time) == pytest.approx(0.01, abs=1e-5)

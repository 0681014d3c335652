"""Responses and margins of loops as records of an HTML page."""

import math
from collections.abc import Sequence

import numpy as np

from ropsim.cli.terminal.response_text import (
    Rest,
    Table,
    TestedAxis,
    conditions,
    in_time,
    margins_table,
    notes,
    slow_table,
)
from ropsim.model import JointType
from ropsim.simulation import TimeResponse
from ropsim.views import LoopPage, LoopTable, SineCurves, TimeCurves

_COORDINATES = {JointType.REVOLUTE: (math.degrees(1.0), "°"), JointType.PRISMATIC: (1e3, "mm")}
_EFFORTS = {JointType.REVOLUTE: "N·m", JointType.PRISMATIC: "N"}
_LOWEST = 0.1
"""Frequency at which curves begin [Hz]."""


def response_records(rest: Rest, tested: Sequence[TestedAxis]) -> LoopPage:
    """Return the page of a station at rest, as records."""
    tables = [
        _table("Margins of each loop about the rest, all others closed.", margins_table(rest, tested)),
        _table("The same in the slow motion in which they are the worst.", slow_table(rest, tested)),
    ]
    if any(one.response for one in tested):
        what = (
            "Answers to a ramp of the reference." if rest.is_ramp else "Answers to a step of the reference."
        )
        tables.insert(0, _table(what, in_time(rest, tested)))
    return LoopPage(
        rest.robot.title or rest.robot.name,
        conditions(rest),
        tuple(tables),
        tuple(_times(rest, one.axis, one.response) for one in tested if one.response is not None),
        tuple(_sines(rest, one) for one in tested if one.margins.stable),
        tuple(f"{one[0].upper()}{one[1:]}." for one in notes(rest)),
    )


def _table(caption: str, found: Table) -> LoopTable:
    header, rows = found
    return LoopTable(caption, header, tuple(tuple(cell.text for cell in row) for row in rows))


def _times(rest: Rest, axis: int, response: TimeResponse) -> TimeCurves:
    joint = rest.robot.axis_joints[axis]
    scale, unit = _COORDINATES[joint.measure]
    return TimeCurves(
        joint.name,
        unit,
        response.time,
        response.reference * scale,
        response.moved * scale,
        _EFFORTS[joint.measure],
        response.effort,
    )


def _sines(rest: Rest, one: TestedAxis) -> SineCurves:
    found = one.sines
    shown = found.hz >= _LOWEST
    if one.sweep is not None:
        shown &= (found.hz >= one.sweep.hz[0]) & (found.hz <= one.sweep.hz[-1])
    name = rest.robot.axis_joints[one.axis].name
    gain, phase = 20.0 * np.log10(found.gain[shown]), np.degrees(found.phase[shown])
    return SineCurves(name, found.hz[shown], gain, phase)

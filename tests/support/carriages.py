"""Bodies on two crossed slides or on a turntable, which a test leads past each other row by row."""

from collections.abc import Sequence
from dataclasses import replace
from functools import cache
from typing import Any

import numpy as np

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import Channel, ChannelGroup, Event, Fidelity, Recording, RunFacts, StationFacts
from ropsim.model import Cell, Shape
from ropsim.spatial import Array

RATE = 250.0
"""Rows per second [Hz]."""
SOURCE = SourceText("across.task", "mov joints(0)\n" * 9)

_SLIDE = """
[stations.{name}]
base = {{ position = [0, 0, 0], rpy = [0, 0, {turn}] }}
[stations.{name}.mechanism]
kind = "slide"
low = -9000
high = 9000
size = [1, 1, 1]
mass = 1
speed = 1000
acceleration = 1000
"""
_TABLE = """
[stations.table]
[stations.table.mechanism]
kind = "turntable"
low = -720
high = 720
size = [1, 1, 1]
inertia = 1
speed = 90
acceleration = 90
"""


def crossed(across: Sequence[Shape], along: Sequence[Shape] = (), **around: Any) -> Cell:
    """Return a cell with two carriages: `across` goes along x of the world, `along` along y.

    The cell lists them against the alphabet, by which findings order two that move.

    Args:
        across: what the one carries, in its frame, whose z is x of the world and whose y is y.
        along: what the other one carries, in its frame, whose z is y of the world and whose y is -x.
        around: further arguments of `Cell`.
    """
    text = _SLIDE.format(name="along", turn=90) + _SLIDE.format(name="across", turn=0)
    return _carrying(text, {"across": across, "along": along}, around)


def turning(table: Sequence[Shape], **around: Any) -> Cell:
    """Return a cell with a turntable, `table`, about z of the world.

    Args:
        table: what it carries, in its frame, which is the world frame at coordinate 0.
        around: further arguments of `Cell`.
    """
    return _carrying(_TABLE, {"table": table}, around)


def led(
    cell: Cell,
    ways: dict[str, Array],
    *,
    lines: tuple[Sequence[float], Sequence[int]] = ((0.0,), (0,)),
    events: tuple[Event, ...] = (),
) -> Recording:
    """Return a recording of a cell whose mechanisms are led row by row.

    Args:
        cell: whose.
        ways: coordinates of each mechanism by rows [m | rad], shape (k,).
        lines: when the line of the stations changed [s], and to which.
        events: of the run.
    """
    (count,) = {len(one) for one in ways.values()}
    channels = {
        f"{name}/q": Channel(way[:, np.newaxis], "m", ("E1",), "", ChannelGroup.JOINTS, name)
        for name, way in ways.items()
    }
    times, numbers = (np.array(one, dtype=np.float64) for one in lines)
    channels |= {
        f"{name}/line": Channel(numbers, "", (), "", ChannelGroup.PROGRAM, name, times) for name in ways
    }
    stations = tuple(StationFacts(name, source=SOURCE.name) for name in cell.stations)
    facts = RunFacts(fidelity=Fidelity.KINEMATIC, record_hz=RATE, stations=stations)
    return Recording(np.arange(count) / RATE, channels, events, (), count / RATE, facts)


@cache
def _read(text: str) -> Cell:
    cell, findings = read_cell(SourceText("cell.toml", text), "carriages")
    assert cell is not None
    assert not findings
    return cell


def _carrying(text: str, shapes: dict[str, Sequence[Shape]], around: dict[str, Any]) -> Cell:
    bare = _read(text)
    stations = {
        name: replace(
            one, robot=replace(one.robot, links=(replace(one.robot.links[0], shapes=tuple(shapes[name])),))
        )
        for name, one in bare.stations.items()
    }
    return replace(bare, stations=stations, **around)

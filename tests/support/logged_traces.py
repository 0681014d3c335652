"""Traces as a robot logs them: a program run under other limits, sampled and rounded."""

import math
from collections.abc import Mapping
from dataclasses import dataclass, replace
from functools import cache

import numpy as np

from ropsim import language
from ropsim.calibration import MotionSettings, Trace
from ropsim.calibration.limits import under
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.icr import Program
from ropsim.model import Cell, Station, with_axis_limits
from ropsim.planning import MotionSequence
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array
from ropsim.workbench import environment_of

CELL = """\
# the cell of a calibration
[cell]
name = "c"

[robot]
model = "puma560"
tool = "jaws"

[controller]  # of this robot
path_speed = 600  # mm/s, as its sheet says
path_acceleration = 2000
path_jerk = 20000

[tools.jaws]
mass = 1.0
position = [0, 0, 150]
gripper = { open_time = 0.2, close_time = 0.2, capture = 5 }
"""
PROGRAM = """\
program main
units mm, deg, s
mov (500, -200, 300; down)
wait 0.2
lin (500, 0, 300; down)
mov (350, 300, 500; down)
close
mov (600, 0, 200; down)
wait 0.1
lin (600, 40, 200; down) blend 5 mm
lin (600, 80, 200; down) blend 5 mm
lin (600, 120, 200; down) blend 5 mm
lin (600, 160, 200; down) blend 5 mm
lin (600, 200, 200; down) blend 5 mm
lin (600, 240, 200; down) blend 5 mm
lin (600, 280, 200; down)
mov joints(0, 75, -180, 0, -75, 60)
"""
OTHER = """\
program other
units mm, deg, s
mov (400, -100, 500; down)
wait 0.2
mov (400, 250, 350; down)
lin (500, 250, 350; down)
mov (600, 100, 400; down)
"""
ENCODER = math.radians(0.002)
"""Step of the encoders [rad]."""
RATE = 125.0
"""Samples per second."""


@dataclass(frozen=True, slots=True, eq=False)
class Site:
    """A cell with its program and the stretches of that."""

    cell: Cell
    codes: Mapping[str, Program]
    orders: tuple[MotionSequence, ...]

    @property
    def station(self) -> Station:
        return self.cell.first


@cache
def site(program: str = PROGRAM, cell_text: str = CELL) -> Site:
    """Return a cell, its program and the stretches that a run plans."""
    cell, findings = read_cell(SourceText("cell.toml", cell_text), "c")
    assert cell is not None, findings
    compiled = language.compile(program, environment_of(cell), "main.task")
    assert compiled.icr is not None, compiled.diagnostics
    codes = {cell.first.name: compiled.icr}
    orders: list[MotionSequence] = []
    options = RunOptions(Fidelity.KINEMATIC, ordered=lambda _, one: orders.append(one))
    recording = run(cell, codes, options)
    assert recording.ok, recording.first_error
    return Site(cell, codes, tuple(orders))


def logged(made: Site, settings: MotionSettings, fidelity: Fidelity = Fidelity.KINEMATIC) -> Trace:
    """Return what a robot under settings logs of a program: at 125 Hz, by encoders of 0.002°."""
    robot = with_axis_limits(made.station.robot, *settings.joints)
    station = replace(made.station, robot=robot, controller=under(made.station.controller, settings))
    cell = replace(made.cell, stations={**made.cell.stations, station.name: station})
    recording = run(cell, made.codes, RunOptions(fidelity, record_hz=1000))
    times = np.arange(0.0013, recording.duration, 1.0 / RATE)
    return Trace(times - times[0], sampled(recording.time, recording.rows("q"), times))


def sampled(time: Array, q: Array, times: Array) -> Array:
    """Return joint coordinates at times, rounded to the steps of the encoders [rad], shape (k, n)."""
    found = np.array([np.interp(times, time, column) for column in q.T]).T
    return np.asarray(np.round(found / ENCODER) * ENCODER)


def table(trace: Trace, separator: str = ",") -> str:
    """Return a trace as a table in degrees."""
    titles = ["time [s]", *(f"j{number} [deg]" for number in range(1, trace.n + 1))]
    lines = [separator.join(titles)]
    for time, row in zip(trace.time.tolist(), np.degrees(trace.q).tolist(), strict=True):
        lines.append(separator.join([f"{time:.4f}", *(f"{value:.4f}" for value in row)]))
    text = "\n".join(lines) + "\n"
    return text if separator == "," else text.replace(".", ",")

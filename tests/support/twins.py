"""Random robots beside their models, and programs that tell their limits: the material of calibration."""

import math
from dataclasses import dataclass, replace

import numpy as np

from ropsim.calibration import Calibration, MotionSettings, Trace, calibrate, settings_of
from ropsim.calibration.limits import under
from ropsim.calibration.replanning import replanner
from ropsim.model import LookAhead, with_axis_limits
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.spatial import Array
from support.logged_traces import RATE, Site, sampled, site

CELL = """\
[cell]
name = "c"

[robot]
model = "puma560"
tool = "jaws"

[controller]
path_speed = 600

[tools.jaws]
mass = 1.0
position = [0, 0, 150]
"""
_LOW, _HIGH = np.array([350.0, -220.0, 240.0]), np.array([540.0, 220.0, 420.0])
CHAIN = 6
"""Moves from which on a sequence counts as a chain."""


@dataclass(frozen=True, slots=True, eq=False)
class Errors:
    """By which shares times are wrong: of each sequence, whether it is a chain, and of all together."""

    of_each: Array
    is_chain: Array
    in_all: float

    @property
    def of_chains(self) -> float:
        return float(np.abs(self.of_each[self.is_chain]).max(initial=0.0))


def program(random: np.random.Generator) -> str:
    """Return a program of joint moves, lines, zones, turns of the tool, and chains of 2 to 10 mm."""
    here = random.uniform(_LOW, _HIGH)
    lines = ["program main", "units mm, deg, s", f"mov {_place(here)}"]
    for kind in random.permutation(["mov", "lin", "chain", "turn", "zone", "mov", "chain"]).tolist():
        if kind == "chain":
            made, here = _chain(random, here)
            lines += made
        elif kind == "turn":
            turned = f"down, rz {random.choice([-60, -40, 40, 60])}, rx {random.choice([-20, 20])}"
            here = np.clip(here + random.uniform(-60.0, 60.0, 3), _LOW, _HIGH)
            lines += [f"lin {_place(here, turned)} speed 400 mm/s", f"lin {_place(here)} speed 400 mm/s"]
        elif kind == "zone":
            for end in (" blend 15 mm", " blend 30 mm", ""):
                here = random.uniform(_LOW, _HIGH)
                lines.append(f"lin {_place(here)} speed 500 mm/s{end}")
        else:
            here = random.uniform(_LOW, _HIGH)
            lines.append(f"{kind} {_place(here)}")
    return "\n".join([*lines, f"mov {_place(random.uniform(_LOW, _HIGH))}"]) + "\n"


def _chain(random: np.random.Generator, begin: Array) -> tuple[list[str], Array]:
    """Return a wave of short lines with zones, through the middle, and its end."""
    step, count = random.uniform(2.0, 10.0), int(random.integers(12, 28))
    to_middle = 0.5 * (_LOW + _HIGH) - begin
    angle = math.atan2(to_middle[1], to_middle[0])
    along, across = (np.array([math.cos(a), math.sin(a), 0.0]) for a in (angle, angle + math.pi / 2.0))
    height, length, speed = random.uniform(3.0, 15.0), random.uniform(50.0, 120.0), random.choice([200, 400])
    ways = step * np.arange(1, count + 1)
    places = [begin + s * along + height * math.sin(2.0 * math.pi * s / length) * across for s in ways]
    zone = f" blend {0.4 * step:.2f} mm"
    lines = [f"lin {_place(place)} speed {speed} mm/s{zone}" for place in places]
    return [*lines[:-1], lines[-1].removesuffix(zone)], places[-1]


def _place(place: Array, orientation: str = "down") -> str:
    return f"({place[0]:.2f}, {place[1]:.2f}, {place[2]:.2f}; {orientation})"


def random_site(random: np.random.Generator) -> Site:
    """Return the cell with a random program that it can make."""
    for _ in range(20):
        try:
            return site(program(random), CELL)
        except AssertionError:
            continue
    raise AssertionError("no such program")


def twin(known: MotionSettings, random: np.random.Generator) -> MotionSettings:
    """Return joint limits of 0.5 to 1 of the known ones, path limits of 0.2 to 2, a look-ahead of 3 to 20.

    The speed of the tool is that of the program.
    """
    tool = known.tool * np.exp(random.uniform(math.log(0.2), math.log(2.0), known.tool.shape))
    tool[0, 0] = known.tool[0, 0]
    joints = known.joints * random.uniform(0.5, 1.0, known.joints.shape)
    return MotionSettings(joints, tool, LookAhead(int(random.integers(3, 21)), 0.0))


def logged_in_ticks(made: Site, settings: MotionSettings, random: np.random.Generator, tick: float) -> Trace:
    """Return what a robot under settings logs, at times that are wrong by up to half a tick [s]."""
    robot = with_axis_limits(made.station.robot, *settings.joints)
    station = replace(made.station, robot=robot, controller=under(made.station.controller, settings))
    cell = replace(made.cell, stations={**made.cell.stations, station.name: station})
    recording = run(cell, made.codes, RunOptions(Fidelity.KINEMATIC, record_hz=1000))
    times = np.arange(0.0013, recording.duration, 1.0 / RATE)
    at = times + tick * random.uniform(-0.5, 0.5, len(times))
    return Trace(times - times[0], sampled(recording.time, recording.rows("q"), at))


def calibrated_twin(
    made: Site, true: MotionSettings, random: np.random.Generator, tick: float
) -> Calibration:
    """Return what comes of the trace of a twin."""
    trace = logged_in_ticks(made, true, random, tick)
    found, findings = calibrate(made.cell, made.station, made.orders, trace)
    assert found is not None, findings
    return found


def errors(made: Site, true: MotionSettings, found: MotionSettings) -> Errors:
    """Return by how much the times of a program under found limits differ from those under the true ones."""
    replan = replanner(made.cell, made.station, made.orders)
    times = [
        (a.duration, b.duration, len(order.moves) > CHAIN)
        for number, order in enumerate(made.orders)
        if (a := replan(number, true)) and (b := replan(number, found)) and a.ticks > 1
    ]
    lasted, planned = np.array([one[0] for one in times]), np.array([one[1] for one in times])
    return Errors(
        planned / lasted - 1.0, np.array([one[2] for one in times]), float(planned.sum() / lasted.sum()) - 1.0
    )


def known_settings(made: Site) -> MotionSettings:
    """Return the limits of the project."""
    return settings_of(made.station)

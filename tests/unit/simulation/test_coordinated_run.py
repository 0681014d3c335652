"""A seam on a plate that turns meanwhile: whole runs, undisturbed, slowed down, held and with drives."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from functools import cache

import numpy as np
import pytest

from ropsim import icr, language
from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.flow import LimitQuantity, MoveEvent, Recording
from ropsim.kinematics import forward_batch
from ropsim.model import Cell
from ropsim.simulation import Fidelity, NobodyWatches, RunOptions, RunView, run
from ropsim.spatial import Array
from ropsim.views.testing import summarize_path
from ropsim.workbench import environment_of

CELL = """
[robot]
model = "puma560"
tool = "torch"
positioner = { radius = 260, height = 400, base = { position = [600, 0, 0] } }
[tools.torch]
position = [0, 0, 150]
rpy = [0, 0, 180]
mass = 1.0
[frames.plate]
parent = "positioner"
position = [0, 0, 0]
"""
PROGRAM = """program seam
units mm, deg, s
loc start = (-170, 0, 60, 180, 0, 0) in plate
mov start external (0)
with speed 60, blend 5
  circ via (-120, 120.4159, 60) in plate to (0, 170, 60, 180, 0, -90) in plate external (90)
  circ via (120, 120.4159, 60) in plate to (170, 0, 60, 180, 0, 180) in plate external (180)
  circ via (120, -120.4159, 60) in plate to (0, -170, 60, 180, 0, 90) in plate external (270)
  circ via (-120, -120.4159, 60) in plate to start external (360) fine
endwith
"""
RADIUS, HEIGHT, ZONE = 0.17, 0.06, 0.005  # [m]
ON_PATH = 1e-6  # [m]
GIVEN = 2e-8  # [m]; the via points are rounded to 0.1 µm
BETWEEN = 2e-5  # [m]; within 5 mm of a corner a chord is 5²/(2·170) mm / 4 = 18 µm off the circle at most


@dataclass
class Hand(NobodyWatches):
    """Sets the override when the run has come to given times [s]."""

    acts: Sequence[tuple[float, float]]
    done: int = field(default=0)

    @property
    def may_press(self) -> bool:
        """Return True, so that slices are short."""
        return True

    def advanced(self, run: RunView) -> None:
        """Act where the time has come."""
        while self.done < len(self.acts) and run.time >= self.acts[self.done][0]:
            run.set_override(self.acts[self.done][1])
            self.done += 1


@cache
def cell() -> Cell:
    found, findings = read_cell(SourceText("cell.toml", CELL), "seam")
    assert findings == ()
    assert found is not None
    return found


@cache
def code() -> icr.Program:
    compiled = language.compile(PROGRAM, environment_of(cell()), name="main.task")
    assert [str(one) for one in compiled.diagnostics] == []
    assert compiled.icr is not None
    return compiled.icr


@cache
def recorded(fidelity: Fidelity, *acts: tuple[float, float]) -> Recording:
    watch = Hand(acts) if acts else NobodyWatches()
    found = run(cell(), {"robot": code()}, RunOptions(fidelity, record_hz=500, watch=watch))
    assert [str(one) for one in found.findings] == []
    return found


def on_plate(recording: Recording, quantity: str) -> tuple[Array, Array, Array]:
    """Return the TCP on the plate and in the room (k, 3) [m], and the plate's angle (k,), on the seam.

    The plate turns about a vertical axis at x = 600 mm, 400 mm above the floor.
    """
    first = recording.events_of(MoveEvent)[1].time
    q = recording.channels[quantity].values[recording.time > first + 1e-9]
    station = cell().first
    room = (forward_batch(station.robot, q) @ station.tools["torch"].X_MT.matrix())[:, :3, 3]
    x, y, z = (room - [0.6, 0.0, 0.4]).T
    c, s = np.cos(q[:, 6]), np.sin(q[:, 6])
    return np.stack((c * x + s * y, c * y - s * x, z), axis=1), room, q[:, 6]


def outside_zones(points: Array) -> Array:
    """Return which points (k, 3) are beyond the zones round the three corners, shape (k,)."""
    corners = np.array([[0.0, RADIUS, HEIGHT], [RADIUS, 0.0, HEIGHT], [0.0, -RADIUS, HEIGHT]])
    away = np.linalg.norm(points[:, None] - corners, axis=2)
    return np.asarray((away > ZONE + 1e-6).all(axis=1))


@pytest.mark.parametrize(
    "acts", [(), ((2.0, 0.35), (6.0, 1.0)), ((3.0, 0.0), (4.0, 0.2), (9.0, 0.9)), ((5.0, 0.01), (7.0, 1.0))]
)
def test_the_command_stays_on_the_circle_on_the_plate(acts: tuple[tuple[float, float], ...]) -> None:
    """At any override, held and going on; the plate is where the torch is, in proportion."""
    recording = recorded(Fidelity.KINEMATIC, *acts)
    points, room, angle = on_plate(recording, "q_ref")
    off = np.abs(np.hypot(points[:, 0], points[:, 1]) - RADIUS)
    outside = outside_zones(points)
    assert off[outside].max() < ON_PATH
    assert off.max() < BETWEEN
    assert np.abs(points[:, 2] - HEIGHT).max() < ON_PATH
    came = np.pi - np.unwrap(np.arctan2(points[:, 1], points[:, 0]))
    came -= 2.0 * np.pi * np.round((came - angle)[0] / (2.0 * np.pi))
    assert np.abs(came - angle)[outside].max() < ON_PATH / RADIUS
    assert angle[-1] == pytest.approx(2.0 * np.pi, abs=1e-9)
    assert np.abs(room - room[0]).max() < 20.0 * BETWEEN
    longer = recording.duration - recorded(Fidelity.KINEMATIC).duration
    assert (longer > 0.5) is bool(acts)


@pytest.mark.parametrize("fidelity", list(Fidelity))
def test_the_path_error_is_that_on_the_plate(fidelity: Fidelity) -> None:
    """Where torch and plate really are: the distance of the one from the circle on the other."""
    recording = recorded(fidelity)
    points, _, _ = on_plate(recording, "q")
    errors = recording.channels["path_error"].values[-len(points) :]
    off = np.hypot(np.hypot(points[:, 0], points[:, 1]) - RADIUS, points[:, 2] - HEIGHT)
    outside = outside_zones(points) & np.isfinite(errors)
    assert outside.mean() > 0.9
    np.testing.assert_allclose(errors[outside][:-20], off[outside][:-20], rtol=0, atol=GIVEN + 1e-7)
    assert errors[outside].max() < (ON_PATH if fidelity is Fidelity.KINEMATIC else 1e-3)


def test_speed_counts_on_the_plate() -> None:
    """60 mm/s over the plate; the torch stands in the room."""
    recording = recorded(Fidelity.KINEMATIC)
    points, room, _ = on_plate(recording, "q_ref")
    period = float(recording.time[1] - recording.time[0])
    over = np.linalg.norm(np.diff(points, axis=0), axis=1) / period
    assert np.quantile(over, 0.5) == pytest.approx(0.06, rel=1e-6)
    assert over.max() <= 0.06 * (1.0 + 1e-6)
    assert np.linalg.norm(np.diff(room, axis=0), axis=1).max() / period < 0.003


def test_the_limit_that_sets_the_time_is_that_of_the_speed_on_the_plate() -> None:
    for move in recorded(Fidelity.KINEMATIC).events_of(MoveEvent)[1:]:
        assert move.critical is not None
        assert (move.critical.joint, move.critical.quantity) == ("", LimitQuantity.SPEED)
        assert move.critical.share > 0.8


@pytest.mark.parametrize("override", [1.0, 0.5])
def test_where_the_plate_turns_no_quicker_it_sets_the_time(override: float) -> None:
    """60 mm/s at 170 mm take 20°/s of the plate."""
    table = f"speed_override = {override}\npositioner = {{ speed = 15, "
    slow, findings = read_cell(SourceText("cell.toml", CELL.replace("positioner = { ", table, 1)), "seam")
    assert slow is not None, findings
    found = run(slow, {"robot": code()}, RunOptions(Fidelity.KINEMATIC)).events_of(MoveEvent)[2].critical
    assert found is not None
    assert (found.joint, found.quantity) == ("E1", LimitQuantity.SPEED)


def test_the_accuracy_of_the_speed_is_that_on_the_plate() -> None:
    recording = recorded(Fidelity.DYNAMIC)
    seam = [one for one in summarize_path(recording).moves if one.ordinal > 0]
    assert len(seam) == 4
    for one in seam:
        assert one.speeds.command == pytest.approx(0.06, rel=1e-4)
        assert abs(one.speeds.accuracy) < 1e-4
    still = recording.channels["command_path_speed"].values[recording.time < 0.5]
    assert np.isnan(still).all()

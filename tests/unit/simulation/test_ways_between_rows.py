"""What happens between two recorded rows: thin plates at full speed, and distances of arms that move."""

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.collision import Collisions
from ropsim.core import Severity
from ropsim.flow import Channel, ChannelGroup, Fidelity, Recording, RunFacts, StationFacts
from ropsim.kinematics import forward
from ropsim.model import BodyKind, Box, Cell, FixedObject, Shape
from ropsim.simulation import run_collisions
from ropsim.spatial import Array, Pose
from support.carriages import RATE, crossed, led, turning

SPEED = 2.0
"""Of a carriage [m/s]: 8 mm from row to row."""
TOLERANCE = 1e-4
"""Least distances are found to this [m]."""
TOUCHING = 1e-4
"""Bodies that are no deeper in each other touch [m]."""
EXAMPLES = Path(__file__).parents[3] / "examples"


def thin_wall(thickness: float) -> FixedObject:
    return FixedObject("wall", Pose(np.array([1.0, 0.0, 0.0])), (Shape(Box((thickness, 0.5, 0.5))),))


@pytest.mark.parametrize("phase", range(16))
@pytest.mark.parametrize(("plate", "wall"), [(5e-4, 5e-4), (1e-3, 1e-3), (2e-3, 1e-3)])
def test_a_plate_that_is_led_through_a_wall_at_full_speed_is_found(
    plate: float, wall: float, phase: int
) -> None:
    cell = crossed((Shape(Box((0.1, 0.1, plate))),), objects=(thin_wall(wall),))
    x = np.arange(0.0, 2.0, SPEED / RATE) + phase / 16.0 * SPEED / RATE
    recording = led(cell, {"across": x, "along": np.zeros(len(x))})
    (one,) = run_collisions(recording, cell).facts.contacts
    assert {one.one, one.other} == {"across/link1", "wall"}
    assert abs(np.interp(one.time, recording.time, x) - 1.0) <= (plate + wall) / 2.0


@pytest.mark.parametrize("phase", range(16))
def test_a_plate_that_passes_beside_a_wall_is_free_and_its_distance_is_that_between_rows(phase: int) -> None:
    """Behind its upper edge, 0.3 mm away; at the rows it is up to 4 mm off in the other direction."""
    gap = 3e-4
    plate = Shape(Box((0.1, 0.1, 1e-3)), Pose(np.array([-0.25 - 0.05 - gap, 0.0, 0.0])))
    cell = crossed((plate,), objects=(thin_wall(1e-3),))
    x = np.arange(0.0, 2.0, SPEED / RATE) + phase / 16.0 * SPEED / RATE
    found = run_collisions(led(cell, {"across": x, "along": np.zeros(len(x))}), cell)
    assert found.facts.contacts == ()
    assert found.facts.clearance is not None
    assert found.facts.clearance.distance == pytest.approx(gap, abs=TOLERANCE)


@pytest.mark.parametrize("phase", range(8))
def test_a_blade_that_turns_through_a_post_is_found(phase: int) -> None:
    blade = Shape(Box((1.0, 5e-4, 0.1)), Pose(np.array([0.5, 0.0, 0.0])))
    post = FixedObject("post", Pose(np.array([0.0, 0.8, 0.0])), (Shape(Box((5e-4, 5e-4, 0.1))),))
    cell = turning((blade,), objects=(post,))
    turns = np.arange(0.0, np.pi, 0.02) + phase / 8.0 * 0.02
    (one,) = run_collisions(led(cell, {"table": turns}), cell).facts.contacts
    assert {one.one, one.other} == {"table/link1", "post"}


def test_bodies_that_rows_do_not_tell_apart_are_an_error_of_their_own() -> None:
    """A carriage that turns back 5 mm before a wall, between two rows, may have come into it."""
    x = 1.0 - 0.06 - np.array([0.3, 0.1, 0.02, 0.005, 0.005, 0.02, 0.1, 0.3])
    cell = crossed((Shape(Box((0.1, 0.1, 0.1))),), objects=(thin_wall(0.02),))
    found = run_collisions(led(cell, {"across": x, "along": np.zeros(len(x))}), cell)
    assert found.facts.contacts == ()
    (one,) = found.findings
    assert (one.code, one.severity) == ("S771", Severity.ERROR)
    assert "across/link1 – wall may collide" in one.message
    assert all(one.distance < 0.0 for one in found.facts.undecided)
    far = run_collisions(led(cell, {"across": x - 0.2, "along": np.zeros(len(x))}), cell)
    assert far.findings == ()


def test_ways_of_an_arm_that_runs_away_are_undecided_soon() -> None:
    """Steps of up to 1e11 m between two rows, to and fro: halving ends by its number of looks."""
    x = np.cumsum((-1.0) ** np.arange(60) * 10.0 ** np.linspace(-3.0, 11.0, 60))
    cell = crossed((Shape(Box((0.1, 0.1, 0.1))),) * 4, objects=(thin_wall(0.02),))
    found = run_collisions(led(cell, {"across": x, "along": np.zeros(len(x))}), cell)
    assert {one.code for one in found.findings} >= {"S751"}


@pytest.mark.parametrize("rate", [10.0, 20.0])
def test_short_moves_between_sparse_rows_are_not_passed_in_silence(rate: float) -> None:
    """At rest 0.2 mm before a wall, as far as rows tell: joints may have gone there and back between two."""
    cell = crossed((Shape(Box((0.1, 0.1, 0.1))),), objects=(thin_wall(0.02),))
    x = np.full(30, 1.0 - 0.06 - 2e-4)
    dense = led(cell, {"across": x, "along": np.zeros(len(x))})
    sparse = replace(dense, time=np.arange(30) / rate)
    assert {one.code for one in run_collisions(sparse, cell).findings} == {"S771"}
    assert run_collisions(dense, cell).findings == ()


@cache
def bare_cell() -> Cell:
    """Return an arm with its tool, and nothing else."""
    project = ropsim.open(EXAMPLES / "first_cell")
    assert project.cell is not None
    return replace(project.cell, objects=(), parts=(), locations={})


def along(cell: Cell, q: Array) -> Recording:
    """Return a recording in which the arm of a cell is led by rows, shape (k, n)."""
    (name,) = cell.stations
    channels = {
        "q": Channel(q, "rad", tuple(map(str, range(q.shape[1]))), "", ChannelGroup.JOINTS, name),
        "line": Channel(np.zeros(1), "", (), "", ChannelGroup.PROGRAM, name, np.zeros(1)),
    }
    facts = RunFacts(fidelity=Fidelity.KINEMATIC, record_hz=RATE, stations=(StationFacts(name, source=""),))
    time = np.arange(len(q)) / RATE
    return Recording(time, channels, (), (), float(time[-1]), facts)


def swung(random: np.random.Generator, cell: Cell) -> Callable[[Array], Array]:
    """Return coordinates by time [s], shape (k, n): sums of sines about the home position."""
    home = np.asarray(cell.first.robot.home)
    sizes, phases = random.uniform(-0.3, 0.3, (2, len(home))), random.uniform(0.0, 6.0, (2, len(home)))
    rates = random.uniform(2.0, 6.0, (2, len(home)))

    def q(time: Array) -> Array:
        waves = sizes[:, np.newaxis] * np.sin(
            rates[:, np.newaxis] * time[:, np.newaxis] + phases[:, np.newaxis]
        )
        return np.asarray(home + waves.sum(axis=0))

    return q


@pytest.mark.parametrize("seed", [0, *(pytest.param(k, marks=pytest.mark.slow) for k in range(1, 40))])
def test_no_state_of_an_arm_is_nearer_than_the_least_distance_of_its_run(seed: int) -> None:
    """Looked at four times as often as recorded; joints accelerate by up to 25 rad/s²."""
    random = np.random.default_rng(seed)
    cell = bare_cell()
    q = swung(random, cell)
    time = np.arange(60) / RATE
    reach = forward(cell.first.robot, q(time)[30]).position
    boxes = tuple(
        FixedObject(
            f"box{k}",
            cell.first.X_WB @ Pose(reach + random.uniform(-0.5, 0.5, 3), random.normal(size=4)),
            (Shape(Box(tuple(random.uniform(0.01, 0.2, 3).tolist()))),),
        )
        for k in range(6)
    )
    full = replace(cell, objects=boxes)
    found = run_collisions(along(full, q(time)), full).facts
    alone = Collisions(full)
    objects = {one.name for one in boxes}
    arm = [one.name for one in alone.tree.bodies if one.name not in objects]
    fine = q(np.linspace(0.0, time[-1], 4 * (len(time) - 1) + 1))
    least = min(
        alone.separation(one, absent=[name for name in arm if name != link]).distance
        for link in alone.bodies.rows
        if link in arm and alone.tree.by_name()[link].kind is not BodyKind.BASE
        for one in fine
    )
    is_met = any({one.one, one.other} & objects for one in found.met)
    if is_met or any({one.one, one.other} & objects for one in found.contacts):
        assert least < 0.0
        return
    if any({one.one, one.other} & objects for one in found.undecided):
        assert least < 1e-3
        return
    assert least >= -TOUCHING
    if not found.contacts:
        assert found.clearance is not None
        assert least - 1e-3 < found.clearance.distance < max(least, 0.0) + TOLERANCE

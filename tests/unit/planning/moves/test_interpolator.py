"""The interpolator: samples of a tool path, dense enough in way and turn, exact at both ends."""

import math

import numpy as np
import pytest

from ropsim.motion import Line, ToolPoints
from ropsim.planning import StandardInterpolator
from ropsim.planning.testing import FEWEST
from ropsim.spatial import Array, Pose

SAMPLER = StandardInterpolator()
ROUNDING = 1e-12


def line(way: float, turn: float = 0.0) -> Line:
    end = Pose(np.array([way, 0.0, 0.0]), np.array([math.cos(turn / 2.0), 0.0, 0.0, math.sin(turn / 2.0)]))
    return Line(Pose(), end)


def test_samples_begin_at_the_start_and_end_exactly_at_the_goal() -> None:
    path = line(0.1, 0.3)
    setpoints = SAMPLER.sample(path, 1)
    assert setpoints.length == path.length
    assert np.abs(setpoints.matrices[0] - path.X_start.matrix()).max() == 0.0
    assert setpoints.matrices[-1, :3, 3].tolist() == path.X_end.position.tolist()
    assert np.abs(setpoints.matrices[-1] - path.X_end.matrix()).max() < ROUNDING


def test_samples_are_equally_spaced() -> None:
    way = SAMPLER.sample(line(0.7), 1).matrices[:, 0, 3]
    assert np.diff(way) == pytest.approx(np.full(len(way) - 1, 0.7 / (len(way) - 1)), abs=ROUNDING)


@pytest.mark.parametrize(("way", "turn"), [(1.0, 0.0), (0.3, 2.0), (0.0, 1.5), (0.01, 3.0)])
def test_neither_way_nor_turn_between_two_samples_is_too_long(way: float, turn: float) -> None:
    matrices = SAMPLER.sample(line(way, turn), 1).matrices
    steps = np.linalg.norm(np.diff(matrices[:, :3, 3], axis=0), axis=1)
    between = np.swapaxes(matrices[:-1, :3, :3], 1, 2) @ matrices[1:, :3, :3]
    angles = np.arccos(np.clip((np.trace(between, axis1=1, axis2=2) - 1.0) / 2.0, -1.0, 1.0))
    assert steps.max() <= SAMPLER.distance * (1.0 + ROUNDING)
    assert angles.max() <= SAMPLER.turn * (1.0 + 1e-6)  # arccos is coarse near 0


def test_the_shortest_path_has_samples_enough_for_its_derivatives() -> None:
    assert len(SAMPLER.sample(line(1e-6), 1).matrices) == FEWEST + 1


@pytest.mark.parametrize("density", [2, 4, 64])
def test_denser_samples_keep_those_before_among_them(density: int) -> None:
    path = line(0.23, 0.4)
    once, denser = SAMPLER.sample(path, 1), SAMPLER.sample(path, density)
    assert len(denser.matrices) - 1 == density * (len(once.matrices) - 1)
    assert np.abs(denser.matrices[::density] - once.matrices).max() < ROUNDING


class Bow:
    """A half circle in the plane z = 0 with an orientation that is kept."""

    length = math.pi * 0.5

    def tool(self, s: Array) -> ToolPoints:
        """Return the tool at places s."""
        matrices = np.tile(np.eye(4), (len(s), 1, 1))
        angle = s / 0.5
        matrices[:, 0, 3], matrices[:, 1, 3] = 0.5 * np.cos(angle), 0.5 * np.sin(angle)
        d1, d2 = np.zeros((len(s), 6)), np.zeros((len(s), 6))
        d1[:, 0], d1[:, 1] = -np.sin(angle), np.cos(angle)
        d2[:, 0], d2[:, 1] = -np.cos(angle) / 0.5, -np.sin(angle) / 0.5
        return ToolPoints(matrices, d1, d2)

    def positions(self, s: Array) -> Array:
        """Return positions at places s."""
        return self.tool(s).matrices[:, :3, 3]

    def distance(self, points: Array) -> Array:
        """Return distances from the circle."""
        return np.asarray(np.abs(np.linalg.norm(points[:, :2], axis=1) - 0.5))


def test_any_path_of_the_tool_is_sampled_along_its_way() -> None:
    places = SAMPLER.sample(Bow(), 1).matrices[:, :3, 3]
    assert np.abs(np.linalg.norm(places, axis=1) - 0.5).max() < ROUNDING
    assert np.linalg.norm(np.diff(places, axis=0), axis=1).max() <= SAMPLER.distance
    assert len(places) == math.ceil(Bow.length / SAMPLER.distance) + 1

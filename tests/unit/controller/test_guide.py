"""The guide: what it does in compiled loops is what the entities do one by one."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.controller import MotionChain, Refusal, StandardInterpolator
from ropsim.controller.guide import guide_of
from ropsim.controller.interpolator import places
from ropsim.controller.tracing import trace
from ropsim.kinematics import (
    ROOM_OF_ROWS,
    exact_arm,
    forward,
    inverse,
    inverse_batch,
    inverse_branch,
    inverse_rows,
    solver_of,
)
from ropsim.model import RobotModel
from ropsim.motion import Arc, Curve, Line, OrientationMode, ToolPath, Traced, arc, corner, spline
from ropsim.robots import default_controller
from ropsim.spatial import Array, Pose
from support.cells import chain_of, one_station
from support.motion import CHAIN, FINE, PUMA, START, interface_pose, lin, shifted

ARMS = ["puma560", "ur10e", "irb4600_60_205", "scara", "cobra600", "stanford"]
MODES = [OrientationMode.FIXED_AXIS, OrientationMode.DRIVE_TRANSFORM]
MOVE = lin(None, FINE)
ROUNDING = 1e-11  # of poses, by which joints near to singularities move further


class OneByOne(StandardInterpolator):
    """Samples as the standard one does, but is none: each entity is asked by itself."""


def chain_for(name: str) -> MotionChain:
    return chain_of(one_station("c", robots.load(name), default_controller(name)))


def paths(robot: RobotModel, random: np.random.Generator) -> tuple[Array, list[ToolPath]]:
    """Return a start, and a line and an arc from there, of up to half a metre."""
    share = random.uniform(0.3, 0.7, robot.n)
    q = np.asarray(robot.lower_limits + share * (robot.upper_limits - robot.lower_limits))
    near = [q + random.normal(scale=0.1, size=robot.n) for _ in range(2)]
    start, via, end = (forward(robot, one) for one in (q, *near))
    curved = arc(start, via, end)
    found: list[ToolPath] = [Line(start, end, MODES[int(random.integers(2))])]
    return q, [*found, curved] if isinstance(curved, Arc) else found


@pytest.mark.parametrize("name", ARMS)
def test_a_path_is_led_as_the_entities_lead_it_one_by_one(name: str) -> None:
    chain, random = chain_for(name), np.random.default_rng(3)
    guide, count = guide_of(chain), 0
    assert guide is not None
    assert guide_of(replace(chain, interpolator=OneByOne())) is None
    for _ in range(12):
        q_start, found = paths(chain.robot, random)
        for path in found:
            quick = guide.joints(path, q_start, MOVE)
            slow = trace(replace(chain, interpolator=OneByOne()), path, q_start, MOVE)
            if quick is None:
                continue
            count += 1
            assert not isinstance(slow, Refusal)
            assert isinstance(slow[0], Traced)
            assert np.abs(quick[0].q - slow[0].q).max() < ROUNDING
            assert np.abs(quick[0].derivatives - slow[0].derivatives).max() < ROUNDING
            assert quick[1] == slow[1]
    assert count > 8


def test_what_is_beyond_it_is_left_to_the_entities() -> None:
    guide = guide_of(CHAIN)
    assert guide is not None
    here = interface_pose(PUMA.home)
    for path, q in (
        (Line(here, shifted(here, -1.1, 0.0, 0.0)), PUMA.home),  # a joint limit
        (Line(here, shifted(here, 3.0, 0.0, 0.0)), PUMA.home),  # out of reach
        (Line(interface_pose(START), shifted(interface_pose(START), 0.1, 0.0, 0.0)), PUMA.home),  # a jump
    ):
        assert guide.joints(path, q, MOVE) is None
        assert isinstance(trace(CHAIN, path, q, MOVE), Refusal)


def test_external_axes_coupled_limits_and_arms_without_names_have_no_guide() -> None:
    assert guide_of(chain_for("panda")) is None
    assert guide_of(chain_for("palletizer")) is None


@pytest.mark.parametrize("count", [1, 7, 8, 9, 33])
def test_one_branch_of_poses_is_that_among_all_of_them(count: int) -> None:
    arm, random = exact_arm(solver_of(PUMA)), np.random.default_rng(5)
    assert arm is not None
    T = np.stack([forward(PUMA, random.uniform(-3.0, 3.0, 6)).matrix() for _ in range(count)])
    wanted = inverse_batch(PUMA, T)
    for row in range(8):
        out = np.full((count + 1, 6), 7.0)
        inverse_branch(arm, np.zeros(ROOM_OF_ROWS), T, row, out[:count])
        assert np.array_equal(out[:count], wanted[:, row], equal_nan=True)
        assert (out[count] == 7.0).all()


def test_a_pose_of_no_numbers_has_no_branches() -> None:
    arm = exact_arm(solver_of(PUMA))
    assert arm is not None
    out = np.zeros((1, 8, 6))
    inverse_rows(arm, np.zeros(ROOM_OF_ROWS), np.full((1, 4, 4), np.nan), out)
    assert np.isnan(out).all()
    assert places(0.3, 3).tolist() == np.linspace(0.0, 0.3, 4).tolist()
    assert exact_arm(solver_of(robots.load("ur10e"))) is None


@pytest.mark.parametrize("density", [1, 2, 8])
def test_poses_are_those_of_the_interpolator_behind_the_tool(density: int) -> None:
    guide, random = guide_of(CHAIN), np.random.default_rng(9)
    assert guide is not None
    X_TM = forward(PUMA, START).matrix()
    for _ in range(20):
        ends = [forward(PUMA, random.uniform(-2.0, 2.0, 6)) for _ in range(3)]
        curve = spline(ends)
        assert isinstance(curve, Curve)
        found_paths: list[ToolPath] = [*(Line(ends[0], ends[1], mode) for mode in MODES), curve]
        for path in found_paths:
            found, dense = guide.poses(path, X_TM, density)
            assert dense == density * (2 if density == 1 and guide.interpolator.steps(path) % 2 else 1)
            wanted = guide.interpolator.sample(path, dense).matrices @ X_TM
            assert found.shape == wanted.shape
            assert np.abs(found - wanted).max() < 1e-14


def test_a_path_of_more_steps_than_any_memory_has_no_poses() -> None:
    guide = guide_of(CHAIN)
    assert guide is not None
    path = Line(Pose(), Pose(np.array([1e6, 0.0, 0.0])))
    assert len(guide.poses(path, np.eye(4), 1)[0]) == 0
    assert guide.joints(path, START, MOVE) is None


def test_corners_that_are_taken_closely_at_once_end_with_the_samples_that_they_ask_for() -> None:
    """One by one the density grows from the first; taken at once, that of the first is found among more."""
    guide, random, counts = guide_of(CHAIN), np.random.default_rng(12), set()
    assert guide is not None
    slow_chain = replace(CHAIN, interpolator=OneByOne())
    for size in (1e-4, 1e-3, 1e-2, 3e-2, 0.1):
        for _ in range(6):
            X, ways = interface_pose(START), size * random.normal(size=(2, 3))
            middle = shifted(X, *ways[0].tolist())
            lines = Line(X, middle), Line(middle, shifted(middle, *ways[1].tolist()))
            path = corner(lines[0], 0.6 * lines[0].length, lines[1], 0.4 * lines[1].length)
            assert isinstance(path, Curve)
            q_start = branch_of(path, START)
            quick, slow = guide.joints(path, q_start, MOVE), trace(slow_chain, path, q_start, MOVE)
            assert quick is not None
            assert not isinstance(slow, Refusal)
            assert isinstance(slow[0], Traced)
            assert quick[0].q.shape == slow[0].q.shape
            assert np.abs(quick[0].q - slow[0].q).max() < ROUNDING
            counts.add(len(quick[0].q))
    assert len(counts) > 1


def branch_of(path: ToolPath, near: Array) -> Array:
    """Return the joint coordinates at the start of a path that are nearest to some."""
    pose = Pose.from_matrix(path.tool(np.zeros(1)).matrices[0])
    return np.asarray(min(inverse(PUMA, pose).solutions, key=lambda one: float(np.abs(one - near).max())))

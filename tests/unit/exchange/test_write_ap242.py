"""Plain AP242 out: the same mechanism in entities of that schema only, and back again."""

import re
from collections.abc import Callable
from dataclasses import replace
from functools import partial

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.exchange import losses_refused, write_ap242
from ropsim.kinematics import forward
from ropsim.model import Joint, JointType, Link, LoopCut, RobotModel, coordinates
from ropsim.nirox import nirox_schema_text, read_nirox
from ropsim.spatial import Pose, frozen
from support.exchange_laws import random_chain

SAME = 1e-12
KINEMATIC, _, OWN = nirox_schema_text().text.partition("what NIROX adds")


def read(text: str) -> RobotModel:
    found = read_nirox(SourceText("plain.stp", text))
    assert found.robot is not None, found.findings
    return found.robot


def turned_at_random(seed: int, count: int = 12) -> RobotModel:
    """Return a chain whose frames are turned in any way, counted from anywhere, with a flange."""
    rng = np.random.default_rng(seed)
    types = (JointType.REVOLUTE, JointType.PRISMATIC, JointType.SCREW)
    joints = tuple(
        Joint(f"j{k}", types[k % 3], pose(rng), rng.uniform(-3, 3), -2, 2, 1, 1, 1, lead=0.01 * (k % 3 == 2))
        for k in range(count)
    )
    link = Link(0.0, np.zeros(3), np.zeros((3, 3)))
    return RobotModel(
        "turned", "turned", joints, (link,) * count, (), frozen(np.zeros(count)), X_nM=pose(rng)
    )


def pose(rng: np.random.Generator) -> Pose:
    return Pose(rng.uniform(-1, 1, 3), (q := rng.normal(size=4)) / np.linalg.norm(q))


CASES: dict[str, Callable[[], RobotModel]] = {
    **{name: partial(robots.load, name) for name in robots.names()},
    **{f"chain {seed}": partial(random_chain, seed) for seed in (13, 17, 27)},
    **{f"turned {seed}": partial(turned_at_random, seed) for seed in range(6)},
}


@pytest.mark.parametrize("case", CASES.values(), ids=CASES)
def test_read_again_it_is_the_same_mechanism_and_written_again_the_same_text(
    case: Callable[[], RobotModel],
) -> None:
    robot = case()
    written = write_ap242(robot)
    again = read(written.text)
    assert [one.name for one in again.axis_joints[: robot.n]] == [one.name for one in robot.axis_joints]
    np.testing.assert_allclose(again.home[: robot.n], robot.home, atol=SAME)
    np.testing.assert_allclose(again.lower_limits[: robot.n], robot.lower_limits, atol=SAME)
    np.testing.assert_allclose(again.upper_limits[: robot.n], robot.upper_limits, atol=SAME)
    made, names = coordinates(robot), [one.name for one in robot.joints for _ in range(one.type.freedoms)]
    for q in np.random.default_rng(5).uniform(-1.5, 1.5, (5, robot.n)):
        known = dict(zip(names, made.T @ q + made.c, strict=True))
        found = forward(again, np.array([known[one.name] for one in again.axis_joints]))
        np.testing.assert_allclose(found.matrix(), forward(robot, q).matrix(), atol=SAME)
    assert write_ap242(again).text == written.text


def test_no_entity_is_one_of_ours() -> None:
    own = {name.upper() for name in re.findall(r"ENTITY (\w+)", OWN)}
    assert "ROBOT_ARM" in own
    for case in CASES.values():
        used = set(re.findall(r"([A-Z][A-Z_0-9]+)\(", write_ap242(case()).text.partition("DATA;")[2]))
        assert "MECHANISM_REPRESENTATION" in used
        assert not used & own
        assert all(f"ENTITY {one.lower()}" in KINEMATIC for one in used)


def test_what_is_lost_is_told_entity_by_entity() -> None:
    puma = {one.message for one in write_ap242(robots.load("puma560")).losses}
    words = " ".join(puma)
    for what in ("masses", "friction of axes", "rotors", "motor constants", "gear ratios", "shapes", "title"):
        assert what in words
    assert all("`1`" in one for one in puma if "axes" in one)
    rods = [one for one in write_ap242(robots.load("m410ib_700")).losses if one.code == "X993"]
    assert len(rods) == len(robots.load("m410ib_700").couplings)
    assert "`elbow` is an axis of its own" in " ".join(one.message for one in rods)


def test_a_mechanism_that_is_all_there_is_loses_only_its_limits_of_motion() -> None:
    bare = read(write_ap242(robots.load("tx60")).text)
    losses = write_ap242(replace(bare, origins=())).losses
    assert [one.message.partition(" of axes")[0] for one in losses] == [
        "greatest speeds, accelerations and jerks"
    ]
    assert losses_refused((), losses) is not None


def test_closed_chains_are_loops_of_the_file() -> None:
    """Two links side by side whose tips are held together."""
    first = turned_at_random(1, 2)
    forked = replace(
        first,
        joints=tuple(replace(one, parent=-1, type=JointType.REVOLUTE) for one in first.joints),
        axes=(0,),
        home=frozen([0.0]),
        cuts=(LoopCut(0, Pose(), 1, Pose()),),
    )
    written = write_ap242(forked)
    assert written.text.count("=KINEMATIC_LOOP(") == 1
    assert "LOOP_CUT" not in written.text
    assert any("closed chains" in one.message for one in written.losses)

"""Robots to NIROX files: valid, canonical, and everything that does not go over is told."""

from dataclasses import replace

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.express import Population, validate
from ropsim.model import (
    DcMotor,
    Direction,
    Drive,
    EffortAmplifier,
    Gear,
    LoopCut,
    MechanismError,
    RobotModel,
    VoltageAmplifier,
)
from ropsim.nirox import nirox_schema, write_nirox
from ropsim.part21 import Reference, read_exchange, write_exchange
from ropsim.spatial import Pose
from support.built_in import WRITTEN
from support.trees import random_tree


@pytest.mark.parametrize("name", WRITTEN)
def test_what_is_written_keeps_to_the_schema_and_is_canonical(name: str) -> None:
    written = write_nirox(robots.load(name))
    assert written.losses == ()
    file, findings = read_exchange(SourceText("a.stp", written.text))
    assert findings == ()
    assert validate(Population(nirox_schema(), file)) == ()
    assert write_exchange(file) == written.text
    assert write_nirox(robots.load(name)).text == written.text


def test_the_arm_comes_first_and_says_its_axes_in_their_order() -> None:
    robot = robots.load("palletizer")
    lines = write_nirox(robot).text.splitlines()
    data = lines[lines.index("DATA;") + 1 :]
    assert data[0].startswith("#1=PARAMETER_ORIGIN(#2,")
    assert data[1].startswith("#2=ROBOT_ARM('palletizer','','Palletizer with four axes and level flange',")


def test_a_prismatic_pair_slides_along_x() -> None:
    """ISO 10303-105 has it so: z of the moved frame of the model is x of the frame on the moved link."""
    file, _ = read_exchange(SourceText("a.stp", write_nirox(robots.load("scara")).text))
    known = {one.number: one.records[0] for one in file.instances}
    (pair,) = [one for one in known.values() if one.keyword == "PRISMATIC_PAIR_WITH_RANGE"]
    placement = known[_number(pair.values[4])]
    axes = [known[_number(one)].values[1] for one in placement.values[2:]]
    assert axes == [(0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]


def _number(value: object) -> int:
    assert isinstance(value, Reference)
    return value.number


def test_a_robot_that_breaks_a_rule_is_not_written_and_the_rule_is_named() -> None:
    weak = Drive(VoltageAmplifier(40.0, 10.0), DcMotor(0.0, 0.1, 1.0, 0.001, 1e-4), Gear(60.0))
    written = write_nirox(replace(robots.load("two_link"), drives=(weak, weak)))
    assert written.text == ""
    assert {one.code for one in written.losses} == {"X956"}
    assert "positive_real.wr1" in written.losses[0].message


def test_a_mechanism_that_cannot_be_raises() -> None:
    robot = robots.load("two_link")
    with pytest.raises(MechanismError):
        write_nirox(replace(robot, links=()))


def test_drives_of_mixed_blocks_are_told_as_lost() -> None:
    robot = robots.load("two_link")
    odd = replace(robot.drives[0], amplifier=EffortAmplifier(3.0), motor=DcMotor(0.1, 0.1, 1.0, 0.001, 1e-4))
    written = write_nirox(replace(robot, drives=(odd, robot.drives[1])))
    assert [one.code for one in written.losses] == ["X953"]
    assert "of axes 1 motor and amplifier" in written.losses[0].message
    assert "DRIVE_TRAIN" not in written.text


def test_a_second_chain_between_two_links_is_told_as_lost() -> None:
    robot = random_tree(3, 4).robot
    held = (Direction.X, Direction.Y, Direction.Z)
    pin = LoopCut(1, Pose(), 3, Pose(np.array([0.1, 0.0, 0.0])), held)
    second = replace(pin, X_second=Pose(np.array([0.2, 0.0, 0.0])))
    written = write_nirox(
        replace(robot, couplings=(), axes=(), home=np.zeros(_free(robot)), cuts=(pin, second))
    )
    assert [one.code for one in written.losses] == ["X953"]
    assert "closed chain 2" in written.losses[0].message
    assert written.text.count("LOOP_CUT") == 1


def _free(robot: RobotModel) -> int:
    return replace(robot, couplings=(), axes=(), home=np.zeros(0)).n

"""What `ropsim robot show` and `ropsim robot ik` say of arms that are solved in different ways."""

import json
import math

import numpy as np
import pytest

from ropsim import robots
from ropsim.cli.testing import main
from ropsim.kinematics import forward
from ropsim.model import RobotModel
from support.arms import random_arm
from support.published_arms import published_arm
from support.scara import scara

ARMS = {
    "cobra": scara(),
    "free": random_arm(3, "RRPRR"),
    "askew": random_arm(3, "RRRRRR"),
    "kr120": published_arm("kr120_r2700_2"),
    "sia20": published_arm("motoman_sia20d"),
}


@pytest.fixture(autouse=True)
def shelf(monkeypatch: pytest.MonkeyPatch) -> None:
    built_in = robots.load

    def load(name: str) -> RobotModel:
        return ARMS[name] if name in ARMS else built_in(name)

    monkeypatch.setattr(robots, "load", load)


def said(words: str, capsys: pytest.CaptureFixture[str]) -> str:
    main(words.split())
    return " ".join(capsys.readouterr().out.split())


def test_what_a_joint_that_follows_axes_leaves_them_is_told(
    capsys: pytest.CaptureFixture[str],
) -> None:
    """J3 of a FANUC has 520° in the table, for all that J2 may have; in any one posture it has 275°."""
    shown = said("robot show lr_mate_200id", capsys)
    assert "J3 revolute -215.0 ° 305.0 °" in shown
    assert "joint J3 + J2, which follows the axes: -70.0 ° to 205.0 °" in shown
    assert "with the other axes at home that leaves J3 -70.0 ° to 205.0 °" in shown
    palletizer = said("robot show m410ib_700", capsys)
    assert "joint elbow, which follows the axes: -74.9 ° to 65.0 °" in palletizer
    assert "with the other axes at home that leaves 3 -50.0 ° to 65.0 °" in palletizer


def test_the_class_of_an_arm_is_named_with_its_branches(capsys: pytest.CaptureFixture[str]) -> None:
    assert "inverse kinematics: SCARA, closed form, 2 branches" in said("robot show cobra", capsys)
    assert "inverse kinematics: spherical wrist, closed form, 8 branches" in said(
        "robot show puma560", capsys
    )


def test_an_arm_off_its_class_says_by_how_much(capsys: pytest.CaptureFixture[str]) -> None:
    remark = "is off the exact class (spherical wrist) by 0.00021° and 0.00066 mm"
    assert remark in said("robot show kr120", capsys)
    assert remark in said("robot ik kr120 1500 100 1200 0 90 0", capsys)
    main(["robot", "show", "kr120", "--json"])
    solver = json.loads(capsys.readouterr().out)["inverse_kinematics"]
    assert solver["snapped_by"]["angle"] == pytest.approx(1.5708 - 1.5707963267948966, rel=0.1)
    assert len(solver["postures"]) == 8


def test_an_arm_without_closed_form_says_so_and_why(capsys: pytest.CaptureFixture[str]) -> None:
    shown = said("robot show free", capsys)
    assert "inverse kinematics: numeric; further branches than those found may exist" in shown
    assert ": it has 5 joints, the class has 6" in shown
    x, y, z = 1e3 * forward(ARMS["free"], [0.0] * 5).position
    found = said(f"robot ik free {x} {y} {z} 0 0 0", capsys)
    assert "found numerically; further branches may exist" in found
    main(["robot", "ik", "free", "9000", "0", "0", "0", "0", "0", "--json"])
    answer = json.loads(capsys.readouterr().out)
    assert (answer["status"], answer["solver"]["method"]) == ("out of reach", "numeric")


def test_an_arm_solved_algebraically_has_all_its_branches_without_names(
    capsys: pytest.CaptureFixture[str],
) -> None:
    shown = said("robot show askew", capsys)
    assert "general six-axis, algebraic, up to 16 branches without names" in shown
    assert "further branches" not in said("robot ik askew 9000 0 0 0 0 0", capsys)
    main(["robot", "show", "askew", "--json"])
    solver = json.loads(capsys.readouterr().out)["inverse_kinematics"]
    assert (solver["method"], solver["postures"]) == ("algebraic", [])


def test_what_a_pose_leaves_free_of_a_redundant_arm_is_told_with_its_value(
    capsys: pytest.CaptureFixture[str],
) -> None:
    assert "inverse kinematics: S-R-S, closed form, 8 branches" in said("robot show sia20", capsys)
    found = said("robot ik sia20 400 100 600 180 0 0", capsys)
    main([*["robot", "ik", "sia20", "400", "100", "600", "180", "0", "0", "--json"]])
    free = json.loads(capsys.readouterr().out)["free"]
    assert free["name"] == "swivel angle"
    assert -math.pi < free["value"] < 0.0  # that of all joints at 0 is beyond the limits
    assert (
        f"with swivel angle {round(math.degrees(free['value']), 1):g}°, which the pose leaves free" in found
    )
    ends = np.degrees(free["intervals"])
    assert math.degrees(free["value"]) == pytest.approx(ends[0, 0])
    ranges = [f"{round(low, 1):g}° to {round(high, 1):g}°" for low, high in ends.tolist()]
    assert "inside the limits from " + ", ".join(ranges) in found


def test_sliding_joints_are_in_millimetres(capsys: pytest.CaptureFixture[str]) -> None:
    table = said("robot ik cobra 400 100 337 180 0 0", capsys)
    assert "1 [°] 2 [°] 3 [mm] 4 [°] posture" in table
    assert table.count(" 50.000 ") == 2
    beyond = said("robot ik cobra 400 100 137 180 0 0", capsys)
    assert beyond.count("joint 3 by 40.0 mm") == 2


def test_a_tilt_that_an_arm_cannot_have_is_told(capsys: pytest.CaptureFixture[str]) -> None:
    words = said("robot ik cobra 400 100 337 170 0 0", capsys)
    why, beside = words.split(" nearest: ")
    assert why == "no solution: out of task space; the arm cannot tilt its tool, 0.0 mm and 10.0° are missing"
    assert beside.startswith("x 400.0 y 100.0 z 337.0 mm")
    assert beside.endswith(", 0.0 mm and 10.0° away")


@pytest.mark.parametrize(
    ("words", "found"),
    [
        ("fk puma560 0 0 36000.1 0 0 0", "joint `3` is 36000.1°, allowed is up to 36,000° either way"),
        ("fk puma560 -1e300 0 0 0 0 0", "joint `1` is -1e+300°, allowed is up to 36,000° either way"),
        ("fk cobra 0 0 100001 0", "joint `3` is 100001 mm, allowed is up to 100,000 mm either way"),
        ("fk puma560 0 nan 0 0 0 0", "joint `2` is nan, allowed is up to 36,000° either way"),
        ("ik puma560 0 -1e300 0 0 0 0", "`y` is -1e+300 mm, allowed is up to 100,000 mm either way"),
        ("ik puma560 0 0 0 0 0 inf", "`yaw` is inf, allowed is up to 36,000° either way"),
    ],
)
def test_coordinates_beyond_sense_are_refused(
    words: str, found: str, capsys: pytest.CaptureFixture[str]
) -> None:
    assert main(["robot", *words.split()]) == 2
    told = capsys.readouterr()
    assert told.out == ""
    assert f"error[U903] coordinate-beyond-sense: {found}" in told.err


def test_a_hundred_turns_and_a_hundred_metres_are_computed(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["robot", "fk", "cobra", "36000", "-3.6e4", "100000", "0"]) == 0
    assert main(["robot", "ik", "puma560", "-1e5", "0", "0", "0", "0", "0"]) == 1
    assert "out of reach" in capsys.readouterr().out

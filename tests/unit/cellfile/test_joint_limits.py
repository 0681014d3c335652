"""Limits of joints in `[controller]`, and cell files that are given limits."""

import math

import pytest

from ropsim import robots
from ropsim.cellfile import limits_section, read_cell, with_limits, written_limits
from ropsim.core import SourceText
from ropsim.model import JointType, LookAhead, Station
from ropsim.tomltext import diagnostics as kinds
from ropsim.tomltext import with_values

COUNT, TYPE, RANGE = (
    kind.code for kind in (kinds.WRONG_VALUE_COUNT, kinds.WRONG_VALUE_TYPE, kinds.VALUE_OUT_OF_RANGE)
)
HEAD = '[robot]\nmodel = "scara"\n'


def station(text: str, name: str = "robot") -> Station:
    cell, findings = read_cell(SourceText("cell.toml", text), "c")
    assert cell is not None, findings
    return cell.stations[name]


def codes(text: str) -> list[str]:
    return [one.code for one in read_cell(SourceText("cell.toml", text), "c")[1]]


def test_limits_of_joints_are_those_of_the_cell() -> None:
    robot = station(
        f"{HEAD}[controller]\njoint_speed = [90, 180, 500, 360]\njoint_jerk = [1, 2, 3, 4]\n"
    ).robot
    assert robot.max_speeds == pytest.approx([math.pi / 2, math.pi, 0.5, 2 * math.pi])
    assert robot.max_jerks == pytest.approx([math.radians(1), math.radians(2), 0.003, math.radians(4)])
    assert robot.max_accelerations == pytest.approx(robots.load("scara").max_accelerations)
    assert ("joint_speed, joint_jerk", "derived") in [(one.parameters, one.kind) for one in robot.origins]


def test_the_standard_gains_do_not_depend_on_them() -> None:
    changed = station(f"{HEAD}[controller]\njoint_speed = [90, 180, 500, 360]\n")
    assert changed.controller == station(HEAD).controller


@pytest.mark.parametrize(
    ("value", "code"),
    [("[90, 180]", COUNT), ('"fast"', TYPE), ("[0, 180, 500, 360]", RANGE), ("[1e9, 1, 1, 1]", RANGE)],
)
def test_wrong_limits_are_findings(value: str, code: str) -> None:
    assert codes(f"{HEAD}[controller]\njoint_speed = {value}\n") == [code]


@pytest.mark.parametrize(
    "text",
    [
        HEAD,
        f"{HEAD}[controller]\n",
        f"{HEAD}\n[controller] # ours\npath_speed = 100 # mm/s\nkf = [\n 1, 1,\n 1, 1 ] # all\n[signals]\n",
        f"{HEAD}[controller]\npath_speed=100\nlook_ahead= 3",
        f"[units]\nlength = 'm'\nangle = 'rad'\n{HEAD}",
        f"{HEAD}[controller]\npath_speed = 100\n".replace("\n", "\r\n"),
    ],
)
def test_a_cell_file_is_given_limits_and_keeps_all_else(text: str) -> None:
    source = SourceText("cell.toml", text)
    speeds = [1.0, 2.0, 0.25, 4.0]
    axes = [one.measure for one in robots.load("scara").axis_joints]
    values = written_limits(source, axes, {"joint_speed": speeds, "path_speed": 0.7, "look_ahead": 2})
    made = with_limits(source, "robot", values)
    found, before = station(made.text), station(text)
    assert found.robot.max_speeds == pytest.approx(speeds, rel=1e-4)
    assert found.controller.path.speed == pytest.approx(0.7)
    assert found.controller.look_ahead == LookAhead(2, 0.0)
    assert found.controller.gains == before.controller.gains
    assert ("\r\n" in made.text) == ("\r\n" in text)
    for line in text.splitlines():
        if "path_speed" not in line and "look_ahead" not in line:
            assert line in made.text.splitlines()
    assert [one for one in ("# ours", "# mm/s", "# all") if one in text and one not in made.text] == []


def test_a_station_has_its_limits_in_its_own_section() -> None:
    text = '[stations.left]\nrobot = "scara"\nprogram = ""\n[stations.right]\nrobot = "scara"\nprogram = ""\n'
    source = SourceText("cell.toml", text)
    assert limits_section(source, "left") == ("stations", "left", "controller")
    made = with_limits(source, "left", {"look_ahead": "4"})
    assert station(made.text, "left").controller.look_ahead == LookAhead(4, 0.0)
    assert station(made.text, "right").controller.look_ahead == LookAhead()


def test_units_of_the_file_are_written() -> None:
    source = SourceText("cell.toml", "[units]\nlength = 'm'\nangle = 'rad'\n")
    written = written_limits(source, [JointType.REVOLUTE], {"joint_jerk": [12.0], "orientation_speed": 0.5})
    assert written == {"joint_jerk": "[12]", "orientation_speed": "0.5"}


def test_values_that_stand_are_replaced_where_they_stand() -> None:
    text = "[a]\nx = [1, # one\n 2]\ny = 3\n"
    assert with_values(SourceText("t", text), ("a",), {"x": "4", "z": "5"}) == "[a]\nz = 5\nx = 4\ny = 3\n"


def test_several_values_are_replaced_at_once() -> None:
    text = "[a]\nx = 1 # one\ny = 3\nz = 5\n"
    made = with_values(SourceText("t", text), ("a",), {"x": "[40, 50]", "z": "6", "y": "-70"})
    assert made == "[a]\nx = [40, 50] # one\ny = -70\nz = 6\n"


def test_joint_limits_leave_the_path_limits_as_they_are() -> None:
    """Else a calibrated cell would have other path limits at each calibration."""
    changed = station(f"{HEAD}[controller]\njoint_acceleration = [90, 180, 500, 360]\n")
    assert changed.controller.path == station(HEAD).controller.path


def test_path_limits_of_the_file_are_named_in_their_origin() -> None:
    controller = station(f"{HEAD}[controller]\npath_acceleration = 1500\n").controller
    assert controller.path.acceleration == 1.5
    (origin,) = (one for one in controller.origins if one.parameters == "path limits")
    assert origin.source.startswith(
        "path_acceleration as in the cell file; the others what the joints can do"
    )
    (gains,) = (one for one in controller.origins if one.parameters == "controller gains")
    assert "as in the cell file" not in gains.source

"""`ropsim robot show`: what moves the axes, and why an arm is solved numerically."""

from pathlib import Path

import pytest

from ropsim.cli.testing import main

SLIDE = """\
convention = "standard"
joints = [{ alpha = 0, type = "prismatic", limits = [0, 800], speed = 500 }]
"""


def shown(name: str, capsys: pytest.CaptureFixture[str]) -> list[str]:
    assert main(["robot", "show", name]) == 0
    return capsys.readouterr().out.splitlines()


@pytest.mark.parametrize(
    ("name", "lines"),
    [
        ("puma560", ["drives: DC motors, gears of 53.71 to 107.81 to 1"]),
        ("patu655", ["drives: hydraulic cylinders at servo valves"]),
        ("two_link", ["drives: motors that give the torque they are told, directly at the joints"]),
        ("irb120", ["drives: motors that give the torque they are told, gears of 40.93 to 68.75 to 1"]),
        (
            "manutec_r3",
            [
                "drives: motors that give the torque they are told, elastic gears of 60 to 210 to",
                "drives: motors that give the torque they are told, gears of 79.2 to 99 to 1 (3",
            ],
        ),
    ],
)
def test_what_moves_the_axes_is_told(name: str, lines: list[str], capsys: pytest.CaptureFixture[str]) -> None:
    assert [one for one in shown(name, capsys) if one.startswith("drives: ")] == lines


def test_classes_that_an_arm_misses_for_one_reason_stand_on_one_line(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    file = tmp_path / "slide.toml"
    file.write_text(SLIDE)
    lines = shown(str(file), capsys)
    reasons = [one.partition(": ")[2] for one in lines if one.startswith("not ")]
    assert reasons
    assert len(set(reasons)) == len(reasons)


ENDLESS = """\
<robot name="arm"><link name="base"/><link name="upper"/><link name="lower"/>
<joint name="turn" type="continuous"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<origin xyz="0 0 0.3"/><limit velocity="1" effort="10"/></joint>
<joint name="bend" type="revolute"><parent link="upper"/><child link="lower"/><axis xyz="0 1 0"/>
<origin xyz="0 0 0.4"/><limit lower="-1" upper="1" velocity="1" effort="10"/></joint></robot>
"""


def test_a_joint_without_end_has_no_numbers_of_limits(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    place = tmp_path / "arm.urdf"
    place.write_text(ENDLESS, "utf-8")
    for name in (place, tmp_path / "arm.stp"):
        if name != place:
            assert main(["robot", "export", str(place), str(name)]) == 0
            capsys.readouterr()
        assert main(["robot", "show", str(name)]) == 0
        said = capsys.readouterr().out
        (turn,) = (line.split() for line in said.splitlines() if line.startswith("turn"))
        assert turn[2:4] == ["endless", "endless"]
        assert "no position limits: endless in arm.urdf" in " ".join(said.split())


def test_a_picture_of_an_arm_without_shapes_has_its_axes(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "arm.urdf").write_text(ENDLESS, "utf-8")
    assert main(["robot", "show", str(tmp_path / "arm.urdf"), "--png", str(tmp_path / "arm.png")]) == 0
    assert (
        capsys.readouterr()
        .out.splitlines()[-1]
        .endswith("arm.png: axes and rods, as pictures show no meshes and it has no other shapes")
    )
    assert (tmp_path / "arm.png").read_bytes().startswith(b"\x89PNG")


def test_a_missing_mass_is_said_of_joints_and_not_where_it_is_estimated(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "arm.urdf").write_text(ENDLESS, "utf-8")
    main(["robot", "export", str(tmp_path / "arm.urdf"), str(tmp_path / "arm.stp")])
    capsys.readouterr()
    main(["robot", "show", str(tmp_path / "arm.stp")])
    said = capsys.readouterr().err
    assert "X972" in said
    assert "the links that joints `turn`, `bend` move have no mass" in said
    assert "`ropsim robot estimate`" in said
    main(["robot", "estimate", str(tmp_path / "arm.stp"), str(tmp_path / "whole.stp"), "--class", "cobot"])
    assert "X972" not in capsys.readouterr().err


def test_a_report_says_that_a_joint_is_endless_and_not_how_far_its_end_is(
    tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "arm.urdf").write_text(ENDLESS, "utf-8")
    assert main(["new", str(tmp_path / "cell"), "--robot", str(tmp_path / "arm.urdf")]) == 0
    capsys.readouterr()
    assert main(["run", str(tmp_path / "cell")]) == 0
    rows = [line.split() for line in capsys.readouterr().out.splitlines()]
    (turn,) = (row for row in rows if row[:1] == ["turn"])
    (bend,) = (row for row in rows if row[:1] == ["bend"])
    assert "endless" in turn
    assert "endless" not in bend

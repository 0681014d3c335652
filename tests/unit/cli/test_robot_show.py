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

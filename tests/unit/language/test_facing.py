"""Orientations that are hardly meant: the tool up by `rz` alone, quaternions that are not of unit length."""

from dataclasses import replace

import pytest

from support.tasks import CELL, codes, only

HEAD = "program p\nunits mm, deg, s\n"
HANGING = replace(CELL, frames={"ceiling": (0.4, 0.0, 1.5, 0.0, 1.0, 0.0, 0.0)})


@pytest.mark.parametrize(
    ("line", "terms", "up"),
    [
        ("mov (450, 0, 700; {})", "rz 30", "rpy 0 0 30"),
        ("lin (450, 0, 700; {})", "rz -30 deg", "rpy 0 0 -30 deg"),
        ("mov (450, 0, 700; {}, config (left))", "rz 0", "rpy 0 0 0"),
        ("mov (450, 0, 700; {})", "rx 0, rz 30", "rpy 0 0 0, rx 0, rz 30"),
        ("mov (450, 0, 700; {})", "rz 30, ry 0 deg", "rpy 0 0 0, rz 30, ry 0 deg"),
        ("a = 30 deg\nmov (450, 0, 700; {})", "rz a", "rpy 0 0 a"),
        ("loc q = (450, 0, 700; {})\nmov q", "rz 30", "rpy 0 0 30"),
        ("q = (450, 0, 700; {})\nmov q", "rz 30", "rpy 0 0 30"),
        ("mov (450, 0, 700; {}) external (5)", "rz 30", "rpy 0 0 30"),
        ("mov (450, 0, 700; {}) in pallet", "rz 30", "rpy 0 0 30"),
        ("circ via (450, 0, 700; {}) to (450, 90, 700)", "rz 30", "rpy 0 0 30"),
        ("task T(q: loc)\n mov q\nendp\nT((450, 0, 700; {}))", "rz 30", "rpy 0 0 30"),
        ("task T() -> loc\n return (450, 0, 700; {})\nendp\nq = T()\nmov q", "rz 30", "rpy 0 0 30"),
    ],
)
def test_a_turn_about_z_alone_is_told_with_the_fix_down_and_a_way_to_say_up(
    line: str, terms: str, up: str
) -> None:
    found = only(HEAD + line.format(terms))
    assert found.fix is not None
    assert (found.code, found.is_error) == ("T342", False)
    assert found.hint == f"write `down, {terms}`, or `{up}` where up is meant"
    assert found.fix.replacement == f"down, {terms}"
    for meant in (f"down, {terms}", up):
        assert codes(HEAD + line.format(meant)) == []


@pytest.mark.parametrize(
    "line",
    [
        "mov (450, 0, 700)",
        "mov (450, 0, 700; down, rz 30)",
        "mov (450, 0, 700; rx 180, rz 30)",
        "mov (450, 0, 700; rz 30, rx 180)",
        "mov (450, 0, 700; rpy 0 0 0, rz 30)",
        "mov (450, 0, 700; ry 90, rz 30)",
        "mov (450, 0, 700; like infeed, rz 30)",
        "lin infeed rel (0, 0, 10; rz 30)",
        "lin (450, 0, 700; rz 30) rel (0, 0, 10)",
        "lin (450, 0, 700; rz 30) above 20",
        "frame f = (100, 0, 0; rz 30)\nset frame f\nopen",
        "tool t = (0, 0, 100; rz 30)\nset tool t\nopen",
        "frame below = (0, 0, 900; rx 180)\nmov (450, 0, 200; rz 30) in below",
        "frame below = (0, 0, 900; rx 180)\nwith frame below\n mov (450, 0, 200; rz 30)\nendwith",
    ],
)
def test_other_orientations_steps_and_frames_are_believed(line: str) -> None:
    assert codes(HEAD + line) == []


def test_in_a_frame_of_the_cell_whose_z_points_down_nothing_is_said() -> None:
    assert codes(f"{HEAD}set frame ceiling\nmov (450, 0, 700; rz 30)", HANGING) == []


UNDER_CEILING = replace(CELL, frames={"table": (0.4, 0.0, 1.5, 0.0, 1.0, 0.0, 0.0)}, up=(0.0, 0.0, -1.0))


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("mov (450, 0, 700; rz 30)", []),
        ("set frame table\nmov (450, 0, 700; rz 30) in base", []),
        ("frame shelf = (0, 0, 900)\nmov (0, 0, 20; rz 30) in shelf", []),
        ("mov (0, 0, 500; rz 30) in table", ["T342"]),
        ("set frame table\nmov (0, 0, 500; rz 30)", ["T342"]),
        ("mov (0, 0, 500; down, rz 30) in table", []),
    ],
)
def test_for_an_arm_on_the_ceiling_up_is_that_of_the_world(line: str, expected: list[str]) -> None:
    assert codes(HEAD + line, UNDER_CEILING) == expected


def test_for_an_arm_on_the_wall_nothing_is_said_in_its_base_frame() -> None:
    on_wall = replace(CELL, up=(1.0, 0.0, 0.0))
    assert codes(f"{HEAD}mov (450, 0, 700; rz 30)", on_wall) == []


@pytest.mark.parametrize(
    ("written", "unit"),
    [
        ("quat 0 1 1 0", "quat 0 0.7071068 0.7071068 0"),
        ("quat -0.5 0.5 -0.5 0.4", "quat -0.5241424 0.5241424 -0.5241424 0.4193139"),
        ("quat 0 0 2 0", "quat 0 0 1 0"),
        ("quat 0 0.71 0.71 0", "quat 0 0.7071068 0.7071068 0"),
    ],
)
def test_a_quaternion_that_is_not_of_unit_length_is_told_with_its_unit_form(written: str, unit: str) -> None:
    found = only(f"{HEAD}mov (450, 0, 700; {written})")
    assert found.fix is not None
    assert (found.code, found.is_error, found.hint) == ("T343", False, f"write `{unit}`")
    assert found.fix.replacement == unit
    assert codes(f"{HEAD}mov (450, 0, 700; {unit})") == []


@pytest.mark.parametrize(
    "written", ["quat 0 0.7071 0.7071 0", "quat 0.5 -0.5 0.5 0.5", "quat 0 0.707 0.707 0"]
)
def test_a_quaternion_that_was_rounded_is_believed(written: str) -> None:
    assert codes(f"{HEAD}mov (450, 0, 700; {written})") == []

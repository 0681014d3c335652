"""Angles in degrees that look like radians, and lengths in millimetres that look like metres."""

import pytest

from support.tasks import codes, only

HEAD = "program p\nunits mm, deg, s\n"


def readings(text: str) -> list[str]:
    """Return the texts that the hint of the one finding names."""
    found = only(HEAD + text)
    assert (found.code, found.is_error) == ("T338", False)
    return found.hint.split("`")[1::2]


RADIANS = [
    ("circ via (10, 20, 30) to (40, 50, 60) {}", "angle 6.28", ["angle 360 deg", "angle 6.28 rad"]),
    ("mov (450, 0, 700; down, {})", "rz 1.5708", ["rz 90 deg", "rz 1.5708 rad"]),
    ("mov (450, 0, 700; down, {})", "rz -1.57", ["rz -90 deg", "rz -1.57 rad"]),
    ("mov (450, 0, 700; down, {})", "rz 0.7854", ["rz 45 deg", "rz 0.7854 rad"]),
    ("mov (450, 0, 700; {})", "rpy 3.14159 0 0", ["rpy 3.14159 rad 0 rad 0 rad"]),
    ("mov (450, 0, 700; {})", "rpy 3.14159 0 90", ["rpy 3.14159 rad 0 rad 90 rad"]),
    ("mov (450, 0, 700; {})", "euler ZYX 1.57 0 -3.14", ["euler ZYX 1.57 rad 0 rad -3.14 rad"]),
    ("mov (450, 0, 700; {})", "rotvec 0 3.1415 0", ["rotvec 0 rad 3.1415 rad 0 rad"]),
    ("mov {}", "(450, 0, 700, 3.1416, 0, 1.5)", ["(450, 0, 700, 3.1416 rad, 0 rad, 1.5 rad)"]),
]


@pytest.mark.parametrize(("line", "written", "meant"), RADIANS)
def test_an_angle_with_the_digits_of_radians_is_told_and_each_text_of_the_hint_compiles(
    line: str, written: str, meant: list[str]
) -> None:
    assert readings(line.format(written)) == meant
    for text in meant:
        assert codes(HEAD + line.format(text)) == []


@pytest.mark.parametrize(
    "orientation",
    [
        "rz 1.5",
        "rz 3",
        "rz 1.6",
        "rpy 3.14 0 90",
        "rpy 0 0 0",
        "rz 1.57 deg",
        "rz 90",
        "rpy 1 2 3",
        "rz 0.79",
    ],
)
def test_usual_angles_and_those_with_a_unit_are_believed(orientation: str) -> None:
    assert codes(f"{HEAD}mov (450, 0, 700; down, {orientation})") == []


def test_radians_are_believed_where_angles_are_in_radians() -> None:
    assert codes("units mm, rad\nmov (450, 0, 700; rpy 3.14159 0 1.5708)") == []


GRID, BOXES = "pattern s = grid 2 x 2 from", "for each b in s\n mov b\nendf"
METRES = [
    ("loc q = {}\nmov q", "(0.5, -0.25, 0.3)", "(0.5 m, -0.25 m, 0.3 m)"),
    ("loc q = {}\nmov q", "(0.5, 0, 1; down, rz 30)", "(0.5 m, 0 m, 1 m; down, rz 30)"),
    ("mov {}", "(0.5, 0, 0.3, 180, 0, 0)", "(0.5 m, 0 m, 0.3 m, 180, 0, 0)"),
    ("lin infeed {}", "above 0.06", "above 0.06 m"),
    ("lin infeed {}", "blend 0.05", "blend 0.05 m"),
    ("frame f = {}\nset frame f\nopen", "(0.4, 0, 0)", "(0.4 m, 0 m, 0 m)"),
    ("tool t = {}\nset tool t\nopen", "(0, 0, 0.145)", "(0 m, 0 m, 0.145 m)"),
    (f"{GRID} {{}} step (60 mm, 0, 0), (0, 60 mm, 0)\n{BOXES}", "(0.4, 0, 0.1)", "(0.4 m, 0 m, 0.1 m)"),
]


@pytest.mark.parametrize(("line", "written", "meant"), METRES)
def test_a_length_in_metres_is_told_and_each_text_of_the_hint_compiles(
    line: str, written: str, meant: str
) -> None:
    texts = readings(line.format(written))
    assert texts == [meant, meant.replace(" m", " mm")]
    for text in texts:
        assert codes(HEAD + line.format(text)) == []


@pytest.mark.parametrize(
    "line",
    [
        "mov (0, 0, 0)",
        "mov (1, 0, 1)",
        "mov (0.5, 0.3, 2)",
        "mov (0.5, 0, 300)",
        "mov (0.5 m, 0, 0)",
        "mov (0.5 mm, 0 mm, 0.1 mm)",
        f"{GRID} (300, 0, 0) step (1.27, 0, 0), (0, 1.27, 0)\n{BOXES}",
        f"{GRID} (0, 0, 0) step (1.27, 0, 0), (0, 1.27, 0)\n{BOXES}",
        "frame f = (0.3, -0.2, 0; rz 0.5)\nset frame f\nopen",
        "frame f = (0.3, -0.2, 0, 0, 0, 0.5)\nset frame f\nopen",
        "lin (0, 0, 0.2)",
        "lin (0.5, 0.2, 0.2) above 20",
        "lin via (0.5, 0.2, 0.2) to (0.5, 40, 0.2)",
        "lin infeed above 1",
        "lin infeed above 1.5",
        "lin infeed above 0.1",
        "lin infeed blend 0.5",
        "lin infeed above 2.5",
        "lin infeed blend 2",
        "lin infeed offset (0, 0, 0.5)",
        "lin infeed rel (0, 0, -0.2)",
    ],
)
def test_usual_lengths_small_shifts_and_lengths_with_a_unit_are_believed(line: str) -> None:
    assert codes(HEAD + line) == []


@pytest.mark.parametrize("unit", ["m", "cm"])
def test_small_numbers_are_believed_where_lengths_are_in_other_units(unit: str) -> None:
    assert codes(f"units {unit}\nlin (0.5, 0.2, 0.3) blend 0.05") == []


@pytest.mark.parametrize(
    ("written", "meant"),
    [("speed 0.5", "speed 50 %"), ("speed 20", "speed 20 %"), ("acc 1", "acc 100 %")],
)
def test_a_bare_share_of_a_mov_is_one_finding_with_its_fix(written: str, meant: str) -> None:
    found = only(f"{HEAD}mov infeed {written}")
    assert found.fix is not None
    assert (found.code, found.hint, found.fix.replacement) == ("T309", f"write `{meant}`", meant)
    assert codes(f"{HEAD}mov infeed {meant}") == []


@pytest.mark.parametrize(
    ("motion", "written"),
    [("mov", "speed 200"), ("mov", "speed 2"), ("mov", "acc 1 m/s2"), ("lin", "acc 30 %")],
)
def test_any_other_setting_without_effect_is_told_with_an_example_that_compiles(
    motion: str, written: str
) -> None:
    found = only(f"{HEAD}{motion} infeed {written}")
    assert (found.code, found.fix) == ("T309", None)
    assert codes(f"{HEAD}{motion} infeed {found.hint.split('`')[1]}") == []


@pytest.mark.parametrize(("written", "meant"), [("cn", "cm"), ("degs", "deg"), ("kgg", "kg"), ("nm", "Nm")])
def test_a_misspelt_unit_is_the_near_one_with_the_same_first_letter(written: str, meant: str) -> None:
    found = only(f"{HEAD}mov (450, 0, 700) above 60 {written}")
    assert found.hint == f"did you mean `{meant}`?"


@pytest.mark.parametrize("written", ["mn", "kilo", "hz"])
def test_where_no_unit_or_more_than_one_is_near_all_are_listed(written: str) -> None:
    assert only(f"{HEAD}mov (450, 0, 700) above 60 {written}").hint.startswith("units are mm/s2 ")

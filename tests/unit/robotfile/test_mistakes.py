"""Mistakes in robot files: code, place and words of each."""

import pytest

from ropsim.core import Diagnostic, SourceText
from ropsim.robotfile import read_robot_file
from support.robot_files import PUMA560, TWO_JOINTS

ROW = "{ a = 400, limits = [-170, 170], speed = 120 }"
SERVO = '{ kind = "servo", ratio = 50 }'


def found_in(text: str) -> tuple[Diagnostic, ...]:
    read = read_robot_file(SourceText("robots/arm.toml", text))
    assert (read.robot is None) == any(one.is_error for one in read.findings)
    return read.findings


@pytest.mark.parametrize(
    ("before", "after", "code", "marked", "words"),
    [
        (ROW, "{ a = 400, speed = 120 }", "X803", "{ a = 400", "needs `limits`"),
        (ROW, "{ a = 400, limit = [-9, 9] }", "X802", "limit", "`joints.limit` has no meaning"),
        ("[-170, 170]", "[170, -170]", "X806", "[170, -170]", "from 170 deg to -170 deg"),
        ("[-170, 170]", "[-170]", "X805", "[-170]", "needed are 2"),
        ("[-170, 170]", "[-800, 170]", "X806", "-800", "-720 to 720 deg"),
        ("[-170, 170]", '"endles"', "X808", '"endles"', "did you mean `endless`?"),
        ("[-170, 170]", "{ turns = [-1, 401] }", "X806", "401", "-400 to 400 turns"),
        ("[-170, 170]", "{ turns = [2, -1] }", "X806", "[2, -1]", "from 2 turns to -1 turns"),
        ("[-170, 170]", "{ turn = [-1, 1] }", "X802", "turn", "did you mean `turns`?"),
        ("[-170, 170]", "{}", "X803", "limits", "needs `turns`"),
        (ROW, '{ type = "prismatic", limits = "endless" }', "X804", '"endless"', "a list of numbers"),
        ("joints", "gravity = [0, 0, -981]\njoints", "X806", "-981", "-100 to 100 m/s²"),
        ("joints", "gravity = 9.81\njoints", "X804", "9.81", "a list of numbers"),
        ("a = 400", 'a = "400"', "X804", '"400"', "a number"),
        ("a = 400", "a = nan", "X807", "nan", "a number"),
        ("alpha = 180", f"alpha = 1{400 * '0'}", "X806", "1000", "inf deg"),
        ("speed = 120", "speed = 0", "X806", "0", "deg/s"),
        ('"standard"', '"craig"', "X808", '"craig"', "`standard`, `modified`"),
        ('convention = "standard"\n', "", "X803", "", "`convention`"),
        ("a = 400", 'type = "ball"', "X808", '"ball"', "`revolute`, `prismatic`"),
        ("a = 400", 'name = "2", a = 400', "X901", "{ a = 300", "`2`"),
        ("joints", "home = [0, 200]\njoints", "X806", "200", "-150 to 150 deg"),
        ("joints", "home = [0]\njoints", "X805", "[0]", "one per joint"),
        ("joints", "home = 3\njoints", "X804", "3", "a list of numbers"),
        ("joints", "links = [{ mass = 3 }]\njoints", "X805", "[{ mass = 3 }]", "one per joint"),
        ("joints", "links = [{ mass = 3 }, {}]\njoints", "X902", "{}", "link 2 has no mass"),
        ("joints", "mass = 2\nlinks = [{ mass = 3 }, {}]\njoints", "X906", "2", "3 kg"),
        ("joints", f"drives = [{SERVO}, {SERVO}]\njoints", "X903", "drives", "no link has a mass"),
        *(
            ("joints", f"mass = 9\ndrives = [{SERVO}, {{ kind = 'servo', {keys} }}]\njoints", code, at, words)
            for keys, code, at, words in (
                ("coulomb = 2, breakaway = 1, stribeck_speed = 3", "X806", "1", "at least `coulomb`, 2"),
                ("breakaway = 1", "X803", "{ kind = 'servo', breakaway = 1 }", "`stribeck_speed`"),
                ("backlash = 1e-3", "X803", "{ kind = 'servo', backlash = 1e-3 }", "`stiffness`"),
                ("load_share = 1", "X806", "1", "0.99"),
                ("load_share = 0.1, breakaway = 1, stribeck_speed = 3", "X812", "load_share", "two laws"),
            )
        ),
        ("joints", f"mass = 9\ndrives = [{SERVO}]\njoints", "X805", f"[{SERVO}]", "one per joint"),
        ("joints", f"mass = 9\ndrives = [{SERVO}, {{ ratio = 2 }}]\njoints", "X803", "{ ratio", "`kind`"),
        (
            "joints",
            f"mass = 9\ndrives = [{SERVO}, {SERVO}]\njoints".replace("50", "0", 1),
            "X905",
            "0",
            "is 0",
        ),
        (ROW, "{ limits = [-9, 9], coupled = { elbow = 1 } }", "X915", "elbow", "coupled with `elbow`"),
        (ROW, "{ limits = [-9, 9], joint_limits = [-9, 9] }", "X915", "joint_limits", "is not `coupled`"),
        ("joints", "origins = [{ kind = 'known' }]\njoints", "X808", "'known'", "`published`"),
        ("joints", "flange = { positon = [0, 0, 9] }\njoints", "X802", "positon", "no meaning"),
        ("joints", "base = { shapes = [{ cube = 3 }] }\njoints", "X887", "{ cube", "no sort"),
    ],
)
def test_a_mistake_is_told_where_it_stands(
    before: str, after: str, code: str, marked: str, words: str
) -> None:
    text = TWO_JOINTS.replace(before, after, 1)
    assert text != TWO_JOINTS
    source = SourceText("robots/arm.toml", text)
    found = next(one for one in found_in(text) if one.code == code)
    assert found.span is not None
    assert source.line(found.span.line)[found.span.column - 1 :].startswith(marked)
    assert words in f"{found.message} {found.hint}"


@pytest.mark.parametrize("text", ["", "joints = []", "joints = [" + "{ limits = [0, 9] }, " * 33 + "]"])
def test_an_arm_has_one_joint_at_least_and_not_too_many(text: str) -> None:
    assert "X900" in [one.code for one in found_in('convention = "standard"\n' + text)]


def test_a_file_that_is_no_toml_is_told_so() -> None:
    (found,) = found_in("joints = [\n{ a = }")
    assert found.code == "X801"
    assert found.span is not None
    assert found.span.line == 2


@pytest.mark.parametrize(("written", "meant"), [("1.5708", "90"), ("-1.570796", "-90"), ("3.14159", "180")])
def test_angles_that_look_like_radians_are_doubted(written: str, meant: str) -> None:
    (found,) = found_in(TWO_JOINTS.replace("alpha = 180", f"alpha = {written}"))
    assert found.code == "X822"
    assert f"write {meant}," in found.hint
    radians = TWO_JOINTS.replace("alpha = 180", f"alpha = {written}").replace("170", "3").replace("150", "2")
    assert found_in('units = { angle = "rad" }\n' + radians.replace("speed = 1", "acceleration = 1")) == ()


def test_a_set_of_numbers_as_published_is_read_without_a_word() -> None:
    assert found_in(PUMA560) == ()


@pytest.mark.parametrize("reach", [400, 700, 750])
def test_a_reach_that_the_arm_may_have_is_read_without_a_word(reach: int) -> None:
    assert found_in(f"reach = {reach}\n{TWO_JOINTS}") == ()


@pytest.mark.parametrize(("reach", "changed"), [("800", TWO_JOINTS), ("700", TWO_JOINTS.replace("400", "9"))])
def test_a_reach_that_the_lengths_do_not_give_is_doubted(reach: str, changed: str) -> None:
    (found,) = found_in(f"reach = {reach}\n{changed}")
    assert (found.code, found.is_error) == ("X907", False)
    assert f"`reach` is {reach} mm" in found.message


@pytest.mark.parametrize(
    "keys", ["current_bandwidth = 900, limits_current = true", "limits_current = true, max_rise = 90"]
)
def test_keys_of_two_amplifiers_are_told_to_be_apart(keys: str) -> None:
    motor = (
        f"{{ kind = 'dc', ratio = 50, torque_constant = 0.1, resistance = 1, inductance = 1e-3, "
        f"rotor_inertia = 1e-4, max_voltage = 24, max_current = 5, {keys} }}"
    )
    text = TWO_JOINTS.replace("joints", f"mass = 9\ndrives = [{SERVO}, {motor}]\njoints", 1)
    found = found_in(text)
    assert "X812" in [one.code for one in found]
    assert "X802" not in [one.code for one in found]
    assert any("belong to two kinds of amplifiers" in one.message for one in found)

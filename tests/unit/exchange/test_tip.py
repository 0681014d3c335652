"""The link that carries the tool: as requested, by its name, or where the axes of the arm end."""

import pytest

from ropsim.core import SourceText
from ropsim.exchange import ReadOptions, read_urdf
from ropsim.model import ReadRobot, Tip

USUAL, HAND, LAST = (
    "its name is usual",
    "axes behind it move fingers",
    "it is the end with most axes before it",
)


def joint(name: str, parent: str, child: str, kind: str = "continuous", follows: str = "") -> str:
    """Return a joint and the link that it moves."""
    mimic = f'<mimic joint="{follows}"/>' if follows else ""
    limit = '<limit lower="0" upper="0.04" velocity="1" effort="1"/>' if kind == "prismatic" else ""
    return (
        f'<link name="{child}"/><joint name="{name}" type="{kind}"><parent link="{parent}"/>'
        f'<child link="{child}"/><axis xyz="0 0 1"/><origin xyz="0.1 0 0"/>{mimic}{limit}</joint>'
    )


def chain(prefix: str, count: int, parent: str = "base") -> str:
    """Return axes one behind the other; the links are `prefix1`, `prefix2` and so on."""
    names = [parent, *(f"{prefix}{k}" for k in range(1, count + 1))]
    return "".join(joint(f"to_{child}", names[k], child) for k, child in enumerate(names[1:]))


VISUAL, COLLISION = (
    f'<{kind}><geometry><sphere radius="0.05"/></geometry></{kind}>' for kind in ("visual", "collision")
)


def solid(parent: str, child: str, shapes: str, xyz: str = "0 0 0") -> str:
    """Return a link with shapes and the joint that fixes it."""
    return (
        f'<link name="{child}">{shapes}</link><joint name="to_{child}" type="fixed"><parent link="{parent}"/>'
        f'<child link="{child}"/><origin xyz="{xyz}"/></joint>'
    )


def drawn_chain(count: int) -> str:
    """Return a chain of axes whose links have visual geometry."""
    text = chain("a", count)
    for k in range(1, count + 1):
        text = text.replace(f'<link name="a{k}"/>', f'<link name="a{k}">{VISUAL}{COLLISION}</link>')
    return text


def read(*parts: str, tip: str | None = None) -> ReadRobot:
    text = f'<robot name="r"><link name="base"/>{"".join(parts)}</robot>'
    return read_urdf(SourceText("r.urdf", text), ReadOptions(tip))


FINGERS = joint("f1", "hand", "finger1", "prismatic") + joint("f2", "hand", "finger2", "prismatic", "f1")
HAND_ON_TWO = chain("a", 2) + joint("mount", "a2", "hand", "fixed")


@pytest.mark.parametrize(
    ("parts", "tip", "axes", "reason"),
    [
        pytest.param([HAND_ON_TWO, FINGERS], "hand", 2, HAND, id="two fingers, one follows"),
        pytest.param([chain("a", 6), *(chain(f, 3, "a6") for f in "xyz")], "a6", 6, HAND, id="three fingers"),
        pytest.param([chain("a", 6), joint("jaw", "a6", "jaw")], "a6", 6, HAND, id="one jaw"),
        pytest.param([chain("a", 7)], "a7", 7, LAST, id="a chain"),
        pytest.param(
            [chain("a", 6), joint("m", "a6", "plate", "fixed")], "plate", 6, LAST, id="a fixed link"
        ),
        pytest.param(
            [chain("a", 6), joint("m", "a6", "plate", "fixed"), joint("n", "a6", "camera", "fixed")],
            "plate",
            6,
            LAST,
            id="a camera is no end",
        ),
        pytest.param(
            [chain("a", 6), joint("m", "a6", "left_plate", "fixed"), joint("n", "a6", "ee_link8", "fixed")],
            "ee_link8",
            6,
            LAST,
            id="a usual name in a fork",
        ),
        pytest.param(
            [
                chain("a", 6),
                joint("m", "a6", "end_effector_link", "fixed"),
                *(joint(f"n{k}", "end_effector_link", f"camera_{k}", "fixed") for k in (1, 2)),
            ],
            "end_effector_link",
            6,
            LAST,
            id="cameras on the interface",
        ),
        pytest.param(
            [chain("a", 6), joint("m", "a6", "plate", "fixed"), solid("a6", "lump", VISUAL)],
            "plate",
            6,
            LAST,
            id="an empty frame at a distance beside a body",
        ),
        pytest.param(
            [chain("a", 8), *(chain(f, 7, "a8") for f in "xyz")], "a8", 8, HAND, id="a hand of many axes"
        ),
        pytest.param(
            [chain("a", 6), joint("w1", "base", "wheel1"), joint("w2", "base", "wheel2")],
            "a6",
            6,
            LAST,
            id="an arm on wheels",
        ),
        pytest.param(
            [chain("torso", 1), chain("head", 2, "torso1"), chain("a", 6, "torso1")],
            "a6",
            7,
            LAST,
            id="an arm beside a head",
        ),
        pytest.param(
            [HAND_ON_TWO, FINGERS, joint("t", "finger1", "tool0", "fixed")],
            "tool0",
            3,
            USUAL,
            id="a name behind a finger",
        ),
        pytest.param(
            [joint("t", "base", "tool0", "fixed"), chain("a", 3)],
            "a3",
            3,
            LAST,
            id="a usual name that no axis moves",
        ),
    ],
)
def test_the_tip_is_where_the_arm_ends(parts: list[str], tip: str, axes: int, reason: str) -> None:
    found = read(*parts)
    assert found.tip == Tip(tip, reason)
    assert found.robot is not None
    assert found.robot.n == axes


def test_rods_that_follow_axes_of_the_arm_are_no_fingers() -> None:
    """A palletizer: two rods keep the plate level, and a last axis turns it."""
    rods = (
        joint("rod", "base", "rod", follows="to_a2")
        + joint("knee", "a2", "knee", follows="to_a3")
        + joint("plate", "a3", "plate", follows="to_a2")
        + joint("rod2", "a3", "rod2", follows="to_a3")
        + joint("turn", "plate", "turn")
    )
    found = read(chain("a", 3), rods)
    assert found.tip == Tip("turn", LAST)
    assert found.robot is not None
    assert found.robot.n == 4


def test_a_requested_tip_counts_before_all_others() -> None:
    found = read(HAND_ON_TWO, FINGERS, joint("t", "hand", "tool0", "fixed"), tip="finger1")
    assert found.tip == Tip("finger1", "as requested")
    assert found.robot is not None
    assert found.robot.n == 3


def test_two_ends_that_are_alike_are_both_named_and_one_option_answers() -> None:
    arms = chain("left", 6), chain("right", 6)
    found = read(*arms)
    assert found.robot is None
    (error,) = (one for one in found.findings if one.is_error)
    assert error.code == "X988"
    assert "`left6`, `right6`" in error.message
    assert "--tip left6" in error.hint
    chosen = read(*arms, tip="right6")
    assert chosen.robot is not None
    assert [one.name for one in chosen.robot.joints] == [f"to_right{k}" for k in range(1, 7)]


def test_ends_of_the_same_usual_name_are_named_too() -> None:
    mounts = (joint(f"m_{side}", f"{side}6", f"{side}_tool0", "fixed") for side in ("left", "right"))
    found = read(chain("left", 6), chain("right", 6), *mounts)
    (error,) = (one for one in found.findings if one.is_error)
    assert "`left_tool0`, `right_tool0`" in error.message


def test_a_flange_beside_collision_geometry_of_the_last_link_is_the_tip() -> None:
    """The flange of Franka's own files is 107 mm before the last link, beside capsules for self-collision."""
    parts = drawn_chain(7), solid("a7", "a7_sc", COLLISION), joint("j8", "a7", "a8", "fixed")
    found = read(*parts)
    assert found.tip == Tip("a8", LAST)
    assert found.robot is not None
    assert found.robot.X_nM.position.tolist() == [0.1, 0.0, 0.0]


def test_frames_that_are_equally_good_are_both_named() -> None:
    body = solid("a6", "lump", VISUAL)
    mounts = (joint(f"m{k}", "a6", f"place_{k}", "fixed") for k in (1, 2))
    found = read(chain("a", 6), body, *mounts)
    (error,) = (one for one in found.findings if one.is_error)
    assert error.code == "X988"
    assert "`place_1`, `place_2`" in error.message


@pytest.mark.parametrize(("turned", "tip"), [("0 0 0", "arm_ee"), ("0 1.5707963267948966 0", "maker")])
def test_of_two_frames_at_one_place_the_tip_is_along_the_last_axis(turned: str, tip: str) -> None:
    named = joint("m", "a6", "arm_ee", "fixed").replace('xyz="0.1 0 0"', f'xyz="0.1 0 0" rpy="{turned}"')
    found = read(chain("a", 6), named, joint("n", "a6", "maker", "fixed"))
    assert found.tip == Tip(tip, LAST)


def test_ends_of_fingers_are_named_with_the_palm() -> None:
    found = read(chain("a", 6), *(chain(f, 5, "a6") for f in "xy"))
    (error,) = (one for one in found.findings if one.is_error)
    assert "`a6`, `x5`, `y5`" in error.message
    assert "--tip a6" in error.hint


def test_collision_geometry_around_a_drawn_link_is_not_drawn() -> None:
    found = read(drawn_chain(2), solid("a2", "a2_sc", COLLISION), joint("m", "a2", "a3", "fixed"))
    assert found.robot is not None
    assert [len(one.shapes) for one in found.robot.links] == [1, 1]
    (lost,) = (one for one in found.findings if one.code == "X995")
    assert "links `a2_sc` are collision geometry around a link that is drawn" in "".join(lost.notes)


@pytest.mark.parametrize(
    ("shapes", "xyz"),
    [
        pytest.param(VISUAL, "0 0 0", id="visual geometry"),
        pytest.param(COLLISION, "0 0 0.2", id="a body elsewhere"),
    ],
)
def test_other_bodies_that_are_fixed_to_a_drawn_link_are_drawn(shapes: str, xyz: str) -> None:
    found = read(drawn_chain(2), solid("a2", "plate", shapes, xyz))
    assert found.robot is not None
    assert len(found.robot.links[1].shapes) == 2


def test_collision_geometry_of_a_link_that_is_not_drawn_is_drawn() -> None:
    found = read(chain("a", 2), solid("a2", "a2_sc", COLLISION))
    assert found.robot is not None
    assert len(found.robot.links[1].shapes) == 1

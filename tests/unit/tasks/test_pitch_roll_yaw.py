"""Pitch, roll and yaw mean the same in dialogue, lists of points, studio and task language."""

from collections.abc import Callable, Iterator
from math import cos, radians, sin
from random import Random

import numpy as np
import pytest

from ropsim import robots
from ropsim.core import SourceText
from ropsim.icr import run
from ropsim.kinematics import forward
from ropsim.language import Environment, compile
from ropsim.spatial import Array, Pose, pitch_roll_yaw
from ropsim.studio.testing import typed_text
from ropsim.tasks import (
    ApproachPose,
    Coordinates,
    PointList,
    TaskCall,
    call_of,
    point_text,
    typed_numbers,
    typed_points,
)
from ropsim.tasks.testing import points_of, points_text, typed_point

PUMA = robots.load("puma560")
SEED, COUNT = 7, 1000
CLOSE = 1e-9
"""Directions through a few products of quaternions [without unit]."""
SHOWN = 2e-4
"""Typed texts of a jogged pose have three digits of a degree, and three angles [rad]."""


def _poses() -> tuple[tuple[float, ...], ...]:
    """Return X Y Z [mm] Pitch Roll Yaw [deg]: random ones, and the upright and level ones."""
    random = Random(SEED)
    corners = [
        (400.0, -300.0, 40.0, p, r, y) for p in (90, -90, 0) for r in (0, 90, 30) for y in (0, 180, -36)
    ]
    others = (
        (
            *(round(random.uniform(-900, 900), 1) for _ in range(3)),
            *(round(random.uniform(-180, 180), 2) for _ in range(3)),
        )
        for _ in range(COUNT - len(corners))
    )
    return (*corners, *others)


POSES = _poses()


def _independent(pitch: float, roll: float, yaw: float) -> tuple[Array, Array]:
    """Return z and x of the tool: the approach direction by hand, and x as roll turns it about z [deg]."""
    p, r, y = map(radians, (pitch, roll, yaw))
    z = np.array([cos(p) * cos(y), cos(p) * sin(y), -sin(p)])
    upright = np.array([-sin(p) * cos(y), -sin(p) * sin(y), -cos(p)])
    side = np.cross(z, upright)
    return z, cos(r) * upright + sin(r) * side


def _compiled(places: Iterator[str]) -> list[Pose]:
    lines = "\n".join(f"mov {one}" for one in places)
    code = compile(f"program p\nunits mm, deg, s\n{lines}\n", Environment()).icr
    assert code is not None
    targets = [move.target for move in run(code).moves]
    assert all(isinstance(one, Pose) for one in targets)
    return [one for one in targets if isinstance(one, Pose)]


def _text(numbers: tuple[float, ...]) -> str:
    return " ".join(map(repr, numbers))


def _dialogue(poses: tuple[tuple[float, ...], ...]) -> Iterator[str]:
    for numbers in poses:
        (point,) = typed_points(_text(numbers), {})
        yield point_text(point)


def _call(poses: tuple[tuple[float, ...], ...]) -> Iterator[str]:
    for text in _dialogue(poses):
        yield point_text(call_of(f"park {text}").points[0])


def _list(poses: tuple[tuple[float, ...], ...]) -> Iterator[str]:
    rows = "\n".join(f"p{k},{','.join(map(repr, numbers))}" for k, numbers in enumerate(poses))
    found, findings = points_of(SourceText("p.csv", f"name,x,y,z,pitch,roll,yaw\n,{UNITS}\n{rows}\n"), "p")
    assert (found is not None, findings) == (True, ())
    written, _ = points_of(SourceText("p.csv", points_text(found.points if found else ())), "p")
    assert written == found
    yield from (point_text(point) for _, point in (found.points if found else ()))


def _language(poses: tuple[tuple[float, ...], ...]) -> Iterator[str]:
    for x, y, z, pitch, roll, yaw in poses:
        yield f"({x}, {y}, {z}; pitch {pitch}, roll {roll}, yaw {yaw})"


UNITS = "mm,mm,mm,deg,deg,deg"
Door = Callable[[tuple[tuple[float, ...], ...]], Iterator[str]]


@pytest.mark.slow
@pytest.mark.parametrize("door", [_dialogue, _call, _list, _language])
def test_a_thousand_poses_have_the_same_tool_vectors_through_every_door(door: Door) -> None:
    for numbers, X_BT in zip(POSES, _compiled(door(POSES)), strict=True):
        z, x = _independent(*numbers[3:])
        R = X_BT.rotation()
        assert R[:, 2] == pytest.approx(z, abs=CLOSE), numbers
        assert R[:, 0] == pytest.approx(x, abs=CLOSE), numbers
        assert 1e3 * X_BT.position == pytest.approx(np.array(numbers[:3]), abs=1e-9)


def test_tool_down_stays_tool_down_with_a_yaw_of_zero_behind_it() -> None:
    five, six = _compiled(
        _dialogue(((400.0, -300.0, 40.0, 90.0, 0.0), (400.0, -300.0, 40.0, 90.0, 0.0, 0.0)))
    )
    assert five.rotation()[:, 2] == pytest.approx((0, 0, -1), abs=CLOSE)
    assert six.rotation()[:, 2] == pytest.approx((0, 0, -1), abs=CLOSE)


def test_five_numbers_have_the_azimuth_of_the_point_for_their_yaw() -> None:
    five = tuple(numbers[:5] for numbers in POSES)
    six = tuple((*one, float(np.degrees(np.arctan2(one[1], one[0])))) for one in five)
    for X_B5, X_B6 in zip(_compiled(_dialogue(five)), _compiled(_dialogue(six)), strict=True):
        assert X_B5.rotation() == pytest.approx(X_B6.rotation(), abs=CLOSE)
    on_x = ((500.0, 0.0, 40.0, 20.0, 30.0), (500.0, 0.0, 40.0, 20.0, 30.0, 0.0))
    one, other = _compiled(_dialogue(on_x))
    assert one.rotation() == pytest.approx(other.rotation(), abs=CLOSE)


def test_shown_numbers_give_the_pose_that_they_are_shown_for() -> None:
    """What a table shows, what the jog panel gives, and what a list has for six numbers of task text."""
    poses = _compiled(_language(POSES))
    shown = tuple((*(1e3 * X.position).tolist(), *np.degrees(pitch_roll_yaw(X)).tolist()) for X in poses)
    for X, again in zip(poses, _compiled(_dialogue(shown)), strict=True):
        assert again.rotation() == pytest.approx(X.rotation(), abs=2e-9)


def test_six_numbers_of_task_text_are_roll_pitch_yaw_and_are_listed_as_pitch_roll_yaw() -> None:
    plain: list[Coordinates] = [(*numbers[:3], *numbers[3:]) for numbers in POSES]
    typed = [typed_point(typed_numbers(one)) for one in plain]
    assert all(isinstance(one, ApproachPose) for one in typed)
    places = zip(_compiled(map(_tuple, plain)), _compiled(map(point_text, typed)), strict=True)
    for X, again in places:
        assert again.rotation() == pytest.approx(X.rotation(), abs=2e-9)
    assert _compiled(map(point_text, plain)) == _compiled(map(_tuple, plain))


def _tuple(point: Coordinates) -> str:
    assert isinstance(point, tuple)
    return f"({', '.join(map(repr, point))})"


def test_a_jogged_pose_is_typed_as_it_stands() -> None:

    random = Random(SEED)
    tool = Pose(np.array([0.0, 0.0, 0.145]))
    coordinates = [np.array([random.uniform(-2.5, 2.5) for _ in range(6)]) for _ in range(50)]
    texts = [typed_text(PUMA, tool, np.clip(q, PUMA.lower_limits, PUMA.upper_limits)) for q in coordinates]
    places = _compiled(point_text(typed_points(one, {})[0]) for one in texts)
    for q, X_BT in zip(coordinates, places, strict=True):
        expected = forward(PUMA, np.clip(q, PUMA.lower_limits, PUMA.upper_limits)) @ tool
        assert X_BT.rotation() == pytest.approx(expected.rotation(), abs=SHOWN)


def test_a_list_may_leave_the_yaw_of_some_points_out() -> None:
    text = f"name,x,y,z,pitch,roll,yaw\n,{UNITS}\na,400,-300,40,90,0,\nb,400,-300,40,90,0,0\n"
    found, findings = points_of(SourceText("p.csv", text), "p")
    assert findings == ()
    a, b = (400.0, -300.0, 40.0, 90.0, 0.0), ApproachPose(400.0, -300.0, 40.0, 90.0, 0.0, 0.0)
    assert found == PointList("p", (("a", a), ("b", b)))
    assert str(TaskCall("park", (b,))) == "park (400, -300, 40; pitch 90, roll 0, yaw 0)"


def test_tool_down_is_shown_without_a_minus_before_half_a_turn() -> None:
    for text in ("(400, 0, 100)", "(400, 0, 100, 180, 0, 0)", "(-400, 0, 100; down)", "(400, 0, 0; rx -180)"):
        (X,) = _compiled(iter((text,)))
        assert np.degrees(pitch_roll_yaw(X)).tolist() == pytest.approx([90.0, 0.0, 180.0])

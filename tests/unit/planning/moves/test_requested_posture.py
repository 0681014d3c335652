"""Postures and turns that a program asks for."""

import re
from dataclasses import replace

import numpy as np
import pytest

from ropsim.flow import PostureRequest
from ropsim.kinematics import forward, posture
from ropsim.spatial import Pose
from support.motion import PUMA, START, lin, planned, ptp, refused

TARGET = forward(PUMA, START + 0.1)
NEAR = Pose(TARGET.position, TARGET.orientation)


@pytest.mark.parametrize("words", [("flip",), ("noflip",), ("right",), ("up", "flip"), ()])
def test_a_target_is_reached_in_the_posture_asked_for(words: tuple[str, ...]) -> None:
    move = replace(ptp(NEAR), posture=PostureRequest(words))
    plan = planned(move)
    assert set(words) <= set(posture(PUMA, plan.q_end).words)
    assert forward(PUMA, plan.q_end).position == pytest.approx(NEAR.position, abs=1e-9)


@pytest.mark.parametrize("turn", [0, -1])
def test_an_axis_is_in_the_turn_asked_for(turn: int) -> None:
    there = START.copy()
    there[5] = 2.8  # and 2.8 - 2π within its limits, too
    move = replace(ptp(forward(PUMA, there)), posture=PostureRequest((), (0, 0, 0, 0, 0, turn)))
    q = planned(move).q_end
    assert int(np.floor((q[5] + np.pi) / (2.0 * np.pi))) == turn


def test_what_is_beyond_the_limits_is_refused() -> None:
    move = replace(ptp(NEAR), posture=PostureRequest((), (3,)))
    assert refused(move).code == "M568"


ASKED = [
    PostureRequest(("left",)),
    PostureRequest(("left", "up", "flip")),
    PostureRequest(("left", "down"), (0, 0)),
    PostureRequest((), (3,)),
    PostureRequest(("right", "flip"), (0, 0, 0, 0, 0, 5)),
]


def ways(hint: str) -> list[PostureRequest]:
    """Return what a hint says that a program may ask for."""
    found = []
    for text in hint.split("`")[1::2]:
        words, turns = (re.search(rf"{word} \(([^)]*)\)", text) for word in ("config", "turns"))
        found.append(
            PostureRequest(
                tuple(words[1].split(", ")) if words else (),
                tuple(map(int, turns[1].split(", "))) if turns else (),
            )
        )
    return found


@pytest.mark.parametrize("request_", ASKED)
def test_a_refused_posture_comes_with_those_that_are_possible(request_: PostureRequest) -> None:
    possible = ways(refused(replace(ptp(NEAR), posture=request_)).hint)
    assert possible
    for one in possible:
        q = planned(replace(ptp(NEAR), posture=one)).q_end
        assert set(one.words) == set(posture(PUMA, q).words)


@pytest.mark.parametrize("request_", ASKED)
def test_the_postures_nearest_to_the_words_come_first(request_: PostureRequest) -> None:
    possible = ways(refused(replace(ptp(NEAR), posture=request_)).hint)
    missing = [len(set(request_.words) - set(one.words)) for one in possible]
    assert missing == sorted(missing)


def test_a_target_beyond_the_limits_in_all_postures_is_told_as_without_one() -> None:
    beyond = START.copy()
    beyond[1] = PUMA.upper_limits[1] + 0.3
    move = ptp(forward(PUMA, beyond))
    assert refused(replace(move, posture=PostureRequest(("left",)))) == refused(move)


def test_a_line_that_ends_otherwise_tells_so() -> None:
    own, other = posture(PUMA, START).words[2], {"flip": "noflip", "noflip": "flip"}
    kept = planned(replace(lin(NEAR), posture=PostureRequest((own,))))
    assert [one.code for one in kept.findings] == []
    told = planned(replace(lin(NEAR), posture=PostureRequest((other[own],))))
    assert [one.code for one in told.findings] == ["M569"]

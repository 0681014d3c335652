"""Postures and turns that a program asks for."""

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


def test_a_line_that_ends_otherwise_tells_so() -> None:
    own, other = posture(PUMA, START).words[2], {"flip": "noflip", "noflip": "flip"}
    kept = planned(replace(lin(NEAR), posture=PostureRequest((own,))))
    assert [one.code for one in kept.findings] == []
    told = planned(replace(lin(NEAR), posture=PostureRequest((other[own],))))
    assert [one.code for one in told.findings] == ["M569"]

import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import Posture, posture, solver_of
from support.arms import random_arm

PUMA = robots.load("puma560")


def test_rows_count_wrist_then_elbow_then_shoulder() -> None:
    solver = solver_of(PUMA)
    assert solver.parts == ("shoulder", "elbow", "wrist")
    assert len(set(solver.postures)) == 8
    assert str(solver.postures[0]) == "left-up-noflip"
    assert str(solver.postures[6]) == "right-down-noflip"


@pytest.mark.parametrize(
    ("q", "expected"),
    [
        # Upper arm level ahead, forearm up: the wrist centre is in front, the elbow below the line to it.
        ([0.0, 0.0, 0.0, 0.0, 0.5, 0.0], Posture(("right", "down", "flip"))),
        # Upper arm up, forearm level ahead: the elbow is above.
        ([0.0, 1.57, -3.0, 0.0, -0.5, 0.0], Posture(("right", "up", "noflip"))),
        # Upper arm up, forearm level behind.
        ([0.0, 1.57, 0.0, 0.0, -0.5, 0.0], Posture(("left", "up", "noflip"))),
        # Upper arm level behind, forearm up.
        ([0.0, 3.14, -3.0, 0.0, 0.5, 0.0], Posture(("left", "down", "flip"))),
    ],
)
def test_postures_are_what_one_sees(q: list[float], expected: Posture) -> None:
    assert posture(PUMA, q) == expected


def test_whole_turns_do_not_change_the_posture() -> None:
    q = PUMA.home.copy()
    q[3] += 6.283185307179586
    assert posture(PUMA, q) == posture(PUMA, PUMA.home)


def test_a_straight_wrist_counts_as_not_flipped() -> None:
    assert posture(PUMA, [0.1, -1.0, 0.2, 0.3, 0.0, 0.4]).words[2] == "noflip"


def test_postures_of_arms_outside_all_classes_have_no_words() -> None:
    assert str(posture(random_arm(1, "RRRRRR"), [0.0] * 6)) == "unnamed"


def test_a_wrong_number_of_coordinates_is_refused() -> None:
    with pytest.raises(kinematics.ArrayShapeError):
        posture(PUMA, [0.0] * 7)

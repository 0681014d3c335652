import pytest

from ropsim import kinematics, robots
from ropsim.kinematics import POSTURES, Elbow, NoClosedFormError, Posture, Shoulder, Wrist, posture

PUMA = robots.load("puma560")


def test_rows_count_wrist_then_elbow_then_shoulder() -> None:
    assert [each.index for each in POSTURES] == list(range(8))
    assert str(POSTURES[0]) == "left-up-noflip"
    assert str(POSTURES[6]) == "right-down-noflip"


@pytest.mark.parametrize(
    ("q", "expected"),
    [
        # Upper arm level ahead, forearm up: the wrist centre is in front, the elbow below the line to it.
        ([0.0, 0.0, 0.0, 0.0, 0.5, 0.0], Posture(Shoulder.RIGHT, Elbow.DOWN, Wrist.FLIP)),
        # Upper arm up, forearm level ahead: the elbow is above.
        ([0.0, 1.57, -3.0, 0.0, -0.5, 0.0], Posture(Shoulder.RIGHT, Elbow.UP, Wrist.NOFLIP)),
        # Upper arm up, forearm level behind.
        ([0.0, 1.57, 0.0, 0.0, -0.5, 0.0], Posture(Shoulder.LEFT, Elbow.UP, Wrist.NOFLIP)),
        # Upper arm level behind, forearm up.
        ([0.0, 3.14, -3.0, 0.0, 0.5, 0.0], Posture(Shoulder.LEFT, Elbow.DOWN, Wrist.FLIP)),
    ],
)
def test_postures_are_what_one_sees(q: list[float], expected: Posture) -> None:
    assert posture(PUMA, q) == expected


def test_whole_turns_do_not_change_the_posture() -> None:
    q = PUMA.home.copy()
    q[3] += 6.283185307179586
    assert posture(PUMA, q) == posture(PUMA, PUMA.home)


def test_a_straight_wrist_counts_as_not_flipped() -> None:
    assert posture(PUMA, [0.1, -1.0, 0.2, 0.3, 0.0, 0.4]).wrist is Wrist.NOFLIP


def test_arms_outside_the_class_have_no_posture() -> None:
    with pytest.raises(NoClosedFormError):
        posture(robots.load("two_link"), [0.0, 0.0])


def test_a_wrong_number_of_coordinates_is_refused() -> None:
    with pytest.raises(kinematics.ArrayShapeError):
        posture(PUMA, [0.0] * 7)

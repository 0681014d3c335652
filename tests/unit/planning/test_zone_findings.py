"""What is said where the arm stops though it was to pass by."""

import pytest

from ropsim.flow import ModalState
from ropsim.planning.testing import Stop, stopped
from support.motion import FINE, LINE, START, interface_pose, lin

TARGET = interface_pose(START)
ZONE, VIA = ModalState(zone=0.02), ModalState(passes=True)


@pytest.mark.parametrize("why", Stop)
def test_a_zone_that_is_not_flown_is_told_and_so_is_a_via_point_that_is_not_passed_by(why: Stop) -> None:
    (zone,), (via,) = (stopped(lin(TARGET, modal, visit=1), why) for modal in (ZONE, VIA))
    assert (zone.code, zone.span, via.code, via.span) == ("M560", LINE, "M560", LINE)
    assert "its zone of 20 mm is not flown" in zone.message
    assert "the via point is not passed by" in via.message
    assert why.value in zone.message
    assert why.value in via.message
    assert "fine" in zone.hint
    assert "fine" not in via.hint


def test_a_stop_that_was_asked_for_says_nothing() -> None:
    assert stopped(lin(TARGET, FINE, visit=1), Stop.NO_WAY_TO) == ()

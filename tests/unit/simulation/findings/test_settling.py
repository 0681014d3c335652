from collections.abc import Sequence

import pytest

from ropsim import robots
from ropsim.core import Severity, Span
from ropsim.flow import Event, MotionKind, MoveEvent, Origin
from ropsim.simulation.testing import FinishedStation, Tally, Track, settling_findings

DURATION = 100.0


def moves(*settles: float) -> list[Event]:
    """Return a move of a second on each line, with its time of settling [s]."""
    return [
        MoveEvent(
            float(k),
            1.0,
            "robot",
            Origin(Span("main.task", k + 1, 1, k + 1, 1), 3),
            motion=MotionKind.LIN,
            ordinal=k,
            settle=settle,
        )
        for k, settle in enumerate(settles)
    ]


def finished(events: Sequence[Event], duration: float = DURATION) -> FinishedStation:
    """Return a station with some events."""
    robot = robots.load("scara")
    return FinishedStation(robot, "main.task", 1000, duration, Tally((), 0), Track(), Track(), events)


def test_settling_over_two_per_cent_is_a_hint_on_the_line_of_the_longest() -> None:
    (found,) = settling_findings(finished(moves(0.9, 1.2, 0.01)))
    assert (found.code, found.severity) == ("S725", Severity.HINT)
    assert found.span is not None
    assert found.span.line == 2
    assert "2.11 s, 2.1 %" in found.message
    assert "1.200 s, pass 3" in found.label
    assert found.data["slow_moves"] == 2
    assert found.data["time_s"] == pytest.approx(1.0 + 1.0 - 1.2)


@pytest.mark.parametrize(
    "settles",
    [
        (1.0, 0.9),  # below two per cent
        (0.02,) * 101,  # above, but each move is quick
        (),
    ],
)
def test_little_or_quick_settling_is_no_finding(settles: tuple[float, ...]) -> None:
    assert settling_findings(finished(moves(*settles))) == ()


def test_a_run_of_no_length_has_no_share() -> None:
    assert settling_findings(finished(moves(0.5), 0.0)) == ()

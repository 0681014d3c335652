"""What follows from a move that was left out is told with its line."""

from collections.abc import Iterator

import pytest

from ropsim.core import Diagnostic, SourceText
from ropsim.flow import Event, GripEvent, MoveEvent, Origin, ReleaseEvent, SkipEvent
from ropsim.simulation.testing import NOT_AT_DESTINATION, NOTHING_GRASPED, RELEASED_IN_THE_AIR, with_causes
from ropsim.views import group_findings
from ropsim.views.testing import below_causes

SOURCE = SourceText("main.task", "\n" * 30)


def origin(line: int, visit: int = 1) -> Origin:
    return Origin(SOURCE.span(line), visit)


def move(line: int, visit: int = 1, station: str = "robot") -> Event:
    return MoveEvent(1.0, 1.0, station, origin(line, visit), motion="PTP", ordinal=0)


def skip(line: int, visit: int = 1, station: str = "robot") -> Event:
    return SkipEvent(1.0, 0.0, station, origin(line, visit), motion="LIN")


def empty_grip(line: int, visit: int = 1) -> tuple[Event, Diagnostic]:
    event = GripEvent(1.0, 0.1, "robot", origin(line, visit))
    return event, NOTHING_GRASPED.at(SOURCE.span(line), "no part", data={"pass": visit})


def lines(found: list[Diagnostic]) -> Iterator[object]:
    return (one.data.get("follows_line") for one in found)


def test_an_empty_grip_follows_from_the_move_before_it_that_was_left_out() -> None:
    first, missed = empty_grip(8)
    again, missed_again = empty_grip(8, visit=2)
    events = [move(6), skip(7), first, move(9), move(6, 2), move(7, 2), again]
    assert [*lines(with_causes([missed, missed_again], events))] == [7, None]


def test_a_move_that_another_station_left_out_is_no_cause_of_a_grip() -> None:
    event, missed = empty_grip(8)
    assert [*lines(with_causes([missed], [move(6), skip(7, station="other"), event]))] == [None]


def test_a_release_in_the_air_follows_likewise() -> None:
    event = ReleaseEvent(1.0, 0.1, "robot", origin(12), part="box")
    falls = RELEASED_IN_THE_AIR.at(SOURCE.span(12), "it falls", data={"pass": 1})
    assert [*lines(with_causes([falls], [skip(11), event]))] == [11]


@pytest.mark.parametrize(
    ("events", "line"),
    [([move(6), skip(7), skip(9)], 7), ([move(6), empty_grip(8)[0]], 8), ([move(6)], None)],
)
def test_a_part_astray_follows_from_the_first_thing_that_went_wrong(
    events: list[Event], line: int | None
) -> None:
    assert [*lines(with_causes([NOT_AT_DESTINATION.at(None, "astray")], events))] == [line]


def test_what_follows_is_listed_behind_its_cause() -> None:
    event, missed = empty_grip(8)
    refused = NOTHING_GRASPED.at(SOURCE.span(7), "refused")
    other = NOTHING_GRASPED.at(SOURCE.span(20), "another")
    astray = NOT_AT_DESTINATION.at(None, "astray")
    told = with_causes([astray, missed, other, refused], [skip(7), event])
    groups = below_causes(group_findings(told))
    assert [(one.first.message, one.cause_text) for one in groups] == [
        ("another", ""),
        ("refused", ""),
        ("astray", "likely follows from line 7"),
        ("no part", "likely follows from line 7"),
    ]

"""What parts a wait by looking again and again from the one before it."""

from dataclasses import replace

import pytest

from ropsim.core import Span
from ropsim.flow import Origin, WaitEvent
from ropsim.simulation.testing import PollingWait

LINE = Origin(Span.on_line("a.task", 4, 4), 1)
EVENT = WaitEvent(1.0, 0.5, "left", LINE, pause=0.5, looked=("a", "b"))
WAIT = PollingWait(EVENT, 1000, 1500)


def test_a_wait_goes_on_where_it_ends_on_its_line_and_for_the_same() -> None:
    assert WAIT.goes_on_in(replace(EVENT, time=1.5, duration=0.004, origin=replace(LINE, visit=7)), 1500)


@pytest.mark.parametrize("since", [1000, 1499, 1501, 1504])
def test_what_begins_at_another_tick_is_a_wait_of_its_own(since: int) -> None:
    assert not WAIT.goes_on_in(replace(EVENT, time=since / 1000), since)


@pytest.mark.parametrize("looked", [("a",), ("b", "a"), ("a", "b", "c"), ()])
def test_a_wait_for_other_channels_is_one_of_its_own(looked: tuple[str, ...]) -> None:
    assert not WAIT.goes_on_in(replace(EVENT, looked=looked), 1500)


@pytest.mark.parametrize(
    "origin", [Origin(Span.on_line("a.task", 5, 4), 1), replace(LINE, calls=("Look",)), None]
)
def test_a_wait_on_another_line_or_in_another_call_is_one_of_its_own(origin: Origin | None) -> None:
    assert not WAIT.goes_on_in(replace(EVENT, origin=origin), 1500)

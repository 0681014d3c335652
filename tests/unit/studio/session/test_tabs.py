import asyncio
import json

from ropsim.studio.testing import GRACE, MOST_WAITING, EditingRight, Tab, Tabs
from support.patience import PATIENCE


class Clock:
    """A clock that is put forward by hand."""

    def __init__(self) -> None:
        self.now = 100.0

    def __call__(self) -> float:
        return self.now


def named(name: str) -> Tab:
    tab = Tab()
    tab.name = name
    return tab


def sent(tab: Tab) -> list[object]:
    """Return what waits for a tab: messages as values, frames as bytes."""
    out: list[object] = []

    async def text(message: str) -> None:
        out.append(json.loads(message))

    async def frame(content: bytes) -> None:
        out.append(content)

    async def pump() -> None:
        pumping = asyncio.create_task(tab.pump(text, frame))
        await asyncio.sleep(0)
        await asyncio.sleep(0)
        tab.close()
        await pumping

    asyncio.run(pump())
    return out


def test_the_first_tab_edits_and_the_second_follows() -> None:
    tabs, first, second = Tabs(Clock()), named("a"), named("b")
    tabs.add(first)
    tabs.add(second)
    assert [tabs.may_edit(first), tabs.may_edit(second)] == [True, False]


def test_taking_over_tells_both() -> None:
    tabs, first, second = Tabs(Clock()), named("a"), named("b")
    tabs.add(first)
    tabs.add(second)
    tabs.take_over(second)
    assert [tabs.may_edit(first), tabs.may_edit(second)] == [False, True]
    assert sent(first) == [{"type": "editing", "editing": False}]
    assert sent(second) == [{"type": "editing", "editing": True}]


def test_the_right_waits_for_a_tab_that_comes_again() -> None:
    clock = Clock()
    tabs, first = Tabs(clock), named("a")
    tabs.add(first)
    tabs.remove(first)
    other, again = named("b"), named("a")
    tabs.add(other)
    clock.now += GRACE / 2
    tabs.add(again)
    assert [tabs.may_edit(other), tabs.may_edit(again)] == [False, True]


def test_a_tab_that_stays_away_loses_the_right_to_the_next_that_comes() -> None:
    clock = Clock()
    tabs, first = Tabs(clock), named("a")
    tabs.add(first)
    tabs.remove(first)
    clock.now += GRACE + 0.1
    other = named("b")
    tabs.add(other)
    assert tabs.may_edit(other)


def test_a_right_that_waits_for_nobody_any_more_goes_to_the_tab_that_is_here_longest() -> None:
    clock = Clock()
    tabs, first, second, third = Tabs(clock), named("a"), named("b"), named("c")
    for tab in (first, second, third):
        tabs.add(tab)
    tabs.remove(first)
    tabs.pass_on()
    assert not any(tabs.may_edit(one) for one in (second, third))
    clock.now += GRACE
    tabs.pass_on()
    assert [tabs.may_edit(second), tabs.may_edit(third)] == [True, False]
    assert sent(second) == [{"type": "editing", "editing": True}]


def test_a_right_that_somebody_has_is_not_passed_on() -> None:
    clock = Clock()
    tabs, first, second = Tabs(clock), named("a"), named("b")
    tabs.add(first)
    tabs.add(second)
    tabs.remove(first)
    again = named("a")
    tabs.add(again)
    clock.now += GRACE
    tabs.pass_on()
    assert [tabs.may_edit(again), tabs.may_edit(second)] == [True, False]


def test_of_frames_the_newest_three_are_sent_and_of_messages_all_before_them() -> None:
    tab = Tab()
    for number in range(5):
        tab.send_frame(bytes([number]))
        tab.send(EditingRight(editing=number % 2 == 0))
    assert sent(tab)[5:] == [b"\x02", b"\x03", b"\x04"]
    assert len(sent(tab)) == 0


def test_a_tab_that_comes_again_before_its_former_connection_has_gone_goes_on_editing() -> None:
    tabs, first, again = Tabs(Clock()), named("a"), named("a")
    tabs.add(first)
    tabs.add(again)
    assert [tabs.may_edit(first), tabs.may_edit(again)] == [False, True]
    tabs.remove(first)
    assert tabs.may_edit(again)
    assert sent(first) == [{"type": "editing", "editing": False}]


def test_a_tab_that_has_stopped_reading_is_closed_and_holds_nothing() -> None:
    tab = Tab()
    text = b"x" * (MOST_WAITING // 4)
    for _ in range(5):
        tab.send_text(text)
        tab.send_frame(text)
    assert tab.closed
    assert sent(tab) == []


def test_a_tab_ends_although_its_page_reads_nothing() -> None:
    async def never(_: object) -> None:
        await asyncio.sleep(3600)

    async def play() -> None:
        tab = Tab()
        tab.send_frame(b"1")
        pumping = asyncio.create_task(tab.pump(never, never))
        await asyncio.sleep(0)
        tab.close()
        await asyncio.wait_for(pumping, PATIENCE)

    asyncio.run(play())

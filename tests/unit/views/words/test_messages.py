import re
from dataclasses import replace

from ropsim.flow import MessageEvent, Origin, Recording
from ropsim.views import html_report, messages, messages_text, summarize
from ropsim.views.testing import SHOWN_MESSAGES
from support.recordings import SOURCE, pick_and_place, two_stations


def run_that_says(*texts: str) -> Recording:
    """Return a run with a message every 5.5 s from line 7 on."""
    told = [
        MessageEvent(5.5 * k, origin=Origin(SOURCE.span(7 + k % 8, 1, 5), k + 1), text=text)
        for k, text in enumerate(texts)
    ]
    recording = pick_and_place(1)
    return replace(recording, events=(*recording.events, *told))


def test_a_message_has_time_text_source_line_and_pass() -> None:
    first, second = messages(run_that_says("one", "two"))
    assert (first.time, first.text, first.source, first.line, first.visit) == (0.0, "one", SOURCE.name, 7, 1)
    assert (second.time, second.text, second.line, second.visit) == (5.5, "two", 8, 2)


def test_a_run_that_says_nothing_has_no_messages_and_no_section() -> None:
    recording = pick_and_place(1)
    assert messages(recording) == ()
    assert messages_text(()) == ""
    assert "<h2>Messages</h2>" not in html_report(recording, summarize(recording), {})


def test_the_terminal_shows_them_in_columns() -> None:
    text = messages_text(messages(run_that_says("one", "two", "three", "four")))
    assert text.splitlines() == [
        " 0.00 s  line 7   one",
        " 5.50 s  line 8   two",
        "11.00 s  line 9   three",
        "16.50 s  line 10  four",
    ]


def test_control_characters_do_not_reach_the_terminal() -> None:
    text = messages_text(messages(run_that_says("a\nb\x1b[2Jc\x9b\u202e")))
    assert len(text.splitlines()) == 1
    assert not re.search("[\x00-\x1f\x7f-\x9f\u202e]", text)


def test_the_page_shows_them_escaped() -> None:
    recording = run_that_says("<b>late</b> & \x1b")
    page = html_report(recording, summarize(recording), {})
    assert "<h2>Messages</h2>" in page
    assert "&lt;b&gt;late&lt;/b&gt; &amp;" in page
    assert "\x1b" not in page


def test_a_flood_of_messages_is_cut_on_the_page_and_counted() -> None:
    recording = run_that_says(*["again"] * (SHOWN_MESSAGES + 3))
    page = html_report(recording, summarize(recording), {})
    assert page.count("<td>again</td>") == SHOWN_MESSAGES
    assert "and 3 more messages" in page


def test_messages_of_several_stations_say_whose_they_are() -> None:
    told = [
        MessageEvent(1.0 + k, station=name, origin=Origin(SOURCE.span(7 + k, 1, 5), 1), text=f"by {name}")
        for k, name in enumerate(("left", "right"))
    ]
    recording = replace(two_stations(), events=tuple(told))
    assert messages_text(messages(recording)).splitlines() == [
        "1.00 s  left  line 7   by left",
        "2.00 s  right  line 8  by right",
    ]
    page = html_report(recording, summarize(recording), {})
    assert "<td>right 8</td>" in page.replace('<td class="">', "<td>")

import re
from dataclasses import replace
from html.parser import HTMLParser

import numpy as np
import pytest

from ropsim.core import Diagnostic, Severity
from ropsim.flow import (
    Channel,
    Fidelity,
    IntegrationFacts,
    MessageEvent,
    MotionKind,
    Origin,
    Recording,
    SkipEvent,
    StepCause,
    TaskEvent,
)
from ropsim.views import html_report, summarize
from support.recordings import (
    SOURCE,
    empty_recording,
    estimates,
    facts,
    pick_and_place,
    station,
    two_findings,
    two_stations,
)

VOID = {"meta", "br"}
HOSTILE = "<script>alert('x')</script>\"&\x00\x1b\ud800"
LARGEST = 1_500_000
"""Bytes that the report of a run of 220 s at 1 kHz may have."""


class Outline(HTMLParser):
    """Checks that elements nest, and gathers tags, ids and attributes."""

    def __init__(self) -> None:
        super().__init__()
        self.open: list[str] = []
        self.tags: list[str] = []
        self.ids: list[str] = []
        self.links: list[str] = []

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append(tag)
        values = dict(attrs)
        self.ids += [value for name, value in attrs if name == "id" and value]
        self.links += [str(values[name]) for name in ("src", "href", "xlink:href") if name in values]
        if tag not in VOID:
            self.open.append(tag)

    def handle_startendtag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.handle_starttag(tag, attrs)
        if tag not in VOID:
            self.open.pop()

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag


def page(recording: Recording) -> str:
    return html_report(recording, summarize(recording), {SOURCE.name: SOURCE})


def outline(text: str) -> Outline:
    parser = Outline()
    parser.feed(text)
    parser.close()
    assert parser.open == []
    return parser


def test_elements_nest_and_ids_are_unique() -> None:
    found = outline(page(pick_and_place(findings=two_findings())))
    assert len(found.ids) == len(set(found.ids))
    assert found.tags.count("h1") == 1


def test_page_needs_no_network() -> None:
    text = page(pick_and_place(findings=two_findings()))
    assert outline(text).links == []
    assert "url(" not in text
    assert "@import" not in text
    assert "default-src &#39;none&#39;" in text


def test_settling_is_a_figure_of_its_own() -> None:
    text = page(pick_and_place(1))
    start = text.index("<dt>settling</dt>")
    assert "of the cycle time; longest 0.020 s" in text[start : text.index("</div>", start)]


def test_shares_of_several_stations_together_say_so_and_those_of_one_do_not() -> None:
    text = page(two_stations())
    assert text.count("of the sum of the cycle times") == 2  # in motion and settling of the whole run
    assert "of the sum" not in page(pick_and_place(1))


def test_every_picture_has_title_and_description() -> None:
    found = outline(page(pick_and_place()))
    assert found.tags.count("svg") >= 9
    assert found.tags.count("desc") == found.tags.count("svg")


def test_every_chart_of_the_contract_is_there() -> None:
    text = page(pick_and_place())
    for name in ("q", "qd", "tau", "current", "q_error", "tcp", "top", "side", "schedule", "signals"):
        assert f'id="chart-{name}-t"' in text


def test_the_page_says_how_drives_and_arm_were_integrated() -> None:
    """One line, for each way once; of a kinematic run that nothing was, of an older recording nothing."""
    way = IntegrationFacts("Runge-Kutta 4", 2.5e-4, StepCause.POLE, 5140.0, 3e-9)
    known = replace(station(), integration=way)
    recording = replace(pick_and_place(1), facts=facts(stations=(known,)))
    assert (
        "Runge-Kutta 4 in steps of 0.250 ms, 4 steps per control tick (set by: fastest pole; "
        "fastest pole 5140 1/s), error at most 3e-09 rad or m"
    ) in page(recording)
    plain = replace(recording, facts=facts(stations=(station(),)))
    assert "Runge-Kutta" not in page(plain)
    still = replace(plain, facts=replace(plain.facts, fidelity=Fidelity.KINEMATIC))
    assert "kinematic: nothing is integrated" in page(still)


def test_hostile_names_are_escaped_everywhere() -> None:
    recording = pick_and_place(1)
    finding = Diagnostic(
        "M502", HOSTILE, Severity.ERROR, HOSTILE, SOURCE.span(9), HOSTILE, (), (HOSTILE,), HOSTILE
    )
    axes = tuple(replace(axis, name=HOSTILE) for axis in station().axes)
    arm = station(title=HOSTILE, axes=axes, program=HOSTILE, icr_id=HOSTILE, origins=estimates(HOSTILE))
    hostile = replace(
        recording,
        facts=facts(project=HOSTILE, ropsim=HOSTILE, stations=(arm,)),
        findings=(finding,),
        events=(
            *recording.events,
            TaskEvent(0.0, 1.0, name=HOSTILE, serial=1, depth=1),
            SkipEvent(0.0, origin=Origin(SOURCE.span(3)), motion=MotionKind.PTP),
            MessageEvent(0.0, text=HOSTILE),
        ),
        channels={
            **recording.channels,
            f"signal.{HOSTILE}": replace(recording.channels["signal.pressure"], unit=HOSTILE),
        },
    )
    text = page(hostile)
    assert outline(text).tags.count("script") == 1
    assert "alert('x')" not in text
    assert not re.search("[\x00-\x08\x0b-\x1f\ud800-\udfff]", text)
    text.encode("utf-8")


def test_findings_quote_their_source_line() -> None:
    text = page(pick_and_place(findings=two_findings()))
    assert "16 |   mov above(at)" in text
    assert "passes 1-3" in text


@pytest.mark.slow
def test_report_of_a_long_run_stays_small() -> None:
    time = np.arange(60_000) / 1000.0
    generator = np.random.default_rng(1)
    short = pick_and_place(1)
    channels = {
        name: replace(channel, values=generator.normal(size=(time.size, *channel.values.shape[1:])))
        for name, channel in short.channels.items()
        if name not in {"line", "move"}
    }
    text = page(replace(short, time=time, channels=channels))
    assert len(text.encode()) < LARGEST


def test_peaks_survive_the_decimation() -> None:
    recording = pick_and_place(2)
    tau = np.zeros_like(recording.channels["tau"].values)
    tau[321, 4] = 17.77
    text = page(replace(recording, channels={**recording.channels, "tau": Channel(tau, "N·m")}))
    assert "<tspan>17.8</tspan>" in text


def test_empty_recording_has_a_page() -> None:
    text = page(empty_recording())
    outline(text)
    assert "nan" not in text


def test_run_that_is_not_finite_has_a_page() -> None:
    recording = pick_and_place(1)
    channels = {
        name: replace(c, values=np.full_like(c.values, np.nan)) for name, c in recording.channels.items()
    }
    text = page(replace(recording, channels=channels))
    outline(text)
    assert "not finite: the integration failed" in text


def test_same_recording_gives_the_same_page() -> None:
    assert page(pick_and_place(1)) == page(pick_and_place(1))


def test_every_station_has_its_own_charts_and_rows() -> None:
    recording = two_stations()
    text = html_report(recording, summarize(recording), {SOURCE.name: SOURCE})
    for name in ("tcp-1", "tcp-2", "top-1", "top-2", "q", "schedule", "signals"):
        assert text.count(f'id="chart-{name}-t"') == 1, name
    for label in ("left joint 1", "right joint 1", "left gripper", "right payload", "left pick"):
        assert label in text, label
    assert text.count(">lamp<") == 1


def test_several_stations_have_their_own_tables_and_the_cell_has_one_verdict() -> None:
    text = page(two_stations())
    outline(text)
    for heading in ("Joints", "Tasks", "Accuracy"):
        assert [text.count(f"<h2>{heading} of {name}</h2>") for name in ("left", "right")] == [1, 1]
        assert f"<h2>{heading}</h2>" not in text
    assert text.count('<p class="verdict') == 1
    assert text.count("<h2>Findings</h2>") == 1
    headings = [text.index(f">Station {name}<") for name in ("left", "right")]
    assert headings[0] < text.index("<h2>Joints of left</h2>") < headings[1]


def test_parts_of_the_cycle_time_that_there_are_none_of_have_no_column() -> None:
    text = page(pick_and_place(1))
    assert "motion<br>[s]" in text
    assert "gripper<br>[s]" in text
    assert "partners<br>[s]" not in text


def test_lines_of_the_program_are_shown_whole_where_they_are_pointed_at() -> None:
    assert 'class="source" title="' in page(pick_and_place(1))

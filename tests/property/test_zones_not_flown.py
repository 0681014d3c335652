"""Each line on which a zone was not flown has a finding for each reason, and no other line has one."""

from collections import Counter

from hypothesis import given, settings
from hypothesis import strategies as st

import ropsim
from ropsim import icr, robots
from ropsim.flow import MoveEvent, Recording
from ropsim.model import Signal, Tool
from ropsim.motion import ZONE_STOPS
from ropsim.simulation import Fidelity, RunOptions, run
from ropsim.views import summarize
from ropsim.workbench import environment_of
from support.cells import one_station
from support.examples import examples

ROBOT = robots.load("puma560")
CELL = one_station(
    "c",
    ROBOT,
    robots.default_controller("puma560"),
    tools={"": Tool("")},
    start=ROBOT.home,
    signals={"lamp": Signal("lamp", is_input=False)},
)
HEAD = ("program p", "units mm, deg, s", "mov (500, -200, 300)")

POINTS = st.one_of(
    st.tuples(
        st.sampled_from((450, 450.0005, 500, 510)), st.sampled_from((-200, 0, 5)), st.sampled_from((100, 300))
    ),
    st.just((900, 900, 900)),  # out of reach: the move is left out
)
MOVES = st.builds(
    lambda word, point, zone: f"{word} {point} {zone}",
    st.sampled_from(("lin", "lin", "mov")),
    POINTS,
    st.sampled_from(("", "fine", "blend 30 mm", "blend 2 mm", "blend 0.0005 mm")),
)
STATEMENTS = st.one_of(MOVES, MOVES, st.sampled_from(("wait 0.01 s", "set lamp on")))
LOOPS = st.builds(
    lambda count, body: (f"repeat {count}", *body, "endr"),
    st.integers(1, 3),
    st.lists(STATEMENTS, min_size=1, max_size=4),
)
PROGRAMS = st.lists(st.one_of(STATEMENTS.map(lambda one: (one,)), LOOPS), min_size=1, max_size=5)


def recorded(lines: list[str]) -> Recording:
    compiled = ropsim.language.compile("\n".join((*HEAD, *lines)), environment_of(CELL))
    assert isinstance(compiled.icr, icr.Program), compiled.diagnostics
    return run(CELL, {"robot": compiled.icr}, RunOptions(Fidelity.KINEMATIC, record_hz=10))


@settings(max_examples=examples(60))
@given(PROGRAMS)
def test_the_verdict_counts_the_lines_that_are_listed(parts: list[tuple[str, ...]]) -> None:
    recording = recorded([line for part in parts for line in part])
    stopped = [one for one in recording.events_of(MoveEvent) if one.zone > 0.0 == one.flown]
    found = [one for one in recording.findings if one.code == ZONE_STOPS.code and one.span is not None]
    reasons = Counter((one.span.line, one.data["cause"]) for one in found if one.span is not None)
    assert set(reasons.values()) <= {1}
    listed = {line for line, _ in reasons}
    moving = {one.line for one in stopped if one.travel > 0.0}  # an arm that stands at a target loses nothing
    assert moving <= listed <= {one.line for one in stopped}
    assert summarize(recording).unchecked.fine_stops == tuple(sorted(listed))

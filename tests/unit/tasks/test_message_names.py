"""What is said of wrong knowledge bases, calls and goals names what users wrote, and no part of ropsim."""

from collections.abc import Iterator

import pytest

from ropsim.core import Diagnostic, RopsimError
from ropsim.tasks import WorldState, term_text
from support.internal_names import shown_internals, words_of
from support.knowledge import base
from support.wrong_texts import groups, texts_of_tests, wrong_texts

TEXTS, TOGETHER = 200, 40
STATE = (
    "gripper(open)",
    "at(bolt, s1)",
    "free(s2)",
    "location(s1)",
    "location(s2)",
    "part(bolt)",
    "tool(jaws)",
)
CALLS = (
    "grip", "grip s1, s2", "grip s1", "release s2", "pick s1, 3 kg", "pick s1, -3", "pick nowhere", "grib s1",
    "read_bass s1", "park (1, 2)", "park (1, 2, 3, 4)", "place s2", "load_pallet s1, s2, 3, 3, 75 mm",
    "screw s1",
    "load_pallet s1, s2, x, y, z",
    "tool_change s1, s2", "load_machine s1", "palletize s1, s2, 0, 1.5", "insert s2",
    "unload_pallet s2, s1, 1, 1, 5", "grip (", "park no_place", "_G1 s1", "",
)  # fmt: skip
GOALS = (
    "at(bolt, s2)", "at(X, s2)", "on(bolt, nut)", "gripper(shut)", "inserted(bolt)", "inserted(nut)",
    "parked(no_place)",
    "parked", "held(bolt)", "f(", "f(_)", "3", "at(bolt, f(x))", "loaded(bolt, lathe)", "owned", "over(a, b)",
)  # fmt: skip
ODD = """\
over(X, Y) :- on(X, Y).
over(X, Z) :- on(X, Y), over(Y, Z).
endless(X) :- endless(f(X)).
given(on/2).
task(odd(P), [params([P-part]), pre([over(_, P), \\+ over(P, _), on(_, _)]), eff([-on(P, _)])]).
task(deep(L), [params([L-location]), pre([endless(_)])]).
task(lid(P, L), [params([P-part, L-location]), pre([over(P, lid)]),
  eff([+on(P, lid)]), geo([reachable(amr, L)])]).
task(mine(L), [params([L-location]), pre([mine(L, _X)]), eff([+owned]), geo([reachable(arm, p(1, L, 3))])]).
goal(owned/0).
"""


def said(texts: list[str], calls: tuple[str, ...], goals: tuple[str, ...]) -> Iterator[tuple[str, str]]:
    """Yield what the user wrote and all that is said of some texts, of calls and of goals."""
    known = base(*texts)
    for one in known.findings:
        lines = known.texts[one.span.source].text if one.span else ""
        yield lines, words_of(one)
    state = WorldState.of(*STATE)
    for call in calls:
        try:
            report = known.check(call, state, seconds=2.0)
            fails = "\n".join(map(term_text, report.fails))
            yield call, "\n".join((fails, *map(words_of, (*report.findings, *report.warnings))))
        except RopsimError as error:
            yield call, words_of(error.diagnostic)
    for goal in goals:
        yield goal, "\n".join(map(words_of, planned(texts, goal)))


def planned(texts: list[str], goal: str) -> tuple[Diagnostic, ...]:
    """Return what is said of a plan for a goal."""
    try:
        return base(*texts).plan([goal], WorldState.of(*STATE), seconds=2.0).findings
    except RopsimError as error:
        return (error.diagnostic,)


def test_no_message_about_a_text_shows_a_part_of_ropsim() -> None:
    texts = [*texts_of_tests("tasks"), *wrong_texts(TEXTS, 3)]
    found = [one for some in groups(texts, TOGETHER) for one in said(list(some), (), ())]
    assert len(found) > TEXTS
    shown = [(given, names, text) for given, text in found if (names := shown_internals(text, given))]
    assert shown == []


@pytest.mark.parametrize("text", ["", ODD], ids=["library", "odd"])
def test_no_message_about_a_call_or_a_goal_shows_a_part_of_ropsim(text: str) -> None:
    calls = (*CALLS, "odd", "deep s1", "lid s1", "mine s1") if text else CALLS
    found = list(said([text], calls, GOALS))
    assert sum(bool(words) for _, words in found) > 20
    shown = [
        (given, names, words) for given, words in found if (names := shown_internals(words, given + text))
    ]
    assert shown == []

"""Conditions of geometry: one more is a file and a place in the table, and everything knows it."""

import pytest

from ropsim.core import SourceText
from ropsim.tasks import KnowledgeBase, WorldState, words
from ropsim.tasks.testing import CONDITIONS, Condition, conditions, examples, forms
from support.knowledge import Refusing, base

LIT = Condition(
    "lit",
    ("Lamp",),
    lambda geometry, robot, things, location: geometry.reachable(robot, f"{things[0]}_{location}"),
    lambda things, place: f"`{things[0]}` does not light {place}",
)
TEXT = """\
task(look(L), [params([L-location]), geo([lit(arm, lamp, L)])]).
task(look_round(L, N, D), [
  params([L-location, N-int, D-length]), geo([in_rows(lit(arm, lamp, L), N, N, D)])]).
"""


def test_one_more_condition_is_an_entry_of_the_table(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(CONDITIONS, LIT.name, LIT)
    geometry = Refusing()
    known = KnowledgeBase([SourceText("kb/a.pl", TEXT)], geometry)
    try:
        assert known.findings == ()
        geometry.refuse(("arm", "lamp_s2"), ("arm", "lamp_s1 rel (0, -5, 0)"))
        near, far, round_ = known.check_all(["look s1", "look s2", "look_round s1, 2, 5"], WorldState())
        assert near.ok
        assert far.message == "`look` is not possible here: `lamp` does not light `s2`"
        assert round_.message.endswith("`lamp` does not light row 2, column 1 at `s1 rel (0, -5, 0)`")
        assert known.asked == 4  # s1 is asked once
        assert "`lit(Robot, Lamp, Location)`" in forms()
        assert "`lit(arm, L, L)`" in examples()
    finally:
        known.close()


def test_the_words_of_editors_are_those_of_the_table() -> None:
    assert (*CONDITIONS, conditions.IN_ROWS) == words.GEOMETRY
    (finding,) = base("task(a(L), [params([L-location]), geo([lit(arm, lamp, L)])]).").findings
    assert finding.code == "P141"
    assert finding.hint == (
        "there are `reachable(Robot, Location)`, `collision_free(Robot, Part, Location)` and "
        "`in_rows(Condition, Columns, Rows, Distance)`"
    )

"""Goals that hold by ISO 13211-1 or the manual of SWI-Prolog, one a line in `goals.txt`."""

from pathlib import Path

from ropsim.core import SourceText
from ropsim.prolog import Engine, GoalError, Prolog, Trust

HERE = Path(__file__).parent
GOALS = [line.split("\t", 1) for line in (HERE / "goals.txt").read_text("utf-8").splitlines()]


def outcome(engine: Engine, goal: str) -> str:
    """Return `yes`, `no` or the words of the error."""
    try:
        return "no" if engine.once(goal, module="program") is None else "yes"
    except GoalError as error:
        return str(error)


def test_every_goal_holds(prolog: Prolog) -> None:
    engine = Engine(prolog=prolog)
    assert engine.consult(SourceText("program.pl", (HERE / "program.pl").read_text("utf-8")), Trust.OWN) == ()
    assert len(GOALS) >= 159
    assert {goal: found for _, goal in GOALS if (found := outcome(engine, goal)) != "yes"} == {}


def test_a_goal_that_does_not_hold_is_seen(prolog: Prolog) -> None:
    engine = Engine(prolog=prolog)
    assert outcome(engine, "1 =:= 2") == "no"
    assert "not a function" in outcome(engine, "X is foo")

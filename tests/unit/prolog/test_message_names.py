"""What is said of wrong goals and wrong texts names what they name: no part of ropsim, Python or Prolog."""

from collections.abc import Iterator

import pytest

from ropsim.core import Diagnostic, RopsimError, SourceText
from ropsim.prolog import Atom, Engine, Limits, Predicate, Preparation, Prolog, Sort, Term, question
from support.internal_names import shown_internals, words_of
from support.wrong_texts import texts_of_tests, wrong_goals, wrong_texts

LIMITS = Limits(seconds=2.0, inferences=20_000)
GOALS, TEXTS = 200, 30


def _broken(*_: Term) -> bool:
    return bool(1 // 0)


def _missing_part(*_: Term) -> bool:
    return bool(int.weight)  # type: ignore[attr-defined]  # a mistake, whose error names parts of Python


@pytest.fixture(scope="module")
def shut_off() -> Engine:
    """Return an engine that goals of strangers cannot leave, whatever they call."""
    return engine_of(Prolog.BUILT_IN)


@pytest.fixture(scope="module")
def engine(prolog: Prolog) -> Engine:
    """Return an engine of each Prolog, for goals that call nothing of the machine."""
    return engine_of(prolog)


def engine_of(prolog: Prolog) -> Engine:
    """Return an engine with functions that fail in several ways."""
    functions = (
        question("broken", (Sort.TERM,), _broken),
        question("missing_part", (), _missing_part),
        question("typed", (Sort.INTEGER,), lambda _: True),
        Predicate("lying", (), (Sort.INTEGER,), lambda: ((Atom("x"),),)),
    )
    return Engine(LIMITS, prolog, Preparation(functions))


def said(engine: Engine, goal: str) -> Iterator[Diagnostic]:
    """Yield what is wrong with a goal."""
    try:
        engine.once(goal, limits=LIMITS)
    except RopsimError as error:
        yield error.diagnostic


def said_of_text(engine: Engine, text: str) -> Iterator[Diagnostic]:
    """Yield what is wrong with a text."""
    try:
        yield from engine.consult(SourceText("kb/wrong.pl", text))
    except RopsimError as error:
        yield error.diagnostic


@pytest.mark.slow
def test_no_message_about_a_goal_shows_a_part_of_ropsim(shut_off: Engine) -> None:
    goals = [*texts_of_tests("prolog"), *wrong_goals(GOALS, 1)]
    found = [(goal, one) for goal in goals for one in said(shut_off, goal)]
    assert len({one.code for _, one in found}) >= 4
    assert len(found) > GOALS // 2
    shown = [
        (goal, names, one.message) for goal, one in found if (names := shown_internals(words_of(one), goal))
    ]
    assert shown == []


@pytest.mark.slow
def test_no_message_about_a_text_shows_a_part_of_ropsim(shut_off: Engine) -> None:
    texts = [*texts_of_tests("prolog"), *wrong_texts(TEXTS, 2)]
    found = [(text, one) for text in texts for one in said_of_text(shut_off, text)]
    shut_off.forget("kb/wrong.pl")
    assert len({one.code for _, one in found}) >= 4
    shown = [
        (text, names, one.message) for text, one in found if (names := shown_internals(words_of(one), text))
    ]
    assert shown == []


@pytest.mark.parametrize(
    ("goal", "message", "hint"),
    [
        ("nowhere(1)", "predicate `nowhere/1` is defined nowhere", ""),
        ("numbervarz(1)", "predicate `numbervarz/1` is defined nowhere", "there is `numbervars/1`"),
        ("user:nowhere(_)", "predicate `nowhere/1` is defined nowhere", ""),
        ("throw(mine(_))", "the goal threw `mine(_)`, which nothing caught", ""),
        ("broken(1)", "a function that the goal calls failed: integer division or modulo by zero", ""),
        ("missing_part", "a function that the goal calls failed by a mistake of its own", ""),
        ("lying(_)", "a function that the goal calls failed: `lying/1` found `x`, promised was integer", ""),
        ("throw(ropsim_stop(soon))", "Prolog gave an answer that is none", ""),
        ("ropsim_engine:nowhere(1)", "this reaches into ropsim itself, which is not allowed", ""),
    ],
)
def test_an_error_is_told_in_words_of_the_goal(engine: Engine, goal: str, message: str, hint: str) -> None:
    (finding,) = said(engine, goal)
    assert finding.message == message
    assert not hint or "there is" in finding.hint

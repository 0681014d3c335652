"""Limits: whatever runs, it ends in time and within its memory, and the next goal is answered."""

import threading

import pytest

from ropsim.core import SourceText
from ropsim.prolog import Engine, GoalError, Limits, Predicate, Prolog, Sort, Term, Trust
from ropsim.prolog.door import Door
from ropsim.prolog.wasm.program import GRACE
from support.patience import PATIENCE

STUBBORN = """\
stubborn :- catch((repeat, fail), _, stubborn).
loop :- loop.
deep(N, D) :- numlist(1, N, L), wrap(L, z, D).
wrap([], D, D).
wrap([_|T], D, E) :- wrap(T, f(D), E).
"""
SHORT = Limits(seconds=0.1, memory_bytes=64 << 20)


@pytest.fixture(scope="module")
def engine(prolog: Prolog) -> Engine:
    engine = Engine(Limits(memory_bytes=64 << 20), prolog)
    assert engine.consult(SourceText("stubborn.pl", STUBBORN), Trust.OWN) == ()
    return engine


def code_of(engine: Engine, goal: str, limits: Limits | None = None) -> str:
    with pytest.raises(GoalError) as caught:
        engine.once(goal, module="stubborn", limits=limits)
    assert engine.once("X = 1") == {"X": 1}
    return caught.value.diagnostic.code


@pytest.mark.parametrize(
    "goal",
    [
        "loop",
        "stubborn",
        "repeat, fail",
        "X is 7 ** (7 ** 10)",
        "between(1, inf, X), X < 0",
        "length(L, N), N < 0",
    ],
)
def test_what_does_not_end_is_stopped(engine: Engine, goal: str) -> None:
    assert code_of(engine, goal, SHORT) in {"P113", "P111", "P116"}


def test_a_goal_that_ends_itself_in_time_keeps_its_engine(engine: Engine) -> None:
    engine.once("assertz(kept(1))")
    assert code_of(engine, "repeat, fail", SHORT) == "P113"
    assert engine.once("kept(X)") == {"X": 1}


def test_a_goal_that_catches_the_end_of_its_time_loses_its_engine(engine: Engine) -> None:
    engine.once("assertz(kept(1))")
    assert code_of(engine, "stubborn", SHORT) == "P113"
    assert engine.once("catch(kept(X), _, fail)") is None
    assert engine.once("deep(2, X)", module="stubborn") is not None


def test_an_answer_that_is_there_is_kept_though_what_it_leaves_takes_a_while(engine: Engine) -> None:
    """As where the process has to wait for its turn: a tenth of a second and more on every machine."""
    tidy = "forall(between(1, 100000, I), I > 0)"
    answer = engine.once(f"setup_call_cleanup(true, member(X, [1, 2]), {tidy})")
    assert answer is not None
    assert answer["X"] == 1


def test_inferences_are_counted_alike_in_every_built_in_engine() -> None:
    def least(one: Engine) -> int:
        """Return how many inferences the goal takes, up to a step of 10."""
        for number in range(1, 100):
            try:
                one.once(
                    "findall(X, between(1, 100, X), L), length(L, _)", limits=Limits(inferences=10 * number)
                )
            except GoalError as error:
                assert error.diagnostic.code == "P114"  # noqa: PT017 - the last one is answered
            else:
                return number
        raise AssertionError("the goal takes too many")

    assert least(Engine(Limits(memory_bytes=64 << 20))) == least(Engine())


@pytest.mark.parametrize(
    "goal",
    [
        "numlist(1, 100000000, L)",
        "length(L, 10000000), copy_term(L, M), copy_term(f(L, M), N)",
        "repeat, assertz(filler(abcdefgh, 1, 2, 3, 4, 5, 6, 7, 8, 9)), fail",
        "numlist(1, 3000000, L), atomic_list_concat(L, A), atom_concat(A, A, B), atom_concat(B, B, C)",
    ],
)
def test_memory_is_bounded_and_the_engine_comes_back(engine: Engine, goal: str) -> None:
    assert code_of(engine, goal, Limits(seconds=1.0)) in {"P111", "P113", "P116", "P117"}


def test_inferences_of_every_prolog_are_bounded(engine: Engine) -> None:
    with pytest.raises(GoalError) as caught:
        engine.once("between(1, inf, X), X < 0", limits=Limits(inferences=100_000))
    assert caught.value.diagnostic.code == "P114"


@pytest.mark.parametrize("depth", [1000, 30_000, 300_000])
def test_deep_terms_are_answered_or_crash_an_engine_that_comes_back(engine: Engine, depth: int) -> None:
    try:
        answer = engine.once(f"deep({depth}, X)", module="stubborn")
        assert answer is not None
        assert depth < 300_000
    except GoalError as error:
        assert error.diagnostic.code in {"P116", "P117", "P111"}  # noqa: PT017 - it may be answered
    assert engine.once("deep(2, X)", module="stubborn") is not None


def test_another_thread_cancels_what_runs(prolog: Prolog) -> None:
    engine = Engine(prolog=prolog)
    started = threading.Event()

    def begin() -> list[tuple[Term, ...]]:
        started.set()
        return [()]

    engine.register(Predicate("begin", (), (), begin))

    def cancel() -> None:
        started.wait(PATIENCE)
        engine.cancel()

    other = threading.Thread(target=cancel)
    other.start()
    with pytest.raises(GoalError) as caught:
        engine.once("begin, repeat, fail", limits=Limits(seconds=PATIENCE))
    other.join()
    assert caught.value.diagnostic.code == "P115"
    engine.cancel()  # nothing runs: nothing is cancelled
    assert engine.once("X = 1") == {"X": 1}


def test_the_time_of_a_goal_holds_for_what_its_functions_ask(engine: Engine) -> None:
    def inner() -> list[tuple[Term, ...]]:
        engine.once("repeat, fail", limits=Limits(seconds=PATIENCE))
        return [()]

    engine.register(Predicate("inner", (), (), inner))
    assert code_of(engine, "catch(inner, _, true), loop", SHORT) == "P113"


def test_a_text_that_does_not_end_while_it_is_loaded_is_stopped(prolog: Prolog) -> None:
    engine = Engine(Limits(seconds=0.2), prolog)
    with pytest.raises(GoalError, match="P113"):
        engine.consult(SourceText("kb/x.pl", ":- repeat, fail.\n"), Trust.OWN)
    assert engine.consult(SourceText("kb/x.pl", "a(1).\n"), Trust.OWN) == ()
    assert engine.once("a(X)", module="x") == {"X": 1}


def test_an_engine_for_short_goals_has_time_to_start(prolog: Prolog, monkeypatch: pytest.MonkeyPatch) -> None:
    """As on a machine that is busy: what opens the door takes longer than a goal may."""
    text = Door.text
    slow = ":- between(1, 400000, X), X >= 400000, !.\n"
    monkeypatch.setattr(Door, "text", lambda door: text(door) + slow)
    engine = Engine(Limits(seconds=0.001), prolog)
    assert engine.once("X = 1", limits=Limits(seconds=PATIENCE)) == {"X": 1}


@pytest.mark.parametrize("values", [{"seconds": 0.0}, {"inferences": 0}, {"memory_bytes": 1}])
def test_limits_that_are_none_are_refused(values: dict[str, float]) -> None:
    with pytest.raises(ValueError, match="allowed is"):
        Limits(**values)  # type: ignore[arg-type] # on purpose
    assert GRACE < 0.1
    assert Sort.ATOM.value == "atom"


def test_a_cancelled_goal_that_had_to_be_ended_is_cancelled_and_not_late(engine: Engine) -> None:
    def begin() -> list[tuple[Term, ...]]:
        engine.cancel()
        return [()]

    engine.register(Predicate("begin_stubborn", (), (), begin))
    assert code_of(engine, "begin_stubborn, stubborn", Limits(seconds=PATIENCE)) == "P115"

"""The engine: answers one by one, goals on each other, texts, facts, functions; all outlives a crash."""

import threading
from collections.abc import Iterator

import pytest

from ropsim.core import SourceText
from ropsim.prolog import (
    Atom,
    Engine,
    GoalError,
    Limits,
    Predicate,
    Prolog,
    Sort,
    Struct,
    Term,
    Trust,
    question,
)

KB = SourceText("kb/cell.pl", "at(bolt, s1).\nat(nut, s2).\nnear(X) :- at(X, P), reachable(arm, P).\n")


@pytest.fixture(scope="module")
def shared(prolog: Prolog) -> Engine:
    """Return the engine of all tests here: starting one takes a while."""
    engine = Engine(prolog=prolog)
    engine.register(question("reachable", (Sort.ATOM, Sort.ATOM), lambda _robot, place: place == Atom("s1")))
    return engine


@pytest.fixture
def engine(shared: Engine) -> Iterator[Engine]:
    """Return an engine with a small knowledge base and a function that reaches `s1` only."""
    assert shared.consult(KB, trust(shared)) == ()
    yield shared
    shared.forget(KB.name)
    for name in ("kb/x.pl", "own.pl"):
        shared.forget(name)
    shared.printed()


def trust(engine: Engine) -> Trust:
    """Return the least that a text needs: the native Prolog loads none of strangers."""
    return Trust.OWN if engine.prolog is Prolog.NATIVE else Trust.STRANGER


def code_of(engine: Engine, goal: str, module: str = "user") -> str:
    with pytest.raises(GoalError) as caught:
        engine.once(goal, module=module)
    return caught.value.diagnostic.code


def test_answers_come_one_by_one_in_the_order_of_prolog(engine: Engine) -> None:
    answers = engine.query("at(X, P)", module="cell")
    assert next(answers) == {"X": Atom("bolt"), "P": Atom("s1")}
    assert [answer["X"] for answer in answers] == [Atom("nut")]
    assert next(answers, None) is None
    assert engine.once("at(pin, _)", module="cell") is None


def test_a_goal_without_end_is_followed_as_far_as_it_is_asked(engine: Engine) -> None:
    answers = engine.query("between(1, inf, X)")
    assert [next(answers)["X"] for _ in range(5)] == [1, 2, 3, 4, 5]


def test_goals_lie_on_each_other_and_the_lower_one_ends_the_upper_one(engine: Engine) -> None:
    lower, upper = engine.query("member(X, [1, 2])"), engine.query("member(X, [3, 4])")
    assert (next(lower)["X"], next(upper)["X"], next(lower)["X"]) == (1, 3, 2)
    with pytest.raises(GoalError, match=r"P118.*given up"):
        next(upper)
    assert engine.once("X = 5") == {"X": 5}


def test_a_goal_that_is_dropped_below_another_leaves_the_other_alone(engine: Engine) -> None:
    lower, upper = engine.query("member(X, [1, 2])"), engine.query("member(X, [3, 4])")
    next(lower)
    next(upper)
    del lower
    assert [one["X"] for one in upper] == [4]


def test_hundreds_of_goals_that_are_left_open_take_no_memory(prolog: Prolog) -> None:
    engine = Engine(Limits(memory_bytes=64 << 20), prolog)
    for _ in range(300):
        next(engine.query("findall(Y, between(1, 2000, Y), _), member(X, [1, 2])"))
    assert engine.once("X = 1") == {"X": 1}


@pytest.mark.parametrize(
    ("goal", "code", "words"),
    [
        ("foo(", "P110", "end of clause"),
        ("X is foo + 1", "P111", "`foo/0` is not a function"),
        ("nowhere(1)", "P111", "nowhere"),
        ("throw(mine)", "P111", "nothing caught"),
        ("X = f(X)", "P111", "acyclic_term"),
        ("X is 10 ** 5000", "P117", "5001 digits; at most 4300"),
        ("numlist(1000000, 2100000, X)", "P117", "at most 8388608"),
        ("X = _{a: 1}", "P117", "cannot be taken over"),
    ],
)
def test_what_cannot_be_answered_is_told(engine: Engine, goal: str, code: str, words: str) -> None:
    with pytest.raises(GoalError) as caught:
        engine.once(goal)
    assert caught.value.diagnostic.code == code
    assert words in str(caught.value)
    assert engine.once("X = 1") == {"X": 1}


def test_the_term_of_an_error_can_be_had(engine: Engine) -> None:
    with pytest.raises(GoalError) as caught:
        engine.once("atom_length(f(x), _)")
    assert caught.value.term == Struct(
        "type_error", (Atom("atomic"), Struct("f", (Atom("x"),)))
    ) or isinstance(caught.value.term, Struct)


def test_a_text_takes_the_place_of_the_one_that_had_its_name(engine: Engine) -> None:
    assert engine.consult(SourceText(KB.name, "at(pin, s3).\n"), trust(engine)) == ()
    assert [one["X"] for one in engine.query("at(X, _)", module="cell")] == [Atom("pin")]
    assert code_of(engine, "near(_)", "cell") == "P111"
    engine.forget(KB.name)
    assert engine.once("catch(at(_, _), _, fail)", module="cell") is None
    assert engine.module_of(KB.name) is None


def test_a_text_has_the_module_that_it_declares(engine: Engine) -> None:
    assert engine.consult(SourceText("kb/x.pl", ":- module(grip, [t/1]).\nt(1).\n"), trust(engine)) == ()
    assert engine.module_of("kb/x.pl") == "grip"
    assert engine.once("grip:t(X)") == {"X": 1}
    assert code_of(engine, "x:t(_)") == "P111"


def test_facts_are_those_that_were_given_last(engine: Engine) -> None:
    engine.put_facts("world", [Struct("held", (Atom("bolt"),)), Atom("open")])
    assert engine.once("world:held(X), world:open") == {"X": Atom("bolt")}
    engine.put_facts("world", [Struct("held", (Atom("nut"),))])
    assert [one["X"] for one in engine.query("world:held(X)")] == [Atom("nut")]
    assert engine.once("world:open") is None


@pytest.mark.parametrize("module", ["cell", "lists", "user", "ropsim_engine", "system"])
def test_facts_cannot_be_put_into_what_is_not_theirs(engine: Engine, module: str) -> None:
    with pytest.raises(GoalError, match=r"No permission|into ropsim itself"):
        engine.put_facts(module, [Atom("x")])


def test_a_function_is_asked_with_terms_and_finds_terms(engine: Engine) -> None:
    asked: list[Term] = []

    def ik(robot: Term, place: Term) -> Iterator[tuple[Term, ...]]:
        asked.extend((robot, place))
        for number in range(1000):
            asked.append(number)
            yield (number, float(number) / 2)

    engine.register(Predicate("ik", (Sort.ATOM, Sort.LIST), (Sort.INTEGER, Sort.NUMBER), ik))
    assert engine.once("ik(arm, [1.5, x], N, Q), N >= 2") == {"N": 2, "Q": 1.0}
    assert asked == [Atom("arm"), (1.5, Atom("x")), 0, 1, 2]
    assert [one["P"] for one in engine.query("cell:near(P)")] == [Atom("bolt")]


def test_a_cut_closes_the_function_that_could_find_more(engine: Engine) -> None:
    ends: list[bool] = []

    def numbers() -> Iterator[tuple[Term, ...]]:
        try:
            yield from ((number,) for number in range(9))
        finally:
            ends.append(True)

    engine.register(Predicate("numbers", (), (Sort.INTEGER,), numbers))
    assert engine.once("numbers(X), X > 1, !") == {"X": 2}
    assert ends == [True]


@pytest.mark.parametrize(
    ("goal", "found"),
    [
        ("reachable(1, s1)", "type_error(atom,1)"),
        ("reachable(_, s1)", "instantiation_error"),
        ("broken", "python_error('ZeroDivisionError',"),
        ("lying(_)", "python_error('ValueError',"),
    ],
)
def test_wrong_types_and_errors_of_functions_are_errors_of_prolog(
    engine: Engine, goal: str, found: str
) -> None:
    engine.register(question("broken", (), lambda: bool(1 // 0)))
    engine.register(Predicate("lying", (), (Sort.INTEGER,), lambda: ((Atom("x"),),)))
    answer = engine.once(f"catch({goal}, error(E, _), true), format(string(S), '~q', [E])")
    assert answer is not None
    assert str(answer["S"]).startswith(found)


def test_a_function_may_ask_the_engine_itself(engine: Engine) -> None:

    def twice(number: Term) -> Iterator[tuple[Term, ...]]:
        answer = engine.once(f"X is {number} * 2")
        assert answer is not None
        yield (answer["X"],)

    engine.register(Predicate("twice", (Sort.INTEGER,), (Sort.INTEGER,), twice))
    assert engine.once("findall(Y, (member(X, [1, 2, 3]), twice(X, Y)), L)") is not None
    assert [one["Y"] for one in engine.query("member(X, [1, 2, 3]), twice(X, Y)")] == [2, 4, 6]


@pytest.mark.parametrize("name", ["is", "Bad", "a b", "assertz"])
def test_a_function_cannot_be_called_as_prolog_itself(engine: Engine, name: str) -> None:
    with pytest.raises((GoalError, ValueError), match=r"No permission|no name of a predicate"):
        engine.register(
            question(name, (Sort.TERM, Sort.TERM) if name == "is" else (Sort.TERM,), lambda *_: True)
        )
    assert engine.once("X is 1 + 1, cell:near(bolt)") == {"X": 2}


def test_everything_is_there_again_after_a_crash(engine: Engine) -> None:
    engine.put_facts("world", [Atom("open")])
    waiting = engine.query("member(X, [1, 2])")
    next(waiting)
    engine.consult(
        SourceText(
            "own.pl",
            "deep(N, D) :- wrap(N, z, D).\nwrap(0, D, D) :- !.\n"
            "wrap(N, D, E) :- M is N - 1, wrap(M, f(D), E).\n"
            "ended :- halt.\n",
        ),
        Trust.OWN,
    )
    crash = "ended" if engine.prolog is Prolog.NATIVE else "deep(400000, D)"
    assert code_of(engine, crash, "own") == "P116"
    assert engine.once("cell:near(X), world:open") == {"X": Atom("bolt")}
    with pytest.raises(GoalError, match="P118"):
        next(waiting)


def test_an_engine_belongs_to_its_thread(engine: Engine) -> None:
    found: list[str] = []

    def elsewhere() -> None:
        try:
            engine.once("true")
        except GoalError as error:
            found.append(error.diagnostic.code)

    other = threading.Thread(target=elsewhere)
    other.start()
    other.join()
    assert found == ["P118"]


def test_what_is_printed_is_kept_and_bounded(shared: Engine) -> None:
    engine = shared
    engine.once("write(hello), nl")
    assert engine.printed() == "hello\n"
    engine.once("forall(between(1, 15000, X), (write(X), nl))")
    assert len(engine.printed()) == 1 << 16


def test_the_same_goals_give_the_same_answers_in_every_built_in_engine() -> None:
    """Time and chance of the native Prolog are those of the machine."""
    goal = "get_time(T), random(R), random_between(1, 1000000, N), gensym(a, S), term_hash(f(x), H)"
    assert Engine().once(goal) == Engine().once(goal)


def test_a_trusted_text_may_do_more_than_that_of_a_stranger(shared: Engine) -> None:
    engine = shared
    text = SourceText("own.pl", "keep(X) :- nb_setval(key, X), nb_getval(key, X).\n")
    assert engine.consult(text, Trust.OWN) == ()
    assert engine.once("keep(1)", module="own") == {}
    if engine.prolog is Prolog.NATIVE:
        with pytest.raises(GoalError, match="P123"):
            engine.consult(text, Trust.STRANGER)
        assert engine.once("keep(2)", module="own") == {}
    else:
        assert engine.consult(text, Trust.STRANGER) == ()
        assert code_of(engine, "keep(1)", "own") == "P112"

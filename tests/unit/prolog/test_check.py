"""Checking a text: every mistake is found in one go, at its place, with words that help."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.core import Diagnostic, SourceText
from ropsim.prolog import Engine, Sort, question

SYNTAX = [
    ("a(1). b(2) c.\nd(3).\n", (1, 12), "missing between two terms"),
    ("b :- a,, c.\n", (1, 8), "comma"),
    ("a(1).\nb([1, 2.\n", (2, 8), ""),
    ("a(1).\nb('c.\n", (2, 3), "within quotes"),
    ("a :- .\n", (1, 6), ""),
    ("a(1)\n", (1, 5), "ends within a clause"),
    ("a :- (b, c.\n", (1, 11), ""),
    ("a(1)).\n", (1, 5), ""),
    ("a := := b.\n", (1, 6), ""),
    ('a("x\\q").\n', (1, 3), "backslash"),
    ("é(1). ü(2) c.\n", (1, 12), "missing between two terms"),
    ("a(1).\r\nb(2) c.\r\n", (2, 6), "missing between two terms"),
]


@pytest.fixture(scope="module")
def engine() -> Engine:
    engine = Engine()
    engine.register(question("reachable", (Sort.ATOM, Sort.ATOM), lambda *_: True))
    return engine


def found(engine: Engine, text: str) -> tuple[Diagnostic, ...]:
    return engine.check(SourceText("kb/t.pl", text))


def places(findings: tuple[Diagnostic, ...]) -> list[tuple[str, int, int, int]]:
    return [(one.code, one.span.line, one.span.column, one.span.end_column) for one in findings if one.span]


@pytest.mark.parametrize(("text", "place", "words"), SYNTAX)
def test_a_mistake_is_found_at_its_place(
    engine: Engine, text: str, place: tuple[int, int], words: str
) -> None:
    findings = found(engine, text)
    assert [one.code for one in findings] == ["P101"]
    span = findings[0].span
    assert span is not None
    assert (span.line, span.column) == place
    assert words in findings[0].message
    assert findings[0].hint


def test_reading_goes_on_after_each_mistake(engine: Engine) -> None:
    text = "a(1) b.\nc(X) :- d(X.\ne(1).\nf :- ,.\ng(Y).\n"
    assert [(code, line) for code, line, _, _ in places(found(engine, text))] == [
        ("P101", 1),
        ("P101", 2),
        ("P101", 4),
        ("P103", 5),
    ]


def test_a_right_text_has_no_findings(engine: Engine) -> None:
    text = """\
:- module(grip, [task/2, op(700, xfx, above)]).
:- use_module(library(clpfd)).
:- dynamic held/1.
:- op(700, xfx, below).
task(grip(P, L), [doc("takes it"), params([P-part, L-location]), pre([at(P, L)])]).
x above y.
y below x.
free(L) :- \\+ (held(P), at(P, L)), forall(member(Q, [1, 2]), Q > 0), reachable(arm, L).
at(_, _).
n(X) :- X #> 3, maplist([A, B]>>(B is A + 1), [1], [_]), findall(Y, held(Y), _).
sentence --> [a], rest.
rest --> [].
last(X) :- foldl(plus, [1], 0, X), aggregate_all(count, at(_, _), 1).
"""
    assert found(engine, text) == ()


def test_what_nobody_defines_is_found_where_it_is_called(engine: Engine) -> None:
    text = (
        "at(a, b).\n"
        "t(X) :- membr(X, [1]), att(X, _), at(X), \\+ nope, findall(Y, unknown(Y), _), maplist(hlper, [X]).\n"
        "u :- reachble(arm, s1), (true -> missing ; true).\n"
    )
    findings = found(engine, text)
    assert places(findings) == [
        ("P102", 2, 9, 14),
        ("P102", 2, 24, 27),
        ("P102", 2, 35, 37),
        ("P102", 2, 45, 49),
        ("P102", 2, 63, 70),
        ("P102", 2, 87, 92),
        ("P102", 3, 6, 14),
        ("P102", 3, 34, 41),
    ]
    hints = {one.message.split("`")[1]: one.hint for one in findings}
    assert hints["membr/2"] == "did you mean `member`?"
    assert hints["att/2"] == "did you mean `at`?"
    assert hints["at/1"] == "there is `at/2`"
    assert hints["reachble/2"] == "did you mean `reachable`?"


def test_a_variable_that_stands_alone_is_found_where_it_stands(engine: Engine) -> None:
    text = '% X Y\nt(Xa, [b, {c, Name}], _Fine, _) :- Z = "Name", u(Z).\nu(_).\n'
    assert places(found(engine, text)) == [("P103", 2, 3, 5), ("P103", 2, 15, 19)]


def test_clauses_that_do_not_stand_together_are_found(engine: Engine) -> None:
    text = "a(1).\nb(1).\na(2).\n:- discontiguous c/1.\nc(1).\nb(2).\nc(2).\n"
    assert places(found(engine, text)) == [("P104", 3, 1, 5), ("P104", 6, 1, 5)]


def test_checking_runs_nothing(engine: Engine) -> None:
    text = ":- assertz(user:ran(1)).\n:- initialization(assertz(user:ran(2))).\n:- op(0, xfx, user:(is)).\n:- repeat, fail.\n"
    assert found(engine, text) == ()
    assert engine.once("catch(ran(_), _, fail)") is None
    assert engine.once("X is 1 + 1") == {"X": 2}


def test_operators_of_one_text_do_not_reach_the_next(engine: Engine) -> None:
    assert found(engine, ":- op(700, xfx, ===>).\na ===> b.\n") == ()
    assert [one.code for one in found(engine, "a ===> b.\n")] == ["P101"]


@settings(max_examples=30)
@given(st.text("ab(),[]{}|'\"\\ .:-X_%/*\n0é", max_size=60))
def test_any_text_is_checked(text: str) -> None:
    for one in found(ANY, text):
        assert one.span is not None
        assert one.span.line <= text.count("\n") + 1


ANY = Engine()

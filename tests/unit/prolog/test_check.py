"""Checking a text: every mistake is found in one go, at its place, with words that help."""

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.core import Diagnostic, SourceText
from ropsim.prolog import Engine, Sort, question
from support.examples import examples

SYNTAX = [
    ("a(1). b(2) c.\nd(3).\n", (1, 11), "full stop is missing"),
    ("b :- a,, c.\n", (1, 7), "comma"),
    ("a(1).\nb([1, 2.\n", (2, 8), "`]` is missing before this"),
    ("a(1).\nb('c.\n", (2, 1), "within quotes"),
    ("a :- .\n", (1, 5), "lacks one"),
    ("a(1)\n", (1, 5), "ends within a clause"),
    ("a :- (b, c.\n", (1, 11), "`)` is missing before this"),
    ("a([b])\nb(c).\nc(d).\n", (1, 7), "an operator, a comma"),
    ("a([b]\nb(c).\nc(d).\n", (1, 6), "`)` is missing before this"),
    ("a(1)).\n", (1, 5), "`)` closes nothing"),
    ("a(1).\nt([p([L-x),\n  b]).\n", (2, 10), "`]` is missing before this"),
    ("a('x(', \"(\", 0'(, `(`, b(c). % (\n", (1, 28), "`)` is missing before this"),
    ("a('it''s (\\' [', /* ( */ b c).\n", (1, 27), "an operator, a comma"),
    ("a := := b.\n", (1, 8), "operator"),
    ('a("x\\q").\n', (1, 5), "backslash"),
    ("é(1). ü(2) c.\n", (1, 11), "full stop is missing"),
    ("a(1).\r\nb(2) c.\r\n", (2, 5), "full stop is missing"),
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


def test_where_a_bracket_is_missing_its_partner_is_named(engine: Engine) -> None:
    (finding,) = found(engine, "a(1).\ntask(grip(P, L), [\n  pre([at(P, L]),\n  eff([])]).\nb(2).\n")
    assert finding.message == "`)` is missing before this"
    assert finding.hint == "the `(` of line 3, column 10 is not closed"
    assert [(one.span.line, one.span.column) for one in finding.secondary] == [(3, 10)]


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
    marked = [(one.span, text.splitlines()[one.span.line - 1]) for one in findings if one.span]
    assert {one.code for one in findings} == {"P102"}
    assert [line[span.column - 1 : span.end_column - 1] for span, line in marked] == [
        *("membr", "att", "at", "nope", "unknown", "hlper"),
        *("reachble", "missing"),
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
    directives = (
        "assertz(user:ran(1))",
        "initialization(assertz(user:ran(2)))",
        "op(0, xfx, user:(is))",
        "repeat, fail",
    )
    text = "".join(f":- {one}.\n" for one in directives)
    assert found(engine, text) == ()
    assert engine.once("catch(ran(_), _, fail)") is None
    assert engine.once("X is 1 + 1") == {"X": 2}


def test_operators_of_one_text_do_not_reach_the_next(engine: Engine) -> None:
    assert found(engine, ":- op(700, xfx, ===>).\na ===> b.\n") == ()
    assert [one.code for one in found(engine, "a ===> b.\n")] == ["P101"]


@settings(max_examples=examples(30))
@given(st.text("ab(),[]{}|'\"\\ .:-X_%/*\n0é", max_size=60))
def test_any_text_is_checked(text: str) -> None:
    for one in found(ANY, text):
        assert one.span is not None
        assert one.span.line <= text.count("\n") + 1


ANY = Engine()

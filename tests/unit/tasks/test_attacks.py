"""Texts of strangers: nothing of them is run, and none takes the others or the engine with it."""

import pytest

from ropsim.tasks import WorldState
from support.knowledge import base

BEHIND = "task(behind(L), [params([L-location]), body([lin(L)])]).\n"
STATE = WorldState.of("gripper(open)", "at(bolt, s1)")


@pytest.mark.parametrize(
    "text",
    [
        "task(X, Y) :- assertz(ropsim_kb:standing(owned)), X = Y.",
        ":- initialization(assertz(ropsim_kb:standing(owned))).",
        ":- assertz(ropsim_kb:standing(owned)).",
        "ropsim_kb:holds(_, _).",
        "ropsim_world:holds(X, Y) :- X = Y.",
        "user:term_expansion(X, [X, owned]) :- true.",
        "shape(anything, 1, []) :- a.\nkind(any, text) :- a.\ngeometry(any, 1) :- a.\nknown(a, 0, b) :- a.",
        ":- op(1200, xfx, ':-'). :- op(0, xfx, ':-').",
        ":- set_prolog_flag(double_quotes, codes).",
        "task(a, [body([call(assertz(ropsim_kb:standing(owned)))])]).",
        "task(a, [pre([assertz(ropsim_kb:standing(owned))])]).\nowned :- assertz(ropsim_kb:standing(owned)).",
        "task(a, [geo([call(shell(id))])]).",
        "task(a, [params('$VAR'(1)), pre(X), eff(X), body(X)]).",
        "task(a, [body([mov('\\n  open\\n')])]).",
        ":- if(assertz(ropsim_kb:standing(owned))).\n:- endif.\n:- include('/etc/passwd').\n:- [user].",
        "a({|assertz(ropsim_kb:standing(owned))||x|}).\nb(_{a: 1}.put(c, 2)).",
        "goal_expansion(X, assertz(ropsim_kb:standing(owned))).\nsystem:goal_expansion(_, owned).",
        "portray(_) :- assertz(ropsim_kb:standing(owned)).\nattr_unify_hook(_, _) :- owned.",
        "task(a, [pre([freeze(X, owned), \\+ X])]).\np :- throw(unwind(halt(0))), halt.",
        "task('~@~w~q', [doc(\"~@\"), pre(['~@'(x)]), eff([+'~a~s'])]).\n'~@'(_) :- '~w'.",
        "call(_) :- fail.\nholds(owned, x) :- a.\nready :- b.\nhas_read :- b.\ntext(0, x) :- b.",
    ],
)
def test_nothing_of_a_text_is_run_or_redefines_what_is_ours(text: str) -> None:
    known = base(text, BEHIND)
    assert "behind" in known.names
    assert known.check("behind s1", STATE).ok
    assert known.plan(["owned"], STATE).findings[0].code == "P154"
    assert known.check("grip s1", STATE).state == WorldState.of("held(bolt)", "free(s1)", "gripper(closed)")
    assert base(BEHIND).findings == ()


DEEP = (f"f({'g(' * 300_000}a{')' * 300_000}).",)
ODD = (
    f"f({'1 + ' * 100_000}1).",
    f"task(a, [body([mov({'above(' * 500}s1{', 1)' * 500})])]).",
    "f(" + "X" * 1_000_000 + ").",
    "'" * 100_001,
    "task(" * 1000,
    "\x00\ud800 \u202e task(a).",
)


@pytest.mark.parametrize("texts", [DEEP, ODD], ids=["deep", "odd"])
def test_monstrous_texts_are_left_out_and_all_others_stay(texts: tuple[str, ...]) -> None:
    known = base(*texts, BEHIND)
    wrong = {one.span.source for one in known.findings if one.span and one.is_error}
    assert wrong <= {f"kb/t{index}.pl" for index in range(len(texts))}
    assert wrong
    assert "behind" in known.names
    assert known.check("behind s1", STATE).ok


def test_a_rule_that_doubles_its_terms_is_stopped() -> None:
    known = base(
        "p(X) :- p(f(X, X)).\nq(X) :- X = f(X), q(X).\ntask(a, [pre([p(0)])]).\ntask(b, [pre([q(_)])])."
    )
    assert not known.check("a", STATE).ok
    assert not known.check("b", STATE).ok
    assert known.check("grip s1", STATE).ok


def test_a_rule_that_never_ends_is_stopped() -> None:
    known = base(
        "p(X) :- p(s(X)), p(X).\nq(X) :- q(X), q(X) ; q(X).\ntask(a, [pre([p(0)])]).\ntask(b, [pre([q(0)])])."
    )
    assert not known.check("a", STATE).ok
    assert known.check("grip s1", STATE).ok


@pytest.mark.parametrize(
    "condition",
    [
        "enough(L, x, y)", "enough(L, N, -3)", "enough(L, 1000000000000, 1000000000000)", "enough(_, 2, 2)",
        "filled(L, 1000000000, 1000000000, 1)", "filled(L, N, N, furlong)", "filled(L, 0, 0, 0)",
        "vacant(L, 1.5, 2, 3)", "vacant(_, _, _, _)", "(enough(L, 2, 2), vacant(L, 2, 2, 5*mm))",
        "\\+ enough(L, 2, 2)", "few(L)",
    ],
)  # fmt: skip
def test_conditions_of_patterns_answer_whatever_they_are_given(condition: str) -> None:
    rule = "few(L) :- \\+ enough(L, 2, 2), \\+ vacant(L, 1, 1, 1)."
    known = base(f"{rule}\ntask(t(L, N), [params([L-location, N-int]), pre([{condition}])]).")
    report = known.check("t s1, 3", WorldState.of("at(bolt, s1)", "follows(nut, bolt)", "follows(nut, nut)"))
    assert all(one.code == "P152" and one.message for one in report.findings)
    assert known.plan(["parked(s1)"], WorldState.of("location(s1)")).ok

"""Texts of strangers: what they try is refused, when loaded or when called, and the engine goes on."""

import os
from collections.abc import Iterator

import pytest

from ropsim.core import SourceText
from ropsim.prolog import Atom, Engine, GoalError, Limits, Sort, question

REFUSED_WHEN_LOADED = {
    "program in a directive": ":- shell(ls).",
    "program after loading": ":- initialization(shell(id)).",
    "program before the rest": ":- initialization(shell(id), now).",
    "file in a directive": ":- open('/tmp/x', write, S), close(S).",
    "other text": ":- consult('/ropsim/engine.pl').",
    "clause of another module": "ropsim_door:reachable(_, _).",
    "clause of user": "user:plan(x).",
    "rule of the sandbox": ":- multifile sandbox:safe_primitive/1.\nsandbox:safe_primitive(system:shell(_)).",
    "heartbeat": ":- multifile prolog:heartbeat/0.\nprolog:heartbeat.",
    "flag of the heartbeat": ":- set_prolog_flag(heartbeat, 0).",
    "flag of the stack": ":- set_prolog_flag(stack_limit, 1000000000).",
    "message hook": ":- multifile user:message_hook/3.\nuser:message_hook(_, _, _).",
    "rewriting of terms": "user:term_expansion(a, b).",
    "rewriting of goals": "user:goal_expansion(x, shell(ls)).",
    "rewriting of terms in its own module": "term_expansion(a, b) :- shell(ls).\na.",
    "rewriting of goals in its own module": "goal_expansion(x, y) :- shell(ls).\nt :- x.",
    "host": ":- '$js_call'(x, _).",
    "module of the engine": ':- module(ropsim_engine, [solve/2]).\nsolve(_, "answer([])").',
    "module of the door": ":- module(ropsim_door, []).\nreachable(_, _).",
    "module of the sandbox": ":- module(sandbox, [safe_call/1]).\nsafe_call(G) :- call(G).",
    "module of hooks": ":- module(prolog, [heartbeat/0]).\nheartbeat.",
    "module of the library": ":- module(lists, [member/2]).\nmember(_, _).",
    "module of the system": ":- module(system, []).\nx.",
    "module of user": ":- module(user, []).\nx.",
    "predicate of the system": "atom_length(_, 0).",
    "halt": ":- halt.",
    "end of memory protection": ":- set_prolog_flag(protect_static_code, false).",
    "condition of a part of the text": ":- if(assertz(user:owned)).\n:- endif.",
    "another condition": ":- if(fail).\n:- elif(shell(ls)).\n:- endif.",
    "condition that hides a goal": ":- if((G = shell(ls), G)).\n:- endif.",
    "flag of the sandbox": ":- set_prolog_flag(sandboxed_load, false).",
    "main program": ":- initialization(main, main).\nmain :- shell(ls).",
    "text inside of the text": ":- include('/etc/passwd').",
    "library by its path": ":- use_module('/tmp/x').",
    "sockets": ":- use_module(library(socket)).",
    "processes": ":- use_module(library(process)).",
    "foreign code": ":- use_foreign_library(foreign(x)).",
    "fact of the system": ":- assertz(system:x(1)).",
    "clauses of the system": ":- dynamic system:x/1.",
    "another predicate of the system": ":- redefine_system_predicate(shell(_)).\nshell(_).",
    "around a predicate of the system": ":- wrap_predicate(system:atom_length(_, _), x, W, W).",
    "rewriting everywhere": ":- multifile system:term_expansion/2.\nsystem:term_expansion(a, b).",
    "printing": ":- multifile user:portray/1.\nuser:portray(_) :- shell(ls).",
    "unknown predicates": ":- multifile user:exception/3.\nuser:exception(_, _, _) :- shell(ls).",
    "where libraries are": ":- multifile user:file_search_path/2.\nuser:file_search_path(library, '/tmp').",
    "types": ":- multifile error:has_type/2.\nerror:has_type(x, _) :- shell(ls).",
    "words of messages": ":- multifile prolog:message//1.\nprolog:message(x) --> {shell(ls)}.",
    "operator of the system": ":- op(0, xfx, system:(:-)).",
    "after the end": ":- at_halt(shell(ls)).",
    "dialogue": ":- prolog.",
    "stream": ":- set_stream(user_output, alias(x)).",
}
REFUSED_WHEN_CALLED = {
    "program": "t :- shell(ls).",
    "file": "t :- open('/etc/passwd', read, _).",
    "host": "t :- '$js_call'(tick, _).",
    "engine": "t :- ropsim_engine:load(load('/kb/x.pl', x, open), _).",
    "halt": "t :- halt.",
    "setting": "t :- set_prolog_flag(heartbeat, 0).",
    "goal that is made while it runs": "t :- atom_concat(sh, ell, N), G =.. [N, ls], call(G).",
    "goal from a text": "t :- term_to_atom(G, 'shell(ls)'), call(G).",
    "fact in another module": "t :- assertz(sandbox:safe_primitive(system:shell(_))).",
    "fact of the engine": "t :- assertz(ropsim_engine:given(a, b, 0)).",
    "clause of another module": "t :- clause(ropsim_engine:solve(_, _), _).",
    "retract in another module": "t :- retract(user:message_hook(_, _, _)).",
    "through findall": "t :- findall(X, shell(X), _).",
    "through catch": "t :- catch(shell(ls), _, true).",
    "through maplist": "t :- maplist(shell, [ls]).",
    "through a module": "t :- system:shell(ls).",
    "at": "t :- @(shell(ls), system).",
    "cleanup": "t :- setup_call_cleanup(true, true, shell(ls)).",
    "foreign library": "t :- use_foreign_library('/tmp/x.so').",
    "environment": "t :- getenv('HOME', _), setenv(a, b).",
    "thread": "t :- thread_create(true, _).",
    "goal of a variable": "t :- freeze(X, shell(ls)), X = 1.",
    "goal of a condition": "t :- when(nonvar(X), shell(ls)), X = 1.",
    "hook of attributes": "attr_unify_hook(_, _) :- shell(ls).\nt :- put_attr(X, bad, y), X = 1.",
    "attribute of the engine": "t :- put_attr(X, ropsim_engine, y), X = 1.",
    "socket": "t :- tcp_socket(_).",
    "fact of the system": "t :- assertz(system:foo(1)).",
    "rule of the system": "t :- assertz((system:atom_length(_, 0) :- true)).",
    "predicate of the engine": "t :- abolish(ropsim_engine:solve/2).",
    "goal in a format": "t :- format('~@', [shell(ls)]).",
    "format that is made": "t :- atom_concat('~', '@', F), format(F, [shell(ls)]).",
    "lambda": ":- use_module(library(yall)).\nt :- maplist([X]>>shell(X), [ls]).",
    "goal that is read": "t :- read_term(X, []), call(X).",
    "continuation": "t :- reset(shell(ls), _, _).",
    "frames": "t :- prolog_current_frame(F), prolog_frame_attribute(F, parent, _).",
    "global variable": "t :- nb_setval(ropsim_wrong, 1).",
    "end by an exception": "t :- throw(unwind(halt(0))).",
    "end": "t :- abort.",
    "cyclic exception": "t :- X = f(X), throw(X).",
    "cyclic exception in an error": "t :- X = f(X, Y), Y = g(Y), throw(error(X, Y)).",
    "cyclic fact": ":- dynamic m/1.\nt :- X = f(X), assertz(m(X)).",
    "exception with a goal": "t :- freeze(X, shell(ls)), throw(X).",
    "deep hook": "t :- prolog_load_context(directory, D), delete_file(D).",
}
ALLOWED = {
    "lists": ("t(X) :- member(X, [1, 2]), msort([2, 1], [1, 2]).", 1),
    "own facts": (":- dynamic m/1.\nt(X) :- assertz(m(1)), retract(m(X)).", 1),
    "words": ("t(X) :- format(atom(X), '~w-~w', [a, b]).", Atom("a-b")),
    "all solutions": ("t(X) :- findall(Y, between(1, 3, Y), L), sum_list(L, X).", 6),
    "constraints": (":- use_module(library(clpfd)).\nt(X) :- X #= 2 + 3.", 5),
    "tables": (
        ":- table f/2.\nf(0, 0).\nf(N, M) :- N > 0, K is N - 1, f(K, L), M is L + N.\nt(X) :- f(10, X).",
        55,
    ),
    "functions of the host": ("t(X) :- reachable(arm, s1), X = 1.", 1),
    "errors": ("t(X) :- catch(atom_length(_, _), error(instantiation_error, _), X = 1).", 1),
}


@pytest.fixture(scope="module")
def shared() -> Engine:
    engine = Engine(Limits(seconds=5.0))
    engine.register(question("reachable", (Sort.ATOM, Sort.ATOM), lambda *_: True))
    engine.consult(SourceText("kb/good.pl", "good(1).\n"))
    return engine


@pytest.fixture
def engine(shared: Engine) -> Iterator[Engine]:
    """Return an engine that still works when the test is over."""
    yield shared
    shared.forget("kb/bad.pl")
    assert shared.once("good(X), reachable(arm, x)", module="good") == {"X": 1}
    with pytest.raises(GoalError, match="P112"):
        shared.once("shell(ls)")


@pytest.mark.parametrize("text", REFUSED_WHEN_LOADED.values(), ids=REFUSED_WHEN_LOADED)
def test_a_text_that_reaches_out_is_not_loaded(engine: Engine, text: str) -> None:
    findings = engine.consult(SourceText("kb/bad.pl", f"{text}\n"))
    assert {one.code for one in findings if one.is_error} == {"P105"}, findings
    assert engine.module_of("kb/bad.pl") is None


@pytest.mark.parametrize("text", REFUSED_WHEN_CALLED.values(), ids=REFUSED_WHEN_CALLED)
def test_a_goal_that_reaches_out_is_refused(engine: Engine, text: str) -> None:
    findings = engine.consult(SourceText("kb/bad.pl", f"{text}\n"))
    if any(one.is_error for one in findings):
        return
    with pytest.raises(GoalError) as caught:
        engine.once("t", module="bad")
    assert caught.value.diagnostic.code in {"P112", "P111"}


@pytest.mark.parametrize(
    "goal", ["X = f(X)", "X = [X, a]", "X = f(X), throw(X)", "X = f(X), atom_length(X, _)"]
)
def test_terms_without_an_end_are_refused_as_answers_and_exceptions(engine: Engine, goal: str) -> None:
    with pytest.raises(GoalError, match="P111"):
        engine.once(goal)


def test_parts_of_a_text_are_left_out_by_conditions_that_only_compute(engine: Engine) -> None:
    text = ":- if(1 < 2).\na(1).\n:- else.\na(2).\n:- endif.\n"
    assert engine.consult(SourceText("kb/bad.pl", text)) == ()
    assert list(engine.query("a(X)", module="bad")) == [{"X": 1}]


@pytest.mark.parametrize(("text", "found"), ALLOWED.values(), ids=ALLOWED)
def test_what_only_computes_is_allowed(engine: Engine, text: str, found: object) -> None:
    assert [one for one in engine.consult(SourceText("kb/bad.pl", f"{text}\n")) if one.is_error] == []
    assert engine.once("t(X)", module="bad") == {"X": found}


@pytest.mark.parametrize(
    "goal",
    [
        "open('/etc/passwd', read, S)",
        "exists_directory('/root')",
        "getenv('PATH', '/usr/bin')",
        "tmp_file(x, F), exists_directory('/var')",
    ],
)
def test_even_what_is_trusted_sees_nothing_of_the_machine(goal: str) -> None:
    engine = Engine()
    try:
        assert engine.once(goal) is None
    except GoalError as error:
        assert error.diagnostic.code == "P111"  # noqa: PT017 - it may fail instead
    assert os.environ["PATH"] not in str(engine.once("getenv('PATH', X)"))


def test_files_that_prolog_writes_are_its_own() -> None:
    engine = Engine()
    engine.once("open('/tmp/ropsim_x', write, S), write(S, hello), close(S)")
    answer = engine.once("open('/tmp/ropsim_x', read, S), read_string(S, _, T), close(S)")
    assert answer is not None
    assert answer["T"] == "hello"
    assert not os.path.exists("/tmp/ropsim_x")  # noqa: PTH110 - the real one
    assert engine.once("read_term(user_input, X, [])") == {"X": Atom("end_of_file")}

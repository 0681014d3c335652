"""Bodies as terms and as task text: each way back gives what was there, and the language reads all of it."""

import random
import re
from dataclasses import replace
from pathlib import Path

import pytest

import ropsim.tasks
from ropsim.core import SourceText
from ropsim.flow import GripAction
from ropsim.icr import run
from ropsim.language import LineCache, compile, read, statements
from ropsim.prolog import Atom, Struct, Term, Var
from ropsim.spatial import Pose
from ropsim.tasks import TaskCall, library, program_text, stored_clause, task_text, version_of, words
from ropsim.tasks.testing import NoTermError, NotTextError, body_lines, body_terms
from support.examples import examples
from support.knowledge import CELL, base

PL = Path(ropsim.tasks.__file__).parent / "pl"
NAMES = {"L": "l", "D": "d"}
BACK = {text: name for name, text in NAMES.items()}


def terms(text: str) -> tuple[Term, ...]:
    """Return the body of a text of statements."""
    lines = [line.statement for line in read(SourceText("", text), LineCache()) if line.statement is not None]
    return body_terms(iter(lines), BACK)


class Bodies:
    """Random bodies in the form that texts have: negative numbers are numbers, nothing is denied twice."""

    def __init__(self, seed: int) -> None:
        self.random = random.Random(seed)

    def body(self, depth: int) -> tuple[Term, ...]:
        return tuple(self.statement(depth) for _ in range(self.random.randint(1, 4)))

    def statement(self, depth: int) -> Term:
        pick = self.random.choice
        simple: list[Term] = [
            Atom(pick(("open", "close", "stop", "break"))),
            Struct(pick(("mov", "lin")), (self.location(2),)),
            Struct("lin", (self.location(1), (Atom("fine"), Struct("speed", (self.quantity("mm/s"),))))),
            Struct("circ", (self.location(1), self.location(0), (Atom("fine"), self.output()))),
            Struct("spline", ((self.location(0), self.location(1)), self.location(0))),
            Struct("mov", (Var("L"), (Struct("via", ((self.location(0), self.location(1)),)), Atom("fine")))),
            Struct("lin", (Var("L"), (self.until(), Struct("store", (Atom("touch"),))))),
            Struct("wait", (self.quantity("s"),)),
            Struct("wait_until", (self.condition(2), self.quantity("s"))),
            Struct("set", (Atom("glue"), Atom(pick(("on", "off"))))),
            Struct("set", (Struct("blend", (self.quantity("mm"),)),)),
            Struct("load", ((Atom("u"), Atom("v"), Atom("w")), self.location(1))),
            Struct("call", (Struct("grip", (self.location(2),)),)),
            Struct("call", (Struct("f", (self.number(2), Struct("=", (Atom("n"), self.number(1))))),)),
            Struct(":=", (Struct("coordinate", (Atom("q"), Atom("x"))), self.number(3))),
            Struct("print", ((self.number(2), 'a "b" \\ c'),)),
        ]
        if depth == 0:
            return self.random.choice(simple)
        inner = self.body(depth - 1)
        blocks: list[Term] = [
            Struct("repeat", (self.number(1), inner)),
            Struct("repeat", (inner,)),
            Struct("if", (self.condition(2), inner)),
            Struct("if", (self.condition(2), inner, self.body(depth - 1))),
            Struct("while", (self.condition(1), inner)),
            Struct("for", (Atom("i"), 1, self.number(1), inner)),
            Struct("for", (Atom("i"), 1, self.number(1), 2, inner)),
            Struct("for_each", (Atom("q"), Atom("slots"), inner)),
            Struct("repeat_until", (self.condition(1), inner)),
            Struct("repeat_until", (self.number(1), self.condition(1), inner)),
            Struct("with", ((Struct("tool", (Atom("jaws"),)),), inner)),
        ]
        return self.random.choice([*simple, *blocks])

    def output(self) -> Term:
        side = self.random.choice(("start", "end"))
        return Struct("at", (self.quantity("mm"), Atom(side), Struct("set", (Atom("glue"), Atom("on")))))

    def until(self) -> Term:
        time = self.random.choice(((), (self.quantity("s"),)))
        return Struct("until", (self.condition(0), *time))

    def number(self, depth: int) -> Term:
        pick = self.random.choice
        if depth == 0 or self.random.random() < 0.3:
            return pick(
                (3, -2, 0.5, -1.25, 2e-07, Atom("a"), Var("D"), Struct("coordinate", (Atom("q"), Atom("z"))))
            )
        one, two = self.number(depth - 1), self.number(depth - 1)
        if self.random.random() < 0.2:
            return Struct("-", (one,)) if not isinstance(one, int | float) else Struct("sqrt", (one,))
        return Struct(pick(("+", "-", "*", "/", "mod")), (one, two))

    def quantity(self, unit: str) -> Term:
        first, slash, second = unit.partition("/")
        product = Struct("*", (self.random.choice((5, 2.5, -3)), Atom(first)))
        return Struct("/", (product, Atom(second))) if slash else product

    def location(self, depth: int) -> Term:
        pick = self.random.choice
        point = Struct("p", (self.number(1), 2, self.quantity("mm")))
        turned = Struct("p", (1, 2, 3, (Atom("down"), Struct("rz", (45,)))))
        if depth == 0 or self.random.random() < 0.3:
            return pick((Var("L"), Atom("infeed"), Atom("here"), point, turned))
        inner = self.location(depth - 1)
        return pick(
            (
                Struct("above", (inner, self.quantity("mm"))),
                Struct("offset", (inner, point)),
                Struct("in", (inner, Atom("pallet"))),
            )
        )

    def condition(self, depth: int) -> Term:
        pick = self.random.choice
        if depth == 0 or self.random.random() < 0.3:
            level = Struct("is", (Atom("ready"), Atom(pick(("on", "off", "true")))))
            return pick(
                (
                    Atom("ready"),
                    level,
                    Struct(pick(("<", ">=", "\\=", "==")), (self.number(1), self.number(1))),
                )
            )
        one, two = self.condition(depth - 1), self.condition(depth - 1)
        denied = Atom("ready") if isinstance(one, Struct) and one.name == "not" else one
        return pick((Struct("and", (one, two)), Struct("or", (one, two)), Struct("not", (denied,))))


@pytest.mark.parametrize("seed", range(examples(40)))
def test_a_body_that_is_written_as_text_is_read_as_the_same_body(seed: int) -> None:
    body = Bodies(seed).body(2)
    assert terms("\n".join(body_lines(body, NAMES))) == body


def test_the_text_of_a_body_is_read_as_people_write_it() -> None:
    moves = "mov l above d + 2 * 3\nlin (1, 2, -3; down, rz 45 deg) speed 5 cm/s fine\n"
    written = body_lines(terms(f"{moves}set x = 2 < 3 and not (a = b)"), NAMES, 0)
    assert "\n".join(written) == f"{moves}set x = 2 < 3 and not a == b"


def test_elseif_is_an_if_inside_of_what_is_done_otherwise() -> None:
    (found,) = terms("if a < 1 then\nopen\nelseif a < 2 then\nclose\nelse\nstop\nendif")
    inner = Struct("if", (Struct("<", (Atom("a"), 2)), (Atom("close"),), (Atom("stop"),)))
    assert found == Struct("if", (Struct("<", (Atom("a"), 1)), (Atom("open"),), (inner,)))


def test_motions_on_arcs_with_outputs_and_conditions_compile_from_a_body() -> None:
    text = """\
task(bead(A, M, B), [params([A-location, M-location, B-location]), body([
  lin(A), circ(M, B, [at(3*mm, start, set(glue, on)), at(0.1*s, end, set(glue, off)), blend(2*mm)]),
  spline([above(M, 10*mm), A], B), mov(B, [via([A, M]), fine]),
  lin(A, [speed(5*mm/s), until(machine_ready, 3*s), store(touch)]), lin(touch),
  for(i, 3, 1, -1, [print([i])]), repeat_until(5, machine_ready, [wait(0.1*s)])])]).
"""
    known = base(text)
    assert known.findings == ()
    made = library(known, CELL, ["bead"])
    assert (list(made.tasks), made.refused) == (["bead"], {})


def test_a_motion_of_another_word_has_no_term() -> None:
    (line,) = (one.statement for one in read(SourceText("", "lin a"), LineCache()))
    assert isinstance(line, statements.Motion)
    with pytest.raises(NoTermError, match="`helix`"):
        body_terms(iter((replace(line, word="helix"),)), BACK)


def test_statements_for_editors_are_those_that_are_read() -> None:
    read_ = re.findall(r"^shape\(([a-z_:=]+),", (PL / "kb.pl").read_text("utf-8"), re.MULTILINE)
    assert set(words.STATEMENTS) == set(read_)


def test_conditions_on_patterns_for_editors_are_those_that_hold_of_no_fact() -> None:
    read_ = re.findall(r"^pattern\(([a-z_]+)\(", (PL / "kb.pl").read_text("utf-8"), re.MULTILINE)
    assert set(words.OF_PATTERNS) == set(read_)


@pytest.mark.parametrize(
    "wrong",
    [
        Atom("opn"), Struct("mov", (Atom("if"),)), Struct("mov", (Atom("mm"),)),
        Struct("mov", (Atom("a b"),)), Struct("mov", (Var("X"),)), Struct("print", ((),)),
        Struct("set", (Atom("a"), Struct("f", (1,)))),
        Struct("lin", (Atom("a"), (Struct("sped", (1,)),))), Struct("mov", (Struct("p", (1, 2)),)), 3, (),
    ],
)  # fmt: skip
def test_what_is_no_task_text_is_refused(wrong: Term) -> None:
    with pytest.raises(NotTextError):
        body_lines((wrong,), NAMES)


def test_a_task_text_is_kept_as_a_clause_that_means_the_same() -> None:
    text = """\
program p
units mm, deg, s
task Visit(at_: loc, clear: length = 60 mm, n: int)
  needs gripper open
  repeat n
    mov at_ above clear
    lin at_ offset (0, 0, -3)
    close
  endr
endp
Visit s1, n = 2
Visit s2, 5 cm, 1
"""
    clause, findings = stored_clause(SourceText("a.task", text), CELL)
    assert clause is not None
    assert findings == ()
    known = base(clause)
    assert known.findings == ()
    task = known.task("Visit")
    assert task is not None
    assert task.needs == (Struct("gripper", (Atom("open"),)),)
    again = text[: text.index("task")] + task_text(task) + "\n" + text[text.index("Visit s1") :]
    first, second = compile(text, CELL).icr, compile(again, CELL).icr
    assert first is not None
    assert second is not None
    assert [one.target for one in run(first).moves] == [one.target for one in run(second).moves]
    assert len(run(first).moves) == 6


def test_a_classic_task_is_kept_with_the_parameters_that_the_compiler_finds() -> None:
    text = '1. Task "grip"\n  Assumes gripper open at start\n  mov l\n  close\n  x := x + a\n  endp\n'
    clause, _ = stored_clause(SourceText("a.task", text), CELL)
    assert clause is not None
    task = base(clause).task("grip")
    assert task is not None
    assert [one.kind for one in task.parameters][:1] == ["location"]
    assert task.adds == (Struct("gripper", (Atom("closed"),)),)


@pytest.mark.parametrize(
    ("line", "code"),
    [("mov (1, 2, 3; config (left))", "P145"), ("mvo l", "L101")],
)
def test_what_terms_have_no_form_for_is_told(line: str, code: str) -> None:
    clause, findings = stored_clause(SourceText("a.task", f"program p\ntask T(l: loc)\n{line}\nendp"), CELL)
    assert clause is None
    assert code in [one.code for one in findings] or code == "L101"


def test_the_version_of_a_task_is_that_which_its_calls_name_and_changes_with_its_content() -> None:
    versions: list[str] = []
    for height in (10, 10, 11):
        known = base(
            f"% {len(versions)}\ntask(go(L), [params([L-location]), body([mov(above(L, {height}*mm))])])."
        )
        task = known.task("go")
        assert task is not None
        versions.append(version_of(task))
        assert library(known, CELL, ["go"]).tasks["go"].version == versions[-1]
    assert versions[0] == versions[1] != versions[2]


def test_palletize_of_the_library_makes_the_moves_of_the_paper() -> None:
    calls = [TaskCall("palletize", ((13.0, 5.0, 8.0), (6.0, 3.0, 2.0)), (0.1, 6))]
    code = compile(program_text(base().task, calls, "main", "cm, deg, s"), CELL).icr
    assert code is not None
    trace = run(code)
    places = [
        tuple(round(100 * c, 6) for c in one.target.position)
        for one in trace.moves
        if isinstance(one.target, Pose)
    ]
    grips = [(13 + 0.1 * column, 5 + 0.1 * row, 8.0) for row in range(6) for column in range(6)]
    assert places[0::2] == [tuple(round(c, 6) for c in one) for one in grips]
    assert set(places[1::2]) == {(6.0, 3.0, 2.0)}
    assert [one.action for one in trace.grips] == [GripAction.CLOSE, GripAction.OPEN] * 36


def test_a_classic_program_calls_tasks_of_the_knowledge_base_by_name() -> None:
    known = base("task(wave(L, T), [params([L-location, T-time]), body([mov(L), wait(T)])]).")
    environment = replace(CELL, tasks=library(known, CELL, known.names).tasks)
    assert set(environment.tasks) == set(known.names)
    text = """\
Task "both"
  Needs two reference locations.
  call grip l
  call release 2
  wave l, 3
  endp

both s1, (6, 3, 2)
palletize (13,5,8), (6,3,2), 0.1, 6.
"""
    code = compile(text, environment).icr
    assert code is not None
    trace = run(code)
    assert len(trace.moves) == 3 + 72
    places = [one.target.position for one in trace.moves if isinstance(one.target, Pose)]
    assert places[5].tolist() == pytest.approx([0.131, 0.05, 0.08])  # bare lengths are centimetres there
    wrong = compile("pallettize s1, s2, 0.1, 6", environment).diagnostics
    assert [one.code for one in wrong] == ["N201"]
    assert "palletize" in wrong[0].hint


def test_headers_are_statements_of_the_language() -> None:
    lines = list(read(SourceText("", task_text(base().tasks()[0])), LineCache()))
    assert sum(isinstance(one.statement, statements.TaskHeader) for one in lines) == 1

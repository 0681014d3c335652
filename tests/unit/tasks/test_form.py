"""Tasks as forms: the form and the clause are two views of one thing, and only what changes is written."""

import re
from dataclasses import replace
from typing import Any

import pytest

from ropsim.core import Span
from ropsim.tasks import FormParameter, KnownTask, Layer, TaskError, TaskForm, edited, form_clause, form_of
from ropsim.tasks.testing import library_texts
from support.knowledge import base

NOWHERE = Span.whole_line("", 1)
WAVE = """\
% ours
task(wave(L, N),   [ doc("Waves."), params([L-location, N-int = 3]), % twice is too few
   pre([ \\+ held(_) ]),
   body([repeat(N, [mov(above(L, 10*mm)), /* down */ mov(L)])])]).
"""


def task_of(name: str, *texts: str) -> KnownTask:
    found = base(*texts).task(name)
    assert found is not None
    return found


def changed(text: str, name: str, form: TaskForm) -> tuple[str, list[str]]:
    """Return the text with a changed form of a task, and the fields that it cannot take."""
    known = base(text)
    task, places = known.task(name), known.clause(name)
    assert task is not None
    assert places is not None
    before, after = (form_clause(one, known.term_faults) for one in (form_of(task), form))
    found, faults = edited(text, places, before, after)
    return found, [one.field for one in (*after.faults, *faults)]


def test_the_form_of_every_task_of_the_library_means_the_same_task() -> None:
    known = base()
    tasks = {one.name: replace(one, span=NOWHERE, layer=Layer.PROJECT) for one in known.tasks()}
    clauses = [form_clause(form_of(one), known.term_faults) for one in known.tasks()]
    assert [one.faults for one in clauses] == [()] * len(tasks)
    again = base("\n".join(one.text for one in clauses))
    assert {one.code for one in again.findings} == {"P146"}
    found = {one.name: replace(one, span=NOWHERE, layer=Layer.PROJECT) for one in again.tasks()}
    assert re.sub(r"_\d+", "_", repr(found)) == re.sub(r"_\d+", "_", repr(tasks))


def test_a_form_that_has_not_changed_leaves_every_text_as_it_stands() -> None:
    texts = {one.name: one.text for one in library_texts()}
    known = base()
    for task in known.tasks():
        places = known.clause(task.name)
        assert places is not None
        clause = form_clause(form_of(task), known.term_faults)
        assert edited(texts[places.source], places, clause, clause) == (texts[places.source], ())


def test_only_what_has_changed_is_written_anew() -> None:
    form = form_of(task_of("wave", WAVE))
    assert form.needs == ("\\+ held(_)",)
    assert form.body == "repeat n\n  mov l above 10 mm\n  mov l\nendr"
    found, faults = changed(WAVE, "wave", replace(form, doc='Says "hello".', effects=("+greeted(L)",)))
    assert faults == []
    assert found == WAVE.replace('"Waves."', '"Says \\"hello\\"."').replace(
        "mov(L)])])]).", "mov(L)])]),\n  eff([+greeted(L)])])."
    )
    assert task_of("wave", found).doc == 'Says "hello".'
    renamed, _ = changed(WAVE, "wave", replace(form, name="greet", needs=()))
    assert renamed == WAVE.replace("wave(L, N)", "greet(L, N)").replace("pre([ \\+ held(_) ])", "pre([])")


def test_a_comment_that_a_form_does_not_show_is_never_lost() -> None:
    form = form_of(task_of("wave", WAVE))
    assert changed(WAVE, "wave", replace(form, body="mov l")) == (WAVE, ["body"])


def test_a_new_task_is_a_clause_that_is_read_without_findings() -> None:
    height = FormParameter("Height", "length", "80 mm", "height", "how far up", (">= 0 mm", "=< 0.5 m"))
    form = TaskForm(
        "lift",
        "Lifts what is held.",
        (FormParameter("P", "part"), FormParameter("L", "location"), height),
        ("held(P)", "free(L)"),
        ("+lifted(P)",),
        ("reachable(arm, L)",),
        "mov l above height\nif height > 10 mm then\n  wait 0.5 s\nendif",
    )
    clause = form_clause(form, base().term_faults)
    assert clause.faults == ()
    text = f"{clause.text}goal(lifted/1).\n"
    assert [one.code for one in base(text).findings] == []
    again = form_of(task_of("lift", text))
    assert replace(again, parameters=()) == replace(form, parameters=())
    assert again.parameters[2] == replace(height, called="height")


@pytest.mark.parametrize(
    ("change", "field", "words"),
    [
        ({"name": "Lift"}, "name", "`Lift` is no name of a task"),
        ({"name": ""}, "name", "a task needs a name"),
        ({"name": "mov"}, "name", "`mov` is no name of a task"),
        ({"needs": ("held(P",)}, "pre", "`held(P`: this is no term"),
        ({"needs": ("held(P)", "a, b")}, "pre", "`a, b`: this is not one term"),
        ({"needs": ("a]), body([b",)}, "pre", "`a]), body([b`: this is no term"),
        ({"body": "mov"}, "body", "expected a value"),
        ({"body": "repeat 2\n  mov l"}, "body", "a block has no end"),
        ({"body": "mov l\nendr\nmov l"}, "body", "there is no block to end"),
        ({"parameters": (FormParameter("l", "location"),)}, "parameters", "`l` is no name of a parameter"),
        ({"parameters": (FormParameter("L", "place"),)}, "parameters", "there is no kind `place`"),
        ({"parameters": (FormParameter("L", "length", "much"),)}, "parameters", "`much` is no value"),
        ({"parameters": (FormParameter("N", "int", bounds=(">= x",)),)}, "parameters", "`x` is no bound"),
    ],
)
def test_what_a_field_says_wrongly_is_told_beside_it(change: dict[str, Any], field: str, words: str) -> None:
    form = replace(TaskForm("lift", "", (FormParameter("L", "location"),)), **change)
    faults = form_clause(form, base().term_faults).faults
    assert [one.field for one in faults] == [field]
    assert words in faults[0].finding.message


def test_what_a_form_cannot_show_is_told() -> None:
    odd = task_of("odd", "task(odd(L), [params([L-location]), body([mov(in(L, 3))])]).")
    with pytest.raises(TaskError, match="a form cannot show the body of `odd`"):
        form_of(odd)


def test_what_is_quoted_or_nameless_in_a_text_stays_what_it_is() -> None:
    text = """\
task(turn(P, _L), [doc("Turns."), params([P-part, _L-location = 'my Place']),
  pre([at(P, _5), free(_5)]), body([mov(_L), repeat(0'%, [open])])]).
"""
    form = form_of(task_of("turn", text))
    more = replace(form, parameters=(*form.parameters, FormParameter("M", "int")), body=form.body + "\nclose")
    found, faults = changed(text, "turn", more)
    assert faults == []
    assert "params([P-part, _L-location = 'my Place', M-int])" in found
    assert "pre([at(P, _5), free(_5)])" in found
    assert "body([mov(_L), repeat(37, [open]), close])" in found
    assert changed(text, "turn", replace(form, needs=("free(P)",))) == (text, ["pre"])

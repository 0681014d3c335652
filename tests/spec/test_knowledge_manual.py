"""The manual of knowledge bases: its examples have the findings that their comments name, and no others."""

import re

import pytest

from ropsim.tasks import Quantity, TaskCall, effect_findings, own_tasks, program_text
from ropsim.tasks.testing import KINDS
from support.knowledge import base
from support.manual import DOCS, Block, blocks

PAGE = DOCS / "reference" / "knowledge-base.md"
NAMED = re.compile(r"% (error|warning): (P\d{3}(?:, P\d{3})*)$")


@pytest.mark.parametrize("block", blocks(PAGE, "prolog"), ids=str)
def test_an_example_has_the_findings_that_its_comments_name(block: Block) -> None:
    wanted = [
        (number, code, match[1])
        for number, line in enumerate(block.lines, 1)
        if (match := NAMED.search(line))
        for code in match[2].split(", ")
    ]
    known = base(block.text)
    every = (*known.findings, *effect_findings(known, own_tasks(known)))
    found = [(one.span.line, one.code, one.severity.value) for one in every if one.span]
    assert sorted(found) == sorted(wanted)


@pytest.mark.parametrize("block", blocks(PAGE, "python"), ids=str)
def test_the_python_of_the_manual_runs(block: Block) -> None:
    exec(block.text, {})


def test_the_manual_names_every_kind_and_every_task_of_the_library() -> None:
    text = PAGE.read_text("utf-8")
    assert [name for name in (*KINDS, *base().names) if f"`{name}`" not in text] == []


def test_the_page_on_programs_of_tasks_shows_the_text_that_is_made() -> None:
    page = (DOCS / "how-to" / "program-from-tasks.md").read_text("utf-8")
    shown = page.split("```task file=pallet/programs/fill.task\n")[1].split("```")[0]
    points, numbers = ("infeed", "point_1"), (2, 2, Quantity(75, "mm"))
    made = program_text(base().task, [TaskCall("load_pallet", points, numbers)], "fill")
    assert [line for line in shown.splitlines() if not line.startswith("loc ")] == made.splitlines()

"""The manual of ICR: its table is that of the machine, its examples do what they say."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

from ropsim import icr
from ropsim.core import Diagnostic
from ropsim.icr import diagnostics as rules
from ropsim.icr.machine import trap_kinds
from ropsim.icr.machine.machine import BUDGET
from support.manual import DOCS, Block, blocks

PAGE = DOCS / "reference" / "icr.md"
BLOCKS = blocks(PAGE, "icr")


def said(block: Block, word: str) -> set[tuple[int, str]]:
    """Return line and code of the comments of one kind."""
    found = ((number, re.search(rf"; {word}: (\w+)$", line)) for number, line in enumerate(block.lines, 1))
    return {(number, match[1]) for number, match in found if match}


def placed(found: tuple[Diagnostic, ...]) -> set[tuple[int, str]]:
    return {(one.span.line if one.span else 0, one.code) for one in found}


@pytest.mark.parametrize("block", BLOCKS, ids=str)
def test_an_example_is_verified_as_it_says(block: Block) -> None:
    program, found = icr.read_text(block.text)
    if program is not None:
        found = icr.verify(program)
    assert placed(found) == said(block, "error")


@pytest.mark.parametrize("block", BLOCKS, ids=str)
def test_printing_an_example_and_reading_it_again_changes_nothing(block: Block) -> None:
    program = icr.assemble(block.text)
    text = icr.disassemble(program)
    assert icr.assemble(text) == program
    assert icr.disassemble(icr.assemble(text)) == text


@pytest.mark.parametrize("block", [one for one in BLOCKS if "error:" not in one.text], ids=str)
def test_an_example_that_is_right_runs_as_it_says(block: Block) -> None:
    trace = icr.run(icr.assemble(block.text))
    assert placed((trace.trap,) if trace.trap else ()) == said(block, "trap")
    assert trace.steps > 0


def test_the_first_example_is_canonical_and_makes_four_moves() -> None:
    program = icr.assemble(BLOCKS[0].text)
    assert icr.disassemble(program) == BLOCKS[0].text
    assert len(icr.run(program).moves) == 4


def test_comments_label_names_and_source_lines_do_not_change_the_identity() -> None:
    text = BLOCKS[0].text
    other = text.replace("L0", "again").replace("FRAME st1", "LINE 7\n  FRAME st1 ; here")
    assert icr.program_id(icr.assemble(other)) == icr.program_id(icr.assemble(text))


def test_the_table_is_that_of_the_machine() -> None:
    root = Path(__file__).parents[2]
    command = [sys.executable, "tools/icr_table.py", "--check"]
    result = subprocess.run(command, cwd=root, capture_output=True, text=True, check=False)
    assert (result.returncode, result.stderr) == (0, ""), result.stdout
    page = PAGE.read_text("utf-8")
    assert [name for name in icr.OPCODES if f"`{name}`" not in page] == []


def test_every_rule_and_trap_has_its_code_on_the_page() -> None:
    page = PAGE.read_text("utf-8")
    kinds = [*vars(rules).values(), *vars(trap_kinds).values()]
    codes = sorted({kind.code for kind in kinds if hasattr(kind, "code")})
    assert len(codes) == 34
    assert [code for code in codes if f"[{code}](diagnostics/{code}.md)" not in page] == []
    assert f"{BUDGET:,}".replace(",", " ") in page

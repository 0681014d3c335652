"""Golden files of the task language: structured forms of programs, findings of bad ones."""

from pathlib import Path

import pytest

from ropsim.language import NO_SIGNATURES, compile
from support.golden import check_golden
from support.sir import render
from support.tasks import CELL, findings

HERE = Path(__file__).parent
PROGRAMS = sorted((HERE / "task").glob("*.task"))
BAD = sorted((HERE / "bad").glob("*.task"))


@pytest.mark.parametrize("path", PROGRAMS, ids=lambda p: p.stem)
def test_program_gives_its_structured_form_and_findings(path: Path) -> None:
    environment = NO_SIGNATURES if path.stem == "fig5" else CELL
    result = compile(path.read_text(encoding="utf-8"), environment, path.name)
    assert result.program is not None
    check_golden(path.with_suffix(".sir"), render(result.program))
    check_golden(path.with_suffix(".diag"), findings(result))


@pytest.mark.parametrize("path", BAD, ids=lambda p: p.stem)
def test_bad_program_gives_its_findings(path: Path) -> None:
    text = path.read_text(encoding="utf-8")
    assert text.startswith("# "), "the first line says why the program is bad"
    result = compile(text, CELL, path.name)
    assert result.diagnostics
    check_golden(path.with_suffix(".diag"), findings(result))

from dataclasses import replace
from pathlib import Path

import pytest

from ropsim.icr import (
    Constant,
    Procedure,
    Program,
    Step,
    Type,
    assemble,
    disassemble,
    program_id,
    run,
    verify,
)

GOLDEN = sorted((Path(__file__).parents[3] / "golden" / "icr").glob("*.icr"))


@pytest.mark.parametrize("path", GOLDEN, ids=lambda path: path.stem)
def test_a_golden_program_is_canonical_sound_and_repeatable(path: Path) -> None:
    text = path.read_text(encoding="ascii")
    program = assemble(text, path.name)
    assert disassemble(program) == text
    assert verify(program) == ()
    assert run(program) == run(program)


def test_the_golden_programs_are_there() -> None:
    assert {path.stem for path in GOLDEN} >= {"square", "geometry", "signals", "lowered", "external"}


def test_free_text_becomes_canonical() -> None:
    free = (
        "; hello\nICR 1.0  t\nREQUIRE CAP ZONE PTP\n\nPROC main\nstart: \n"
        " ZONE.FINE ; fine\n PUSH REAL 1e-1\nPOP\nHOME\nJMP start\nEND"
    )
    assert disassemble(assemble(free)) == (
        "ICR 1.0 t\nREQUIRE CAP PTP ZONE\nPROC main\nL0:\n"
        "  ZONE.FINE\n  PUSH REAL 0.1\n  POP\n  HOME\n  JMP L0\nEND\n"
    )


def test_numbers_are_written_in_the_shortest_form_that_reads_back() -> None:
    value = 0.1 + 0.2
    program = Program("t", (Procedure("main", code=(Step("PUSH", (Constant(Type.REAL, value),)),)),))
    text = disassemble(program)
    assert "PUSH REAL 0.30000000000000004" in text
    assert assemble(text) == program


def test_the_text_is_ascii_whatever_the_names() -> None:
    program = Program(
        "prüfung", (Procedure("greif zu\n", code=(Step("RET"),)), Procedure("main", code=(Step("HALT"),)))
    )
    assert disassemble(program).isascii()
    assert assemble(disassemble(program)) == program


def test_identity_does_not_depend_on_source_lines_and_comments() -> None:
    text = "ICR 1.0 t\nPROC main\n  HALT\nEND\n"
    traced = text.replace("  HALT", "  LINE 4\n  HALT ; end").replace("t\nPROC", 't\nSOURCE "x"\nPROC')
    assert program_id(assemble(text)) == program_id(assemble(traced))


def test_identity_depends_on_every_instruction() -> None:
    program = assemble("ICR 1.0 t\nPROC main\n  NOP\n  HALT\nEND\n")
    shorter = replace(program, procedures=(replace(program.procedures[0], code=(Step("HALT"),), lines=(0,)),))
    assert program_id(program) != program_id(shorter)
    assert len(program_id(program)) == 64


LOCALS = """\
ICR 1.0 p
VAR x REAL
PROC main
  PUSH REAL 1.0
  STORE x
  LINE 4
  CALL T
  HALT
END
PROC T
LOCAL a REAL
LOCAL b REAL
  LOAD x
  STORE a
  LOAD a
  STORE b
  RET
END
"""


@pytest.mark.parametrize(
    ("old", "new", "is_same"),
    [
        ("LINE 4", "LINE 40", True),
        ("ICR 1.0 p\n", 'ICR 1.0 p\nSOURCE "p.task"\n', True),
        (" a", " later", True),
        (" x", " y", True),
        ("LOAD a", "LOAD b", False),
        ("LOAD x", "LOAD a", False),
    ],
)
def test_lines_sources_and_names_of_variables_are_no_part_of_what_a_program_is(
    old: str, new: str, *, is_same: bool
) -> None:
    program, other = assemble(LOCALS), assemble(LOCALS.replace(old, new))
    assert (program_id(program) == program_id(other)) == is_same


def test_programs_with_other_source_lines_are_equal() -> None:
    assert assemble(LOCALS) == assemble(
        LOCALS.replace("LINE 4", "LINE 40").replace("ICR 1.0 p\n", 'ICR 1.0 p\nSOURCE "q"\n')
    )

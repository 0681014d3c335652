"""The identity of a program: what it means counts, not how it is written down."""

from dataclasses import replace
from random import Random
from typing import TypeVar

import pytest

from ropsim.icr import Program, assemble, program_id
from ropsim.language import compile

T = TypeVar("T")
TEXT = """ICR 1.0 two
REQUIRE CAP IO MSG
VAR n INT
VAR m INT
IO DO lamp BOOL
IO DO bell BOOL
PROC main
LOCAL b BOOL
LOCAL c BOOL
  PUSH INT 1
  STORE n
  PUSH INT 2
  STORE m
  PUSH BOOL TRUE
  STORE b
  PUSH BOOL FALSE
  STORE c
  CALL first
  LOAD b
  OUT lamp
  LOAD c
  OUT bell
  CALL second
  HALT
END
PROC first
  PUSH STR "first"
  MSG
  RET
END
PROC second
  LOAD n
  LOAD m
  ADD.I
  FMT
  MSG
  RET
END
"""
TASKS = """program p
var total: int = 0
task Count(n: int)
  k = n * 2
  total = total + k
end
task Say
  print total
end
Count 3
Say
"""


def test_names_of_variables_do_not_count() -> None:
    other = TEXT
    for old, new in ((" n", " number"), (" m", " n"), (" b", " x"), (" c", " b")):
        other = other.replace(f"{old} ", f"{new} ").replace(f"{old}\n", f"{new}\n")
    assert other != TEXT
    assert program_id(assemble(other)) == program_id(assemble(TEXT))


@pytest.mark.parametrize("seed", range(5))
def test_the_order_of_declarations_does_not_count(seed: int) -> None:
    program = assemble(TEXT)
    random = Random(seed)

    def shuffled(items: tuple[T, ...]) -> tuple[T, ...]:
        return tuple(random.sample(items, len(items)))

    procedures = [
        replace(one, locals=shuffled(one.locals)) if one.name == "main" else one
        for one in shuffled(program.procedures)
    ]
    other = replace(
        program,
        procedures=tuple(procedures),
        variables=shuffled(program.variables),
        channels=shuffled(program.channels),
    )
    assert program_id(other) == program_id(program)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("PUSH INT 2", "PUSH INT 3"),
        ("STORE m", "STORE n"),
        ("LOAD b\n  OUT lamp", "LOAD c\n  OUT lamp"),
        ("CALL first", "CALL second"),
        ("ICR 1.0 two", "ICR 1.0 three"),
        ("IO DO lamp BOOL\n", "IO DO lamp BOOL\nIO DI part BOOL\n"),
        ("VAR m INT\n", "VAR m INT\nVAR k INT\n"),
        ("LOCAL c BOOL\n", "LOCAL c BOOL\nLOCAL d BOOL\n"),
    ],
)
def test_all_else_counts(old: str, new: str) -> None:
    assert old in TEXT
    assert program_id(assemble(TEXT.replace(old, new, 1))) != program_id(assemble(TEXT))


def compiled(text: str) -> Program:
    code = compile(text).icr
    assert code is not None
    return code


def test_a_task_may_be_moved_and_its_variables_renamed() -> None:
    moved = TASKS.split("task Say")
    count, rest = moved[0].split("task Count")
    last = rest.replace("k", "twice")
    say, calls = moved[1].split("end\n", 1)
    other = f"{count}# moved\ntask Say{say}end\ntask Count{last}{calls}"
    assert other != TASKS
    assert program_id(compiled(other)) == program_id(compiled(TASKS))


def test_the_identity_is_found_once_and_a_changed_copy_has_its_own() -> None:
    program = assemble(TEXT)
    found = program_id(program)
    assert program_id(program) is found
    assert program == assemble(TEXT)  # to have asked makes no other program
    other = replace(program, procedures=program.procedures[:1])
    assert program_id(other) != found
    assert program_id(replace(other, procedures=program.procedures)) == found

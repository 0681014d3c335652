"""Print and parse are inverse; no text and no damage makes reader, verifier or machine fail."""

from dataclasses import replace
from functools import cache
from pathlib import Path
from typing import TypeVar

from hypothesis import given, settings
from hypothesis import strategies as st

from ropsim.icr import (
    OPCODES,
    WORDS,
    Constant,
    FrameDefinition,
    IoChannel,
    Operand,
    OperandKind,
    Procedure,
    Program,
    Step,
    ToolDefinition,
    Type,
    Variable,
    assemble,
    disassemble,
    program_id,
    read_text,
    run,
    verify,
)
from support.characters import ANY
from support.examples import examples

GOLDEN = sorted((Path(__file__).parent.parent / "golden" / "icr").glob("*.icr"))
TEXTS = [path.read_text(encoding="ascii") for path in GOLDEN]
PROGRAMS = [assemble(text) for text in TEXTS]
BUDGET = 20_000

names = st.text(ANY, min_size=1, max_size=8)
reals = st.floats(allow_nan=False)
types = st.sampled_from(Type)
Named = TypeVar("Named", Variable, IoChannel, FrameDefinition, ToolDefinition)


def numbers(count: int) -> st.SearchStrategy[tuple[float, ...]]:
    return st.tuples(*[reals] * count)


poses = st.tuples(reals, reals, reals, reals, reals, reals, reals)
constants = st.one_of(
    st.booleans().map(lambda value: Constant(Type.BOOL, value)),
    st.integers(-(2**63), 2**63 - 1).map(lambda value: Constant(Type.INT, value)),
    reals.map(lambda value: Constant(Type.REAL, value)),
    st.text(ANY, max_size=8).map(lambda value: Constant(Type.STR, value)),
    numbers(3).map(lambda value: Constant(Type.VEC, value)),
    numbers(4).map(lambda value: Constant(Type.ORI, value)),
    numbers(7).map(lambda value: Constant(Type.POSE, value)),
    st.tuples(numbers(7), st.lists(reals, max_size=12)).map(
        lambda parts: Constant(Type.POSE, (*parts[0], *parts[1]))
    ),
    st.lists(reals, min_size=1, max_size=7).map(lambda value: Constant(Type.JOINTS, tuple(value))),
)
MAX_CODE = 12


@cache
def operand(kind: OperandKind) -> st.SearchStrategy[Operand]:
    if kind is OperandKind.CONSTANT:
        return constants
    if kind is OperandKind.POSTURE:
        return st.from_regex(r"\A[a-z][a-z0-9_]*(-[a-z][a-z0-9_]*){0,2}\Z", alphabet=ANY)
    if kind in WORDS:
        return st.sampled_from(WORDS[kind])
    if kind in {OperandKind.FRAME, OperandKind.TOOL}:
        return st.one_of(st.just(""), names)
    if kind is OperandKind.LABEL:
        return st.integers(0, MAX_CODE)
    if kind in {OperandKind.COUNT, OperandKind.INDEX, OperandKind.NUMBER, OperandKind.CATEGORY}:
        return st.integers(0, 10**6)
    return names


OPCODE = st.sampled_from(list(OPCODES.values()))


@st.composite
def steps(draw: st.DrawFn) -> Step:
    opcode = draw(OPCODE)
    return Step(opcode.mnemonic, tuple(draw(operand(kind)) for kind in opcode.operands))


def distinct(one: st.SearchStrategy[Named], most: int) -> st.SearchStrategy[list[Named]]:
    """Return lists of what has names, no two of which are equal."""
    return st.lists(one, max_size=most, unique_by=lambda found: found.name)


KINDS = [("DI", Type.BOOL), ("DO", Type.BOOL), ("AI", Type.REAL), ("AO", Type.INT)]
CODE = st.lists(steps(), max_size=MAX_CODE)
VARIABLES = st.builds(Variable, names, types)
SLOTS, SOME_VARIABLES = distinct(VARIABLES, 4), distinct(VARIABLES, 3)
CHANNELS = distinct(st.builds(lambda name, kind: IoChannel(name, *kind), names, st.sampled_from(KINDS)), 3)
FRAMES = distinct(st.builds(FrameDefinition, names, poses), 2)
TOOLS = distinct(st.builds(ToolDefinition, names, st.none() | poses), 2)
RESULTS = st.lists(types, max_size=2)
NAMES, PARTS = st.lists(names, min_size=1, max_size=3, unique=True), st.sets(names, max_size=3)
AXES = st.none() | st.integers(-3, 40)
"""Strategies are made once: to make and to check one takes longer than to draw from it."""


@st.composite
def procedures(draw: st.DrawFn, name: str) -> Procedure:
    code = draw(CODE)
    fitted = tuple(
        replace_target(step, len(code)) if OPCODES[step.mnemonic].operands == (OperandKind.LABEL,) else step
        for step in code
    )
    variables = draw(SLOTS)
    cut = draw(st.integers(0, len(variables)))
    lines = draw(st.lists(st.integers(0, 99), min_size=len(code), max_size=len(code)))
    results = tuple(draw(RESULTS))
    return Procedure(name, tuple(variables[:cut]), tuple(variables[cut:]), results, fitted, tuple(lines))


def replace_target(step: Step, size: int) -> Step:
    target = step.operands[0]
    return Step(step.mnemonic, (min(target, size) if isinstance(target, int) else 0,))


@st.composite
def programs(draw: st.DrawFn) -> Program:
    """Return a program that can be written down; the verifier refuses most of them."""
    return Program(
        draw(st.text(ANY, max_size=8)),
        tuple(draw(procedures(name)) for name in draw(NAMES)),
        capabilities=tuple(sorted(draw(PARTS))),
        axes=draw(AXES),
        variables=tuple(draw(SOME_VARIABLES)),
        channels=tuple(draw(CHANNELS)),
        frames=tuple(draw(FRAMES)),
        tools=tuple(draw(TOOLS)),
        source=draw(st.text(ANY, max_size=8)),
    )


@settings(max_examples=examples(150), derandomize=True)
@given(programs())
def test_parse_is_the_inverse_of_print(program: Program) -> None:
    text = disassemble(program)
    assert text.isascii()
    assert assemble(text) == program
    assert disassemble(assemble(text)) == text
    assert program_id(assemble(text)) == program_id(program)


@settings(max_examples=examples(100), derandomize=True)
@given(programs())
def test_the_verifier_answers_for_every_program(program: Program) -> None:
    assert all(one.is_error and one.message and one.code.startswith("I4") for one in verify(program))


@settings(max_examples=examples(200), derandomize=True)
@given(st.text(ANY, max_size=400))
def test_no_text_makes_the_reader_fail(text: str) -> None:
    program, found = read_text(text)
    assert (program is None) == bool(found)
    lines = text.replace("\r\n", "\n").replace("\r", "\n").split("\n")
    assert all(one.span and 1 <= one.span.line <= len(lines) for one in found)


@settings(max_examples=examples(200), derandomize=True)
@given(st.sampled_from(TEXTS), st.data())
def test_a_damaged_text_is_refused_or_runs_to_an_end(text: str, data: st.DataObject) -> None:
    at = data.draw(st.integers(0, len(text) - 1))
    damage = data.draw(st.text(ANY, max_size=3))
    program, _ = read_text(text[:at] + damage + text[at + data.draw(st.integers(0, 3)) :])
    if program is not None and not verify(program):
        assert run(program, budget=BUDGET).steps <= BUDGET


def damaged(program: Program, data: st.DataObject) -> Program:
    """Return the program with one instruction dropped, doubled, swapped or given another operand."""
    number = data.draw(st.integers(0, len(program.procedures) - 1))
    procedure = program.procedures[number]
    code = list(procedure.code)
    at = data.draw(st.integers(0, len(code) - 1))
    damage = data.draw(st.sampled_from(["drop", "double", "swap", "operand", "mnemonic"]))
    if damage == "drop":
        del code[at]
    elif damage == "double":
        code.insert(at, code[at])
    elif damage == "swap":
        other = data.draw(st.integers(0, len(code) - 1))
        code[at], code[other] = code[other], code[at]
    else:
        opcode = OPCODES[code[at].mnemonic]
        if damage == "mnemonic":
            alike = [name for name, one in OPCODES.items() if one.operands == opcode.operands]
            code[at] = Step(data.draw(st.sampled_from(alike)), code[at].operands)
        else:
            code[at] = Step(opcode.mnemonic, tuple(data.draw(operand(kind)) for kind in opcode.operands))
    changed = replace(procedure, code=tuple(code), lines=(), places=())
    return replace(
        program, procedures=(*program.procedures[:number], changed, *program.procedures[number + 1 :])
    )


@settings(max_examples=examples(200), derandomize=True)
@given(st.sampled_from(PROGRAMS), st.data())
def test_a_damaged_program_is_refused_or_runs_to_an_end_in_the_same_way_twice(
    program: Program, data: st.DataObject
) -> None:
    changed = damaged(program, data)
    if not verify(changed):
        first = run(changed, budget=BUDGET)
        assert first.steps <= BUDGET
        assert first == run(changed, budget=BUDGET)


@settings(max_examples=examples(60), derandomize=True)
@given(st.sampled_from(PROGRAMS), st.data())
def test_dropping_a_push_never_passes_the_verifier(program: Program, data: st.DataObject) -> None:
    procedure = program.procedures[0]
    pushes = [k for k, step in enumerate(procedure.code) if step.mnemonic == "PUSH"]
    at = data.draw(st.sampled_from(pushes))
    code = procedure.code[:at] + procedure.code[at + 1 :]
    changed = replace(program, procedures=(replace(procedure, code=code, lines=()), *program.procedures[1:]))
    assert verify(changed)

"""Instructions in the binary form: each is its number in the table and its operands by their kind."""

from collections.abc import Sequence
from copy import copy
from dataclasses import replace

from ropsim.core import frozen_dataclass
from ropsim.icr.binary.sink import Sink
from ropsim.icr.binary.supply import DamageError, Supply
from ropsim.icr.binary.values import put_constant, take_constant
from ropsim.icr.opcodes import OPCODES, POSTURE, WORDS, OperandKind
from ropsim.icr.program import Operand, Procedure, Program, Step
from ropsim.icr.types import INT_MAX, Constant

_BY_CODE = {one.code: one for one in OPCODES.values()}
_INTEGERS = frozenset((OperandKind.COUNT, OperandKind.INDEX, OperandKind.NUMBER, OperandKind.CATEGORY))


@frozen_dataclass
class Names:
    """The names that operands stand for by their number.

    Attributes:
        tables: names of one kind of operand; frames and tools begin with the empty name, which is none.
        locals: parameters and locals of the procedure.
        shared: global variables.
    """

    tables: dict[OperandKind, Sequence[str]]
    locals: Sequence[str]
    shared: Sequence[str]

    @classmethod
    def of(cls, program: Program) -> "Names":
        """Return the names of a program; variables of procedures are not among them."""
        tables = {
            OperandKind.PROCEDURE: [one.name for one in program.procedures],
            OperandKind.CHANNEL: [one.name for one in program.channels],
            OperandKind.FRAME: ["", *(one.name for one in program.frames)],
            OperandKind.LIST: [one.name for one in program.lists],
            OperandKind.TOOL: ["", *(one.name for one in program.tools)],
        }
        shared = [one.name for one in program.variables]
        return cls({**tables, **WORDS}, (), shared)

    def within(self, procedure: Procedure) -> "Names":
        """Return the names that a procedure sees."""
        return replace(self, locals=[one.name for one in procedure.variables])


class Numbers:
    """The numbers that stand for names; see `Names`."""

    __slots__ = ("_locals", "_shared", "_tables")

    def __init__(self, names: Names) -> None:
        self._tables = {kind: _numbered(table) for kind, table in names.tables.items()}
        self._locals: dict[str, int] = {}
        self._shared = _numbered(names.shared)

    def within(self, procedure: Procedure) -> "Numbers":
        """Return the numbers in a procedure, including its variables."""
        own = copy(self)
        own._locals = procedure.numbers
        return own

    def of(self, kind: OperandKind, name: Operand) -> int:
        """Return the number of an operand; variables of the procedure are even, global ones odd."""
        text = str(name)
        if kind is not OperandKind.VARIABLE:
            return self._tables[kind][text]
        return 2 * self._locals[text] if text in self._locals else 2 * self._shared[text] + 1


def put_step(sink: Sink, step: Step, numbers: Numbers) -> None:
    """Write an instruction of a program that the verifier has passed."""
    opcode = OPCODES[step.mnemonic]
    sink.byte(opcode.code >> 8)
    sink.byte(opcode.code & 0xFF)
    for kind, operand in zip(opcode.operands, step.operands, strict=True):
        if isinstance(operand, Constant):
            put_constant(sink, operand)
        elif kind is OperandKind.POSTURE:
            sink.text(str(operand))
        elif kind is OperandKind.LABEL and isinstance(operand, int):
            sink.number(operand)
        elif isinstance(operand, int):
            sink.integer(operand)
        else:
            sink.number(numbers.of(kind, operand))


def take_step(supply: Supply, names: Names) -> Step:
    """Read an instruction."""
    start = supply.at
    code = supply.byte("an instruction") << 8 | supply.byte("an instruction")
    opcode = _BY_CODE.get(code)
    if opcode is None:
        raise DamageError(start, f"there is no instruction {code:04X}")
    return Step(opcode.mnemonic, tuple(_take(supply, kind, names) for kind in opcode.operands))


def _take(supply: Supply, kind: OperandKind, names: Names) -> Operand:
    start = supply.at
    if kind is OperandKind.CONSTANT:
        return take_constant(supply)
    if kind in _INTEGERS:
        return supply.integer(f"a {kind.value}")
    if kind is OperandKind.POSTURE:
        posture = supply.name("a posture")
        if not POSTURE.match(posture):
            raise DamageError(start, "a posture is no words with dashes between")
        return posture
    number = supply.number(f"a {kind.value}")
    if kind is OperandKind.LABEL:
        return min(number, INT_MAX)
    table = names.tables.get(kind, ())
    if kind is OperandKind.VARIABLE:
        table, number = (names.shared, number >> 1) if number & 1 else (names.locals, number >> 1)
    if number >= len(table):
        raise DamageError(start, f"there is no {kind.value} {number}, there are {len(table)}")
    return table[number]


def _numbered(names: Sequence[str]) -> dict[str, int]:
    return {name: number for number, name in enumerate(names)}

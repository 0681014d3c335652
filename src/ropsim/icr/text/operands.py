"""Operands of instructions in ICR text."""

from ropsim.icr.opcodes import POSTURE, WORDS, Opcode, OperandKind
from ropsim.icr.program import Operand
from ropsim.icr.text.literals import read_constant, read_int, written
from ropsim.icr.text.tokens import Token, is_name, named, shown
from ropsim.icr.types import Constant

_INTEGERS = {OperandKind.COUNT, OperandKind.INDEX, OperandKind.NUMBER, OperandKind.CATEGORY}
_OPTIONAL = {OperandKind.FRAME, OperandKind.TOOL}


def read_operands(opcode: Opcode, words: tuple[Token, ...]) -> tuple[Operand, ...] | str:
    """Return the operands, or their fault; the target of a jump is resolved later."""
    if opcode.operands == (OperandKind.CONSTANT,):
        constant = read_constant(words)
        return "a type and a value of this type are needed" if constant is None else (constant,)
    if len(words) != len(opcode.operands):
        allowed = " ".join(kind.value for kind in opcode.operands) or "none"
        return f"{len(words)} operands found, allowed: {allowed}"
    operands = tuple(_read(kind, word) for kind, word in zip(opcode.operands, words, strict=True))
    for kind, word, operand in zip(opcode.operands, words, operands, strict=True):
        if operand is None:
            return f"`{shown(word.text)}` is no {kind.value}"
    return tuple(operand for operand in operands if operand is not None)


def _read(kind: OperandKind, word: Token) -> Operand | None:
    if kind in _INTEGERS:
        return read_int(word)
    if kind in WORDS:
        return word.text if word.text in WORDS[kind] and not word.is_quoted else None
    if kind is OperandKind.POSTURE:
        return word.text if POSTURE.match(word.text) and not word.is_quoted else None
    if kind in _OPTIONAL and word.text == "-" and not word.is_quoted:
        return ""
    return word.text if is_name(word) else None


def written_operand(kind: OperandKind, operand: Operand, labels: dict[int, str]) -> str:
    """Return an operand in text form; `labels` has the names of jump targets."""
    if isinstance(operand, Constant):
        return written(operand)
    if isinstance(operand, int):
        return labels[operand] if kind is OperandKind.LABEL else str(operand)
    if kind in _OPTIONAL and not operand:
        return "-"
    return operand if kind in WORDS or kind is OperandKind.POSTURE else named(operand)

"""Collects the flat code of one procedure; code that no way leads to is not taken in."""

from dataclasses import dataclass, field
from typing import cast

from ropsim.icr import ENDS_FLOW, Constant, Operand, Step


@dataclass(eq=False, slots=True)
class Label:
    """A place in the code, known once it is placed."""

    position: int = -1
    is_used: bool = False


@dataclass(slots=True)
class Emitter:
    """The code of one procedure.

    Attributes:
        line: source line of what is emitted next, 0 where unknown.
        is_live: whether control can reach what is emitted next; otherwise it is dropped.
    """

    line: int = 0
    is_live: bool = True
    _code: list[tuple[str, tuple[Operand, ...] | tuple[Label], int]] = field(default_factory=list)

    def emit(self, mnemonic: str, *operands: Operand) -> None:
        """Add one instruction."""
        self._add(mnemonic, operands)

    def push(self, constant: Constant) -> None:
        """Add a PUSH."""
        self._add("PUSH", (constant,))

    def jump(self, mnemonic: str, label: Label) -> None:
        """Add JMP, JF or JT to a label."""
        if self.is_live:
            label.is_used = True
        self._add(mnemonic, (label,))

    def place(self, label: Label) -> None:
        """Let a label stand here; where it is jumped to, control reaches this place."""
        self.is_live = self.is_live or label.is_used
        label.position = len(self._code)

    def finished(self) -> tuple[tuple[Step, ...], tuple[int, ...]]:
        """Return the code and the source lines."""
        steps = tuple(Step(mnemonic, _placed(operands)) for mnemonic, operands, _ in self._code)
        return steps, tuple(line for _, _, line in self._code)

    def _add(self, mnemonic: str, operands: tuple[Operand, ...] | tuple[Label]) -> None:
        if self.is_live:
            self._code.append((mnemonic, operands, self.line))
            self.is_live = mnemonic not in ENDS_FLOW


def _placed(operands: tuple[Operand, ...] | tuple[Label]) -> tuple[Operand, ...]:
    """Return operands with the place of a label in its stead."""
    first = operands[0] if operands else None
    return (first.position,) if isinstance(first, Label) else cast(tuple[Operand, ...], operands)

"""Collects the flat code of one procedure; code that no way leads to is not taken in."""

from dataclasses import dataclass, field

from ropsim.icr import ENDS_FLOW, OPCODES, Constant, Operand, Step

_ALONE = {mnemonic: Step(mnemonic) for mnemonic in OPCODES}
"""Instructions without operands, each made once."""
_new = tuple.__new__
"""Makes an instruction in a fifth of the time of its class."""


@dataclass(eq=False, slots=True)
class Label:
    """A place in the code, known once it is placed."""

    position: int = -1
    is_used: bool = False


@dataclass(slots=True)
class Emitter:
    """The code of one procedure.

    Attributes:
        line: source line of the next instruction, 0 if unknown.
        is_live: whether control can reach the next instruction; otherwise it is dropped.
    """

    line: int = 0
    is_live: bool = True
    _steps: list[Step] = field(default_factory=list)
    _lines: list[int] = field(default_factory=list)
    _jumps: list[tuple[int, Label]] = field(default_factory=list)

    def emit(self, mnemonic: str, *operands: Operand) -> None:
        """Add an instruction of this form."""
        if self.is_live:
            self._steps.append(_new(Step, (mnemonic, operands)) if operands else _ALONE[mnemonic])
            self._lines.append(self.line)
            self.is_live = mnemonic not in ENDS_FLOW

    def add(self, step: Step) -> None:
        """Add an instruction behind which control goes on."""
        if self.is_live:
            self._steps.append(step)
            self._lines.append(self.line)

    def push(self, constant: Constant) -> None:
        """Add a PUSH."""
        self.emit("PUSH", constant)

    def jump(self, mnemonic: str, label: Label) -> None:
        """Add JMP, JF or JT to a label."""
        if self.is_live:
            label.is_used = True
            self._jumps.append((len(self._steps), label))
            self.emit(mnemonic)

    def place(self, label: Label) -> None:
        """Let a label stand here; where it is jumped to, control reaches this place."""
        self.is_live = self.is_live or label.is_used
        label.position = len(self._steps)

    def finished(self) -> tuple[tuple[Step, ...], tuple[int, ...]]:
        """Return the code and the source lines."""
        steps = list(self._steps)
        for at, label in self._jumps:
            steps[at] = _new(Step, (steps[at].mnemonic, (label.position,)))
        return tuple(steps), tuple(self._lines)

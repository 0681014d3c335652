"""The body of a procedure in ICR text: its interface, its labels and its instructions."""

from collections.abc import Callable

from ropsim.core import Kind, Span, did_you_mean
from ropsim.icr import diagnostics as kinds
from ropsim.icr.opcodes import OPCODES, OperandKind
from ropsim.icr.program import Operand, Procedure, Step, Variable
from ropsim.icr.text.literals import read_int
from ropsim.icr.text.operands import read_operands
from ropsim.icr.text.tokens import Token, is_name, shown
from ropsim.icr.types import Type

Report = Callable[[Kind, Span, str, str], None]


class Body:
    """Collects the records of one procedure.

    The methods for declarations return the fault in the form of the record, or an empty string.

    Args:
        name: of the procedure.
        report: takes diagnostics: kind, place, message, hint.
    """

    def __init__(self, name: str, report: Report) -> None:
        self.name = name
        self._report = report
        self._parameters: list[Variable] = []
        self._locals: list[Variable] = []
        self._results: list[Type] = []
        self._code: list[tuple[str, tuple[Operand, ...], Span]] = []
        self._lines: list[int] = []
        self._labels: dict[str, int] = {}
        self._line = 0

    def declare(self, words: tuple[Token, ...], place: Span) -> str:
        """Take in PARAM, LOCAL, RESULT or LINE."""
        head = words[0].text
        if head == "LINE":
            return self._set_line(words)
        if self._code or self._labels:
            return "stands only at the beginning of a procedure"
        if words[-1].text not in Type.__members__ or len(words) != (2 if head == "RESULT" else 3):
            return "a type is needed" if head == "RESULT" else "a name and a type are needed"
        kind = Type(words[-1].text)
        if head == "RESULT":
            self._results.append(kind)
            return ""
        name = words[1].text
        if not is_name(words[1]):
            return f"`{shown(name)}` is no name"
        if any(known.name == name for known in self._parameters + self._locals):
            self._report(kinds.NAME_TWICE, place, f"variable `{shown(name)}` is declared twice", "")
        (self._parameters if head == "PARAM" else self._locals).append(Variable(name, kind))
        return ""

    def label(self, word: Token, place: Span) -> None:
        """Take in `name:`."""
        name = word.text[:-1]
        if not is_name(word._replace(text=name)):
            message = f"`{shown(name)}` is no plain name and cannot be a label"
            self._report(kinds.RECORD_MALFORMED, place, message, "")
        elif name in self._labels:
            self._report(kinds.NAME_TWICE, place, f"label `{shown(name)}` is declared twice", "")
        else:
            self._labels[name] = len(self._code)

    def instruction(self, words: tuple[Token, ...], place: Span) -> None:
        """Take in an instruction whose mnemonic is known."""
        opcode = OPCODES[words[0].text]
        operands = read_operands(opcode, words[1:])
        if isinstance(operands, str):
            kind = kinds.LITERAL_MALFORMED if opcode.mnemonic == "PUSH" else kinds.OPERAND_WRONG
            self._report(kind, place, f"`{opcode.mnemonic}`: {operands}", "")
            operands = ()
        self._code.append((opcode.mnemonic, operands, place))
        self._lines.append(self._line)

    def finished(self) -> Procedure:
        """Return the procedure; labels that are jumped to and not there are reported."""
        code = tuple(self._resolved(*step) for step in self._code)
        places = tuple(place for *_, place in self._code)
        parameters, variables = tuple(self._parameters), tuple(self._locals)
        results, lines = tuple(self._results), tuple(self._lines)
        return Procedure(self.name, parameters, variables, results, code, lines, places)

    def _set_line(self, words: tuple[Token, ...]) -> str:
        number = read_int(words[1]) if len(words) == 2 else None
        if number is None or number < 0:
            return "a line number from 0 is needed"
        self._line = number
        return ""

    def _resolved(self, mnemonic: str, operands: tuple[Operand, ...], place: Span) -> Step:
        if OPCODES[mnemonic].operands != (OperandKind.LABEL,) or not operands:
            return Step(mnemonic, operands)
        name = str(operands[0])
        target = self._labels.get(name)
        if target is None:
            message = f"label `{shown(name)}` is not in procedure `{shown(self.name)}`"
            self._report(kinds.NAME_UNDECLARED, place, message, did_you_mean(name, self._labels))
        return Step(mnemonic, (target or 0,))

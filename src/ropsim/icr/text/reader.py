"""ICR text -> program. No text makes the reader raise; every wrong line gets its own diagnostic."""

from ropsim.core import Diagnostic, Kind, SourceText, Span, near
from ropsim.icr import diagnostics as kinds
from ropsim.icr.errors import AssemblyError
from ropsim.icr.opcodes import OPCODES
from ropsim.icr.program import VERSION, Procedure, Program
from ropsim.icr.text.body import Body
from ropsim.icr.text.declarations import Declarations
from ropsim.icr.text.tokens import Token, cut, is_name, shown

MAX_DIAGNOSTICS = 200
MAX_LINE = 1_000_000
_FORMS = {
    "ICR": "ICR 1.0 name",
    "SOURCE": 'SOURCE "name of the source text"',
    "TASKTEXT": 'TASKTEXT procedure "name of its text" "version of its content"',
    "REQUIRE": "REQUIRE AXES 6 or REQUIRE CAP LIN PTP",
    "VAR": "VAR name TYPE",
    "IO": "IO DI|DO|AI|AO name TYPE",
    "FRAMEDEF": "FRAMEDEF name x y z qw qx qy qz",
    "TOOLDEF": "TOOLDEF name x y z qw qx qy qz, or TOOLDEF name where only the cell knows the pose",
    "LIST": "LIST name",
    "ROW": "ROW x y z qw qx qy qz, below LIST name",
    "PROC": "PROC name",
    "PARAM": "PARAM name TYPE, before the first instruction of a PROC",
    "LOCAL": "LOCAL name TYPE, before the first instruction of a PROC",
    "RESULT": "RESULT TYPE, before the first instruction of a PROC",
    "LINE": "LINE n, inside a PROC",
    "END": "END, after a PROC",
}
_IN_BODY = {"PARAM", "LOCAL", "RESULT", "LINE", "END"}


def read_text(text: str, name: str = "<icr>") -> tuple[Program | None, tuple[Diagnostic, ...]]:
    """Return the program and the diagnostics of a text; the program is None where there are any.

    Args:
        text: any text.
        name: name in diagnostics.
    """
    reader = _Reader(SourceText(name, text))
    program = reader.read()
    return (None if reader.found else program), tuple(reader.found)


def assemble(text: str, name: str = "<icr>") -> Program:
    """Return the program of an ICR text; `verify` checks whether it may run.

    Raises:
        AssemblyError: the text is no ICR program; carries all diagnostics.
    """
    program, found = read_text(text, name)
    if program is None:
        raise AssemblyError(found)
    return program


class _Reader:
    def __init__(self, source: SourceText) -> None:
        self.source = source
        self.found: list[Diagnostic] = []
        self.head = Declarations()
        self.procedures: dict[str, Procedure] = {}
        self.body: Body | None = None
        self.number = 0

    def read(self) -> Program:
        """Read all lines; stop where nearly everything is wrong."""
        for number, line in enumerate(self.source.lines, start=1):
            self.number = number
            words = cut(line) if len(line) <= MAX_LINE else ()
            if len(line) > MAX_LINE:
                message = f"the line has {len(line)} characters, allowed are {MAX_LINE}"
                self._fault(kinds.RECORD_MALFORMED, self.source.span(number), message)
            elif isinstance(words, int):
                message = "text in quotes is not closed, or has an unknown escape"
                self._fault(kinds.LITERAL_MALFORMED, self.source.span(number, words), message)
            elif words:
                self._record(words)
            if len(self.found) >= MAX_DIAGNOSTICS:
                message = f"reading stopped after {MAX_DIAGNOSTICS} faults"
                self._fault(kinds.TOO_MANY_FAULTS, self.source.span(number), message)
                return self.head.program(tuple(self.procedures.values()))
        self._finish()
        return self.head.program(tuple(self.procedures.values()))

    def _finish(self) -> None:
        if self.body is not None:
            message = f"`PROC {shown(self.body.name)}` is not closed"
            self._fault(kinds.RECORD_MALFORMED, self.source.span(max(self.number, 1)), message, "add `END`")
        if "ICR" not in self.head.declared_at:
            hint = f"begin with `{_FORMS['ICR']}`"
            self._fault(kinds.HEADER_WRONG, self.source.span(1), "the text has no header", hint)

    def _record(self, words: tuple[Token, ...]) -> None:
        head, place = words[0], self._span(words[0])
        is_label = head.text.endswith(":") and len(words) == 1
        if head.is_quoted:
            self._fault(kinds.RECORD_MALFORMED, place, "a line cannot begin with a text in quotes")
        elif head.text in _FORMS:
            problem = self._declaration(words)
            if problem:
                self._fault(
                    kinds.RECORD_MALFORMED, place, f"`{head.text}`: {problem}", f"write `{_FORMS[head.text]}`"
                )
        elif head.text not in OPCODES and not is_label:
            close = near(head.text, [*OPCODES, *_FORMS])
            hint = "near: " + ", ".join(f"`{name}`" for name in close) if close else "see the instruction set"
            message = f"unknown instruction `{shown(head.text)}`"
            self._fault(kinds.OPCODE_UNKNOWN, place, message, hint)
        elif self.body is None:
            message = f"`{shown(head.text)}` stands outside a procedure"
            self._fault(kinds.RECORD_MALFORMED, place, message, "put it between `PROC name` and `END`")
        elif is_label:
            self.body.label(head, place)
        else:
            self.body.instruction(words, place.to(self._span(words[-1])))

    def _declaration(self, words: tuple[Token, ...]) -> str:
        """Take in a record that is no instruction; return the fault in its form."""
        head = words[0].text
        if head in _IN_BODY:
            return "stands outside a procedure" if self.body is None else self._body_record(self.body, words)
        if self.body is not None:
            return f"stands inside `PROC {shown(self.body.name)}`; is `END` missing?"
        if head == "ICR":
            return self._icr(words)
        if head == "PROC":
            return self._proc(words)
        problem, twice = self.head.read(words, self._span(words[0]))
        if twice:
            self._fault(kinds.NAME_TWICE, self._span(words[0]), f"{shown(twice)} is declared twice")
        return problem

    def _body_record(self, body: Body, words: tuple[Token, ...]) -> str:
        if words[0].text != "END":
            return body.declare(words, self._span(words[0]))
        self.procedures.setdefault(body.name, body.finished())
        self.body = None
        return "nothing may follow" if len(words) > 1 else ""

    def _icr(self, words: tuple[Token, ...]) -> str:
        if len(words) != 3 or "ICR" in self.head.declared_at:
            return "stands once, with version and name"
        self.head.declared_at["ICR"] = self._span(words[0])
        if words[1].text != VERSION:
            message = f"version `{shown(words[1].text)}` found, `{VERSION}` allowed"
            self._fault(kinds.HEADER_WRONG, self._span(words[1]), message)
        if not (is_name(words[2]) or words[2].is_quoted):
            return f"`{shown(words[2].text)}` is no name; put it in quotes"
        self.head.name = words[2].text
        return ""

    def _proc(self, words: tuple[Token, ...]) -> str:
        if len(words) != 2 or not is_name(words[1]):
            return "one name is needed"
        name = words[1].text
        if name in self.procedures:
            self._fault(
                kinds.NAME_TWICE, self._span(words[1]), f"procedure `{shown(name)}` is declared twice"
            )
        self.head.declared_at.setdefault(f"PROC {name}", self._span(words[0]))
        self.body = Body(name, self._fault)
        return ""

    def _span(self, token: Token) -> Span:
        return self.source.span(self.number, token.column, token.length)

    def _fault(self, kind: Kind, place: Span, message: str, hint: str = "") -> None:
        self.found.append(kind.at(place, message, hint=hint))

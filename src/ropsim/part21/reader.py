"""Read an exchange file of ISO 10303-21, second edition, with one data section."""

from collections.abc import Iterator

from ropsim.core import Diagnostic, Places, SourceText, places_of
from ropsim.part21.diagnostics import NO_INSTANCE, NOT_READ, NUMBER_TWICE, SYNTAX
from ropsim.part21.exchange_file import ExchangeFile, Instance, Record, references
from ropsim.part21.record_reader import read_record
from ropsim.part21.scanner import Scanner, SyntaxProblemError, TokenKind

MAX_CHARACTERS = 4_000_000
MAX_INSTANCES = 100_000
MAX_FINDINGS = 20
"""Maximum number of mistakes of one text that are reported; more of them have a common cause."""
_HEADER = ("FILE_DESCRIPTION", "FILE_NAME", "FILE_SCHEMA")
_OTHER_SECTIONS = frozenset(("ANCHOR", "REFERENCE", "SIGNATURE", "DATA"))


def read_exchange(source: SourceText) -> tuple[ExchangeFile, tuple[Diagnostic, ...]]:
    """Return the content of an exchange file, and all its mistakes.

    A damaged instance is left out and reading goes on behind it.

    Args:
        source: the text; time and memory are linear in its length.
    """
    if len(source.text) > MAX_CHARACTERS:
        message = f"the text has {len(source.text):,} characters, allowed are {MAX_CHARACTERS:,}"
        return ExchangeFile((), ()), (NOT_READ.at(source.span(1), message),)
    return _Reading(places_of(source)).done()


class _Reading:
    """One text while it is read."""

    def __init__(self, places: Places) -> None:
        self._places = places
        self._scanner = Scanner(places)
        self._header: list[Record] = []
        self._instances: dict[int, Instance] = {}
        self._findings: list[Diagnostic] = []

    def done(self) -> tuple[ExchangeFile, tuple[Diagnostic, ...]]:
        try:
            self._read_sections()
        except SyntaxProblemError as problem:
            self._findings.append(problem.finding)
        made = ExchangeFile(tuple(self._header), tuple(self._instances.values()), self._places)
        if not self._findings:
            self._findings += _dangling(made)
        return made, tuple(self._findings)

    def _read_sections(self) -> None:
        self._take_word("ISO-10303-21")
        self._take_word("HEADER")
        while not self._is_word("ENDSEC"):
            self._header.append(read_record(self._scanner, self._places))
            self._scanner.take_sign(";")
        self._check_header()
        self._take_word("ENDSEC")
        self._take_word("DATA")
        while not self._is_word("ENDSEC"):
            self._read_statement()
        self._take_word("ENDSEC")
        if self._scanner.token.text.upper() in _OTHER_SECTIONS:
            place = self._places.span(self._scanner.token.offset, len(self._scanner.token.text))
            found = self._scanner.token.text.upper()
            message = f"found a section `{found}`, allowed is one header and one data section"
            self._findings.append(NOT_READ.at(place, message, hint="write the file as one data section"))
            return
        self._take_word("END-ISO-10303-21")
        if self._scanner.token.kind is not TokenKind.END:
            raise self._scanner.problem("nothing behind `END-ISO-10303-21;`")

    def _check_header(self) -> None:
        found = tuple(record.keyword for record in self._header[:3])
        if found != _HEADER:
            listed = ", ".join(found) or "nothing"
            self._findings.append(
                SYNTAX.at(
                    self._places.span(self._scanner.token.offset),
                    f"the header has {listed}, allowed are {', '.join(_HEADER)} in this order",
                )
            )

    def _read_statement(self) -> None:
        """Read one instance; behind a mistake go on with the next one."""
        if len(self._instances) >= MAX_INSTANCES:
            message = f"the file has more than {MAX_INSTANCES:,} instances, allowed are as many"
            place = self._places.span(self._scanner.token.offset)
            raise SyntaxProblemError(NOT_READ.at(place, message))
        try:
            self._read_instance()
        except SyntaxProblemError as problem:
            if len(self._findings) + 1 >= MAX_FINDINGS or self._scanner.token.kind is TokenKind.END:
                raise
            self._findings.append(problem.finding)
            self._scanner.skip_statement()

    def _read_instance(self) -> None:
        scanner = self._scanner
        start = scanner.token
        if start.kind is not TokenKind.REFERENCE or len(start.text) > 19:
            raise scanner.problem("an instance such as `#1=…` or `ENDSEC`")
        scanner.take()
        scanner.take_sign("=")
        if scanner.is_sign("("):
            scanner.take()
            records = [read_record(scanner, self._places)]
            while not scanner.is_sign(")"):
                records.append(read_record(scanner, self._places))
            scanner.take()
        else:
            records = [read_record(scanner, self._places)]
        scanner.take_sign(";")
        number = int(start.text[1:])
        if number in self._instances:
            if len(self._findings) < MAX_FINDINGS:
                place = self._places.span(start.offset, len(start.text))
                self._findings.append(NUMBER_TWICE.at(place, f"#{number} is given twice, allowed is once"))
            return
        self._instances[number] = Instance(number, tuple(records), start.offset)

    def _is_word(self, word: str) -> bool:
        token = self._scanner.token
        return token.kind is TokenKind.KEYWORD and token.text.upper() == word

    def _take_word(self, word: str) -> None:
        if not self._is_word(word):
            raise self._scanner.problem(f"`{word};`")
        self._scanner.take()
        self._scanner.take_sign(";")


def _dangling(file: ExchangeFile) -> list[Diagnostic]:
    """Return a finding for each reference to nothing, up to `MAX_FINDINGS`."""
    known = {instance.number for instance in file.instances}
    found: list[Diagnostic] = []
    for instance, record, parameter, number in _all_references(file):
        if number not in known and len(found) < MAX_FINDINGS:
            place = file.span(instance, record, parameter)
            found.append(NO_INSTANCE.at(place, f"#{instance.number} refers to #{number}, which there is not"))
    return found


def _all_references(file: ExchangeFile) -> Iterator[tuple[Instance, int, int, int]]:
    for instance in file.instances:
        for place, record in enumerate(instance.records):
            for parameter, value in enumerate(record.values):
                for number in references((value,)):
                    yield instance, place, parameter, number

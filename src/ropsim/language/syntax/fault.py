"""Fault of one line, before the place of the line is known."""

from ropsim.core import Kind, frozen_dataclass


@frozen_dataclass
class Fault:
    """A finding in offsets of the logical line.

    Attributes:
        kind: of the diagnostic.
        start: first offset of the marked text.
        end: offset after it.
        message: as in the diagnostic.
        hint: the next action.
        fix: replacement of the marked text, empty if unknown.
        before: number of characters before the marked text that the fix also replaces.
    """

    kind: Kind
    start: int
    end: int
    message: str
    hint: str = ""
    fix: str = ""
    before: int = 0


class LineFaultError(Exception):
    """Carries a fault out of the depths of the parser to `parse_line`, which never lets it go further."""

    def __init__(self, fault: Fault) -> None:
        super().__init__(fault.message)
        self.fault = fault

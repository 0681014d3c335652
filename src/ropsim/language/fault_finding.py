"""The finding of what is wrong with a line by itself."""

from ropsim.core import Diagnostic, TextEdit
from ropsim.language.syntax.fault import Fault
from ropsim.language.text import Line


def finding_of(line: Line, fault: Fault, source: str) -> Diagnostic:
    """Return the finding of a fault.

    Args:
        line: that has it.
        fault: what is wrong with it.
        source: name of the text.
    """
    span = line.logical.span(source, fault.start, fault.end)
    place = line.logical.span(source, fault.start - fault.before, fault.end)
    edit = TextEdit(place, fault.fix) if fault.fix else None
    return fault.kind.at(span, fault.message, hint=fault.hint, fix=edit)

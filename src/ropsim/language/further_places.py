"""One finding for all places of a mistake that is told once, and again one for each of them."""

from collections.abc import Iterable, Iterator
from dataclasses import replace

from ropsim.core import Diagnostic, Label, Span, TextEdit

MAX_PLACES = 200
"""Further places that one finding knows."""

FIRST_LINE = "first_line"
"""Key of the line of its first place, in the data of a finding at a further one."""

_ALSO = "here, too"


def with_place(first: Diagnostic, place: Span | None) -> Diagnostic:
    """Return a finding that holds at a further place, too; of very many places the first ones are known."""
    if place is None or len(first.secondary) >= MAX_PLACES:
        return first if first.notes else replace(first, notes=("It stands in more places.",))
    return replace(first, secondary=(*first.secondary, Label(place, _ALSO)))


def each_place(findings: Iterable[Diagnostic]) -> Iterator[Diagnostic]:
    """Yield a finding for each place of a mistake, with the change that mends it there."""
    for finding in findings:
        further = [label.span for label in finding.secondary if label.text == _ALSO]
        if not further:
            yield finding
            continue
        others = tuple(label for label in finding.secondary if label.text != _ALSO)
        yield replace(finding, secondary=others)
        where = (Label(finding.span, "here first"),) if finding.span is not None else ()
        data = {**finding.data, FIRST_LINE: finding.span.line if finding.span is not None else 0}
        for span in dict.fromkeys(further):
            fix = TextEdit(span, finding.fix.replacement) if finding.fix is not None else None
            yield replace(finding, span=span, secondary=(*where, *others), fix=fix, data=data)

"""Where statements lie in the text: places in the structured program count lines inside of their unit."""

from collections.abc import Callable, Mapping
from dataclasses import field, replace

from ropsim.core import Diagnostic, Label, Span, TextEdit, frozen_dataclass


@frozen_dataclass
class Places:
    """Where the lines of a unit lie.

    Attributes:
        first: line of the text, from 1, at which the unit begins.
        offsets: how many lines further each line of the unit lies; lines without a statement are left out.
    """

    first: int
    offsets: tuple[int, ...]

    def line(self, number: int) -> int:
        """Return the line of the text where line `number`, from 1, of the unit lies."""
        return self.first + self.offsets[min(number, len(self.offsets)) - 1]


@frozen_dataclass
class SourceMap:
    """Where the units of a text lie: its tasks and its control statements.

    Spans of the structured program name their unit where others name a text. So they, and results that
    contain them, stay unchanged when the unit moves.

    Attributes:
        source: name of the text.
        units: places by the name that spans use.
    """

    source: str
    units: Mapping[str, Places] = field(default_factory=dict)

    def span(self, span: Span) -> Span:
        """Return where a span lies in the text; a span without a unit is unchanged."""
        places = self.units.get(span.source)
        if places is None:
            return span
        line = places.line(span.line)
        end = line if span.end_line == span.line else places.line(span.end_line)
        return Span(self.source, line, span.column, end, span.end_column)

    def line(self, span: Span) -> int:
        """Return the line of the text in which a span begins, 0 for one of another text."""
        places = self.units.get(span.source)
        if places is not None:
            return places.line(span.line)
        return span.line if span.source == self.source else 0

    def lines(self, unit: str, numbers: tuple[int, ...]) -> tuple[int, ...]:
        """Return the lines of the text where lines of a unit lie; 0 stands for no line in both."""
        places = self.units.get(unit)
        if places is None:
            return numbers if unit == self.source else (0,) * len(numbers)
        lying = (0, *map(places.first.__add__, places.offsets))
        return tuple(map(lying.__getitem__, numbers))

    def finding(self, finding: Diagnostic) -> Diagnostic:
        """Return a finding with all its places in the text."""
        return placed(finding, self.span)


def placed(finding: Diagnostic, place: Callable[[Span], Span]) -> Diagnostic:
    """Return a finding with its spans converted by `place`."""
    return replace(
        finding,
        span=place(finding.span) if finding.span is not None else None,
        secondary=tuple(Label(place(one.span), one.text) for one in finding.secondary),
        fix=TextEdit(place(finding.fix.span), finding.fix.replacement) if finding.fix is not None else None,
    )

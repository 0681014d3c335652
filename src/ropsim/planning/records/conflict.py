"""Conflict: a path of the tool that cannot be followed well."""

from ropsim.core import Label, Span
from ropsim.spatial import record


@record
class Conflict:
    """A path that cannot be followed well.

    Attributes:
        number: of its move in the sequence.
        words: description.
        span: of its move in the program.
    """

    number: int
    words: str
    span: Span | None

    @property
    def labels(self) -> tuple[Label, ...]:
        """Return the mark on its move, for findings about other ones."""
        return (Label(self.span, "this path"),) if self.span else ()

"""Where a motion of a line writes its target and the points on its way."""

from ropsim.core import SourceText, Span, frozen_dataclass
from ropsim.language.cache import LineCache
from ropsim.language.syntax.statements import If, Motion
from ropsim.language.uses_of import statements_of


@frozen_dataclass
class MotionPlaces:
    """The places of a motion.

    Attributes:
        line: of its statement, from 1.
        word: its verb, in the form that the language prefers.
        spans: of the points on the way in their order, then of the target.
    """

    line: int
    word: str
    spans: tuple[Span, ...]


def motion_places(source: SourceText, number: int, cache: LineCache) -> MotionPlaces | None:
    """Return the places of the motion on a line (from 1), None where there is none."""
    for line in statements_of(source, cache):
        if line.logical.number <= number < line.logical.number + 1 + line.logical.text.count("\n"):
            statement = line.statement
            while isinstance(statement, If) and statement.body is not None:
                statement = statement.body
            if isinstance(statement, Motion):
                nodes = (*statement.via, statement.target)
                spans = tuple(line.logical.span(source.name, one.start, one.end) for one in nodes)
                return MotionPlaces(line.logical.number, statement.word, spans)
            return None
    return None

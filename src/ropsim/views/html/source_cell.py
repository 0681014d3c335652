"""The cell of a table that shows a line of the program."""

from ropsim.core import SourceText
from ropsim.views.figures import UNKNOWN
from ropsim.views.markup import text

_LONGEST = 200
"""Characters of a line that are written; the page shows as many as there is room for."""


def source_cell(source: SourceText | None, line: int) -> str:
    """Return a line of a program, from 1, as code that is cut where it has no room; 0 for no line."""
    if source is None or not line:
        return UNKNOWN
    shown = text(source.line(line).strip()[:_LONGEST])
    return f'<code class="source" title="{shown}">{shown}</code>'

"""Names that a loop carries through some of its lines from one pass into the next."""

import re
from collections.abc import Iterator

from ropsim.language import Act, Meaning, Use, Uses
from ropsim.lsp.document import Document

_NO_LOOP = re.compile(r"\s*(?:\d+\.\s*)?(?:if|elseif|else|with|task)\b", re.IGNORECASE)
_GIVES_ALWAYS = re.compile(r"\s*(?:\d+\.\s*)?(?:\w+\s*:?=|for\b)", re.IGNORECASE)


def carried(
    document: Document, uses: Uses, first: int, last: int, handed: frozenset[Meaning]
) -> Meaning | None:
    """Return a name whose value lines need from the pass before, None for none.

    Such a name is written in the lines, and they do not begin by giving it a value in every pass.

    Args:
        document: the text.
        uses: of its names.
        first: first of the lines, from 1.
        last: last of them.
        handed: names that a task of the lines would get and give back, so that nothing is lost.
    """
    around = (begun for begun, ended in uses.blocks if begun < first and last <= ended)
    if all(_NO_LOOP.match(document.line(begun - 1)) for begun in around):
        return None
    inside = [use for use in uses.found if first <= use.span.line <= last and not use.meaning.is_global]
    written = dict.fromkeys(use.meaning for use in inside if use.act is not Act.READS)
    for one in written:
        if one in handed or not any(use.act is Act.READS for use in uses.of(one)):
            continue
        own = [use for use in inside if use.meaning == one]
        if not _begins_anew(document, uses, first, own):
            return one
    return None


def _begins_anew(document: Document, uses: Uses, first: int, own: list[Use]) -> bool:
    """Return whether the first use of a name gives it a value, in every pass and from nothing of its own."""
    line = own[0].span.line
    is_inner = any(first <= begun < line <= ended for begun, ended in uses.blocks)
    is_given = own[0].act is not Act.READS and _GIVES_ALWAYS.match(document.line(line - 1)) is not None
    statement = frozenset(_statement(document, line))
    return is_given and not is_inner and not any(use.span.line in statement for use in own[1:])


def _statement(document: Document, line: int) -> Iterator[int]:
    """Yield the lines (from 1) into which the statement that begins on a line may go on."""
    depth = 0
    for number in range(line, len(document.starts) + 1):
        yield number
        text = document.line(number - 1)
        depth += sum(sign in "([" for sign in text) - sum(sign in ")]" for sign in text)
        if depth <= 0 and not text.rstrip().endswith("\\"):
            return

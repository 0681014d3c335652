"""Kinds of single lines, for cutting a text."""

import re
from collections.abc import Sequence
from functools import lru_cache
from zlib import crc32

from ropsim.language.syntax.lines import bracket_depth
from ropsim.language.syntax.words import END, HEADS, OPENERS

ONE_OF = 20
"""A piece ends on average once in this number of lines."""

BEGINS, MARKED, OPENS, CLOSES, RUNS_ON, STATES, DIVIDES, TASK = 1, 2, 4, 8, 16, 32, 64, 128
"""Bits of one number, since there are many lines: it never goes on with the statement of the line before it,
unless that ends with a backslash; a piece ends before it, if one may; it opens a block; it closes one; the
next lines may go on with its statement, or be prose of its contract; it divides a block, as `else` does; a
task begins with it."""

_HEAD = re.compile(r"\s*(?:\d+\.\s+)?([A-Za-z_]\w*)", re.ASCII)
_COMMENT = re.compile(r"#|//")
_ONE_LINE_IF = re.compile(r"\bthen\s+\S", re.IGNORECASE)
_CLOSERS = frozenset(word for words in OPENERS.values() for word in words) | {END}
_CONTRACTS = ("needs", "assumes")
_DIVIDERS = ("else", "elseif", "catch")


@lru_cache(maxsize=65_536)
def kind_of(line: str) -> int:
    """Return the kind of a line, as bits."""
    word = head_of(line)
    kind = MARKED if word and is_marked(_COMMENT.split(line)[0]) else 0
    if word in HEADS or word == END:
        kind |= BEGINS
    if word == "task":
        kind |= TASK
    if word in _CONTRACTS:
        kind |= STATES
    if word in _DIVIDERS:
        kind |= DIVIDES
    if word in _CLOSERS:
        kind |= CLOSES
    elif word in OPENERS and not (word == "if" and _ONE_LINE_IF.search(_COMMENT.split(line)[0])):
        kind |= OPENS
    if line.endswith("\\") or (("(" in line or "[" in line) and bracket_depth(line) > 0):
        kind |= RUNS_ON
    return kind


def kinds_of(lines: Sequence[str]) -> bytes:
    """Return the kind of each line."""
    return bytes(map(kind_of, lines))


def those_with(bits: int) -> re.Pattern[bytes]:
    """Return a pattern that finds the lines with one of these bits in their kinds."""
    kinds = bytes(kind for kind in range(256) if kind & bits)
    return re.compile(b"[" + re.escape(kinds) + b"]")


@lru_cache(maxsize=65_536)
def head_of(line: str) -> str:
    """Return the first word of a line, lower case, empty for none."""
    head = _HEAD.match(line)
    return head[1].lower() if head else ""


def indent_of(line: str) -> int:
    """Return how many characters stand before the first one that is no blank."""
    return len(line) - len(line.lstrip())


def is_marked(text: str) -> bool:
    """Return whether pieces end at a text (one of many); its formatted text behaves the same."""
    return crc32("".join(text.split()).lower().encode(errors="surrogatepass")) % ONE_OF == 0

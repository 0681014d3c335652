"""Words of which one must follow at a place of a statement, independent of the names in scope."""

import re
from collections.abc import Iterator

from ropsim.core import frozen_dataclass
from ropsim.lsp.completion import words
from ropsim.lsp.completion.items import KEYWORD, item
from ropsim.lsp.protocol.messages import Json


@frozen_dataclass
class _Next:
    """Words that follow at the end of a line.

    Attributes:
        line: which lines they follow.
        words: the likeliest first.
        form: how it is written.
        meaning: description of the words.
    """

    line: re.Pattern[str]
    words: tuple[str, ...]
    form: str
    meaning: str = ""


_AT = r"\bat\s(?:(?!\bdo\b).)*"
_FROM_END = r"\b(?:after|before)\b"
_COUNTS = r"^\s*pattern\s+\w+\s*=\s*grid\s+\w+(?:\s*x\s+\w+)"
_STEPS = r"^\s*pattern\b.*\bstep\s*\([^()]*\)(?:\s*,\s*\([^()]*\))*"
_SET = ("set OUTPUT on|off|= value", words.STATEMENTS["set"].meaning)
_EACH = ("for each NAME in PATTERN|LIST", words.STATEMENTS["for"].meaning)
_WAY = "the end from which is counted"
_SIDES = _Next(
    re.compile(rf"\bat\s(?:(?!\bdo\b|{_FROM_END}).)*[^\d\s(,=+*/-]\s+$", re.IGNORECASE),
    ("after start", "before end"),
    _WAY,
)
_TABLE = (
    _SIDES,
    *(
        _Next(re.compile(pattern, re.IGNORECASE | re.ASCII), followed, form, meaning)
        for pattern, followed, form, meaning in (
            (rf"{_AT}\bafter\s+$", ("start",), _WAY, ""),
            (rf"{_AT}\bbefore\s+$", ("end",), _WAY, ""),
            (rf"{_AT}\b(?:after\s+start|before\s+end)\s+$", ("do",), words.MOTIONS["at"].form, ""),
            (r"\b(?:start|end)\s+do\s+$", ("set",), *_SET),
            (r"^\s*for\s+each\s+\w+\s+$", ("in",), *_EACH),
            (r"^\s*(?:\d+\.\s*)?(?:circ|movc)\s+$", ("via",), words.STATEMENTS["circ"].form, ""),
            (r"^\s*signal\s+\w+\s*=\s*$", ("analog", "input", "output"), words.STATEMENTS["signal"].form, ""),
            (r"^\s*signal\s+\w+\s*=\s*analog\s+$", ("input", "output"), words.STATEMENTS["signal"].form, ""),
            (r"^\s*pattern\s+\w+\s*=\s*$", ("grid",), words.STATEMENTS["pattern"].form, ""),
            (rf"{_COUNTS}{{0,1}}\s+$", ("x", "from"), words.STATEMENTS["pattern"].form, ""),
            (rf"{_COUNTS}{{2}}\s+$", ("from",), words.STATEMENTS["pattern"].form, ""),
            (rf"{_STEPS}\s*$", ("order",), "order row|column|snake", "In which order the places are taken."),
            (r"^\s*pattern\b.*\border\s+$", ("row", "column", "snake"), "order row|column|snake", ""),
            (r"\bis\s+$", ("on", "off", "true", "false", "not"), words.INNER["is"].form, ""),
            (r"\bis\s+not\s+$", ("on", "off", "true", "false"), words.INNER["is"].form, ""),
        )
    ),
)  # fmt: skip


def next_words(prefix: str) -> list[Json]:
    """Return the words of which one has to follow at the end of a statement; empty where others may."""
    found = next((one for one in _TABLE if one.line.search(prefix)), None)
    return list(_items(found)) if found is not None else []


def sides() -> Iterator[Json]:
    """Yield the ends of a motion from which a way or time is counted."""
    yield from _items(_SIDES)


def _items(one: _Next) -> Iterator[Json]:
    for at, word in enumerate(one.words):
        yield item(word, KEYWORD, one.form, one.meaning, f"1{at}")

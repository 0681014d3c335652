"""Which names are words of texts that are being edited: counted, so that an edit costs its lines only."""

import re
from collections import Counter
from dataclasses import dataclass

from ropsim.core import edited_lines

FEW = 64
"""Up to this number of names are searched one by one in a text."""
MOST = 32
"""Number of texts whose counts are kept, the last requested ones."""

_WORD = re.compile(r"[^\W\d]\w*")


@dataclass(slots=True)
class _Counted:
    """A text, and how often each name is a word of it."""

    text: str
    counts: dict[str, int]


class Mentions:
    """Remembers texts by their names; it saves time and changes no answer."""

    def __init__(self) -> None:
        self._known: dict[str, _Counted] = {}

    def mentioned(self, source: str, text: str, names: tuple[str, ...]) -> tuple[str, ...]:
        """Return which names are words of a text, in their order.

        Args:
            source: name of the text.
            text: its characters.
            names: words to search.
        """
        known = self._known.pop(source, None)
        if known is None or (*known.counts,) != (*dict.fromkeys(names),):
            counts = _counts(text, names)
        else:
            edit = edited_lines(known.text, text)
            gone = _counts(known.text[edit.begin : edit.end_before], names)
            new = _counts(text[edit.begin : edit.end], names)
            counts = {name: count - gone[name] + new[name] for name, count in known.counts.items()}
        self._known[source] = _Counted(text, counts)
        if len(self._known) > MOST:
            del self._known[next(iter(self._known))]
        return tuple(one for one in names if counts[one])


def _counts(text: str, names: tuple[str, ...]) -> dict[str, int]:
    if len(names) > FEW:
        words = Counter(_WORD.findall(text))
        return {one: words[one] for one in names}
    return {one: len(re.findall(rf"\b{one}\b", text)) if one in text else 0 for one in names}

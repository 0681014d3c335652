"""Characters as a terminal shows them: widths, tabs, and invisible ones made visible."""

import unicodedata

TAB_WIDTH = 4

_INVISIBLE = {"Cc", "Cf", "Cs", "Co", "Cn", "Zl", "Zp"}


def visible(character: str, column: int) -> str:
    """Return the text to show for one character at display column `column` (from 0).

    Tabs become spaces up to the next tab stop, control characters their Unicode picture (U+2400…), and
    other characters without a look of their own (zero width, direction marks, surrogates) their number.
    """
    if character == "\t":
        return " " * (TAB_WIDTH - column % TAB_WIDTH)
    code = ord(character)
    if code < 0x20:
        return chr(0x2400 + code)
    if code == 0x7F:
        return "\u2421"
    if unicodedata.category(character) in _INVISIBLE or character == "\ufffd":
        return f"<U+{code:04X}>"
    return character


def width(text: str) -> int:
    """Return how many terminal columns a text of visible characters takes."""
    return sum(_character_width(character) for character in text)


def clean(text: str) -> str:
    """Return a text on one line with everything invisible made visible; tabs become one space."""
    return "".join(" " if c == "\t" else visible(c, 0) for c in text)


def fit(text: str, columns: int) -> str:
    """Return the text cut to at most `columns` terminal columns, with an ellipsis where it was cut."""
    if width(text) <= columns:
        return text
    kept, used = [], 0
    for character in text:
        used += _character_width(character)
        if used > columns - 1:
            break
        kept.append(character)
    return "".join(kept) + "…"


def _character_width(character: str) -> int:
    if unicodedata.combining(character) or unicodedata.category(character) in {"Mn", "Me"}:
        return 0
    return 2 if unicodedata.east_asian_width(character) in {"W", "F"} else 1

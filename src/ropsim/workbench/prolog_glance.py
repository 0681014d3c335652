"""Layout and quoted names of Prolog as far as a glance at a text needs them, without a reader."""

import re

FARTHEST = 10_000
"""So many characters of comments are looked through in front of a name."""

_BLANKS = re.compile(r"(?:[\s(]|%[^\n]*+)*+")
_ESCAPE = re.compile(
    r"\\(?:x([0-9a-fA-F]+)\\?|([0-7]+)\\?|u([0-9a-fA-F]{4})|U([0-9a-fA-F]{8})|(\r?\n|c\s*)|.)|''", re.DOTALL
)
"""Numbers of characters, what stands for nothing, others; two quotes are one."""
_LAST = 0x10FFFF


def behind_layout(text: str, begin: int) -> int:
    """Return the place behind blanks, comments and opening parentheses that stand at a place of a text."""
    place, end = begin, begin + FARTHEST
    while True:
        blanks = _BLANKS.match(text, place, end)
        place = blanks.end() if blanks is not None else place
        close = text.find("*/", place + 2, end) if text.startswith("/*", place) else -1
        if close < 0:
            return place
        place = close + 2


def unquoted(inside: str) -> str:
    """Return the name that stands between single quotes; an escape for a sign stays, it is in no name."""
    return _ESCAPE.sub(_meant, inside)


def _meant(escape: re.Match[str]) -> str:
    hexadecimal, octal, short, long, nothing = escape.groups()
    digits = hexadecimal or short or long
    if nothing is not None:
        return ""
    if not digits and not octal:
        return escape[0]
    code = int(digits, 16) if digits else int(octal, 8)
    return chr(code) if code <= _LAST else escape[0]

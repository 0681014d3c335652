r"""Strings of ISO 10303-21: characters beyond the basic ones are written by directives.

`\X2\03B1\X0\` holds characters of four hexadecimal digits each, `\X4\` of eight, `\X\E9` one of ISO 8859-1,
`\S\i` the one 128 places above `i` in the part of ISO 8859 that `\PA\` to `\PI\` choose; a backslash and an
apostrophe stand twice.
"""

from re import Match
from re import compile as pattern

_DIRECTIVE = pattern(
    r"''|\\\\|\\X2\\(?P<two>(?:[0-9A-F]{4})*)\\X0\\|\\X4\\(?P<four>(?:[0-9A-F]{8})*)\\X0\\|\\X\\(?P<one>[0-9A-F]{2})"
    r"|\\S\\(?P<high>[ -~])|\\P(?P<page>[A-I])\\|\\[NT]\\|(?P<wrong>['\\])"
)
_BEYOND = pattern(r"[^ -~]+")
_LINE_ENDS = pattern(r"[\r\n]+")


class BadStringError(ValueError):
    """A string has a directive that there is not; the argument is its offset in the string."""


def decoded(text: str) -> str:
    """Return the characters that a string stands for.

    Args:
        text: text between the apostrophes; line ends in it do not count.

    Raises:
        BadStringError: a directive is not in ISO 10303-21, or encodes no character.
    """
    if "\\" not in text and "'" not in text and "\n" not in text and "\r" not in text:
        return text
    page = "A"

    def character(match: Match[str]) -> str:
        nonlocal page
        for name, width in (("two", 4), ("four", 8), ("one", 2)):
            digits = match[name]
            if digits is not None:
                return _characters(digits, width, match.start())
        if match["high"] is not None:
            byte = bytes([ord(match["high"]) + 128])
            return byte.decode(f"iso8859-{'ABCDEFGHI'.index(page) + 1}", "replace")
        if match["wrong"] is not None:
            raise BadStringError(match.start())
        page = match["page"] or page
        return {"''": "'", "\\\\": "\\"}.get(match[0], "")

    return _DIRECTIVE.sub(character, _LINE_ENDS.sub("", text))


def encoded(text: str) -> str:
    """Return a string as encoded between apostrophes, in basic characters only."""
    basic = text.replace("\\", "\\\\").replace("'", "''")
    return _BEYOND.sub(lambda match: _directive(match[0]), basic)


def _characters(digits: str, width: int, offset: int) -> str:
    found = []
    for start in range(0, len(digits), width):
        number = int(digits[start : start + width], 16)
        if number > 0x10FFFF or 0xD800 <= number < 0xE000:
            raise BadStringError(offset)
        found.append(chr(number))
    return "".join(found)


def _directive(text: str) -> str:
    """Return the encoding of characters beyond the basic ones; lone surrogates cannot be encoded."""
    if any(0xD800 <= ord(one) < 0xE000 for one in text):
        raise BadStringError(0)
    if all(ord(one) < 0x10000 for one in text):
        return "\\X2\\" + "".join(f"{ord(one):04X}" for one in text) + "\\X0\\"
    return "\\X4\\" + "".join(f"{ord(one):08X}" for one in text) + "\\X0\\"

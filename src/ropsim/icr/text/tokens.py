"""Words of ICR text: cutting a line, quoting and unquoting."""

import re
from typing import NamedTuple

_TOKEN = re.compile(r'[ \t]*(?:(;.*)|("(?:[^"\\]|\\.)*")(?=[ \t;]|$)|([^ \t;"]+))')
_PLAIN = re.compile(r"[A-Za-z_][A-Za-z0-9_.]*\Z")
_ESCAPE = re.compile(
    r'\\(?:([nt"\\])|u([0-9A-Fa-f]{4})|U(000[0-9A-Fa-f]{5}|0010[0-9A-Fa-f]{4})|(.?))', re.DOTALL
)
_SHORT = {"n": "\n", "t": "\t", '"': '"', "\\": "\\"}
_LONG = {"\n": "\\n", "\t": "\\t", '"': '\\"', "\\": "\\\\"}


class Token(NamedTuple):
    """One word of a line: its text (unquoted), whether it stood in quotes, and the column from 1."""

    text: str
    is_quoted: bool
    column: int
    length: int


def cut(line: str) -> tuple[Token, ...] | int:
    """Return the words of a line without its comment, or the column from which it cannot be read."""
    tokens: list[Token] = []
    at = 0
    end = len(line.rstrip(" \t"))
    while at < end:
        match = _TOKEN.match(line, at, end)
        if match is None:
            return at + 1
        comment, quoted, plain = match.groups()
        if quoted is not None:
            text = unquoted(quoted)
            if text is None:
                return match.start(2) + 1
            tokens.append(Token(text, is_quoted=True, column=match.start(2) + 1, length=len(quoted)))
        elif plain is not None:
            tokens.append(Token(plain, is_quoted=False, column=match.start(3) + 1, length=len(plain)))
        elif comment is not None:
            break
        at = match.end()
    return tuple(tokens)


def unquoted(text: str) -> str | None:
    """Return the text of a word in double quotes, or None where an escape is unknown."""
    wrong: list[str] = []

    def replace(match: re.Match[str]) -> str:
        short, four, eight, other = match.groups()
        if other is not None:
            wrong.append(other)
            return ""
        return _SHORT[short] if short else chr(int(four or eight, 16))

    result = _ESCAPE.sub(replace, text[1:-1])
    return None if wrong else result


def quoted(text: str) -> str:
    """Return `text` in double quotes, in ASCII: other characters as escapes with their number."""
    parts = []
    for character in text:
        code = ord(character)
        if character in _LONG:
            parts.append(_LONG[character])
        elif 32 <= code < 127:
            parts.append(character)
        else:
            parts.append(f"\\u{code:04x}" if code < 0x10000 else f"\\U{code:08x}")
    return '"' + "".join(parts) + '"'


def named(name: str) -> str:
    """Return a name in text form: in quotes where it is not a plain word."""
    return name if _PLAIN.match(name) else quoted(name)


def is_name(token: Token) -> bool:
    """Return whether a word can be a name: quoted and not empty, or a plain word."""
    return bool(token.text) if token.is_quoted else bool(_PLAIN.match(token.text))


def shown(text: str) -> str:
    """Return `text` as messages quote it: at most 40 characters, all of them printable."""
    short = text if len(text) <= 40 else text[:37] + "..."
    return short if short.isprintable() else ascii(short)[1:-1]

"""Plain words in YAML 1.1, the version of the official tool: truth values, whole and decimal numbers, texts.

Numbers have the notations of YAML 1.1 (yaml.org/type, 2005): octal with a leading 0, hexadecimal,
binary, underscores between digits, and base 60 with colons. A decimal number has a point, and its exponent a
sign: `1e3` is a text there.
"""

import re
from collections.abc import Mapping
from types import MappingProxyType

from ropsim.exchange.xacro.formulas.values import Key, bounded

_WORDS: Mapping[str, bool | float | None] = MappingProxyType(
    {word: None for word in ("~", "null", "Null", "NULL", "")}
    | {form: True for word in ("yes", "true", "on") for form in (word, word.capitalize(), word.upper())}
    | {form: False for word in ("no", "false", "off") for form in (word, word.capitalize(), word.upper())}
    | {f"{sign}.{word}": float(f"{sign}inf") for sign in ("", "+", "-") for word in ("inf", "Inf", "INF")}
    | {word: float("nan") for word in (".nan", ".NaN", ".NAN")}
)
_WHOLE = re.compile(
    r"(?P<sign>[-+]?)(?:0b(?P<binary>[01_]+)|0x(?P<hexadecimal>[0-9a-fA-F_]+)|0(?P<octal>[0-7_]+)"
    r"|(?P<decimal>0|[1-9][0-9_]*)|(?P<sixty>[1-9][0-9_]*(?::[0-5]?[0-9])+))",
    re.ASCII,
)
_DECIMAL = re.compile(
    r"[-+]?[0-9][0-9_]*\.[0-9_]*(?:[eE][-+][0-9]+)?|\.[0-9][0-9_]*(?:[eE][-+][0-9]+)?"
    r"|[-+]?[0-9][0-9_]*(?::[0-5]?[0-9])+\.[0-9_]*",
    re.ASCII,
)
_BASES = {"binary": 2, "octal": 8, "decimal": 10, "hexadecimal": 16}
_LONGEST = 300  # digits: longer ones are no numbers of a robot


def plain(text: str) -> Key:
    """Return the value of a word without quotation marks.

    Raises:
        XacroError: it is a number that is too large.
    """
    if text in _WORDS:
        return _WORDS[text]
    if len(text) > _LONGEST:
        return text
    whole = _WHOLE.fullmatch(text)
    if whole is not None and whole.lastgroup is not None:
        digits = whole.group(whole.lastgroup).replace("_", "") or "0"
        size = _of_sixty(digits) if whole.lastgroup == "sixty" else int(digits, _BASES[whole.lastgroup])
        return _number(-size if whole.group("sign") == "-" else size)
    if _DECIMAL.fullmatch(text):
        digits = text.replace("_", "").lstrip("+-")
        return _number(_of_sixty(digits) * (-1.0 if text[0] == "-" else 1.0))
    return text


def _of_sixty(digits: str) -> int | float:
    """Return the number of digits to the base of 60, with colons between them; of one digit, that one."""
    *whole, last = digits.split(":")
    total = 0
    for part in whole:
        total = total * 60 + int(part)
    return total * 60 + (float(last) if "." in last else int(last))


def _number(value: float) -> int | float:
    made = bounded(value)
    assert isinstance(made, int | float)
    return made

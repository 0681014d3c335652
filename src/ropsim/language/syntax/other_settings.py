"""Speeds, accelerations and zones as other languages write them behind a target."""

import re
from collections.abc import Mapping, Sequence

from ropsim.core import frozen_dataclass
from ropsim.language.syntax.lexer import Token, number_parts

_WORDS: Mapping[str, str] = {
    **dict.fromkeys(("vel", "velocity", "feed", "feedrate"), "speed"),
    **dict.fromkeys(("accel", "acceleration"), "acc"),
    **dict.fromkeys(("zone", "radius", "approx", "corner"), "blend"),
}
"""Settings, and their equivalents here."""
_EXAMPLES: Mapping[str, str] = {
    "speed": "write `speed 500 mm/s`",
    "acc": "write `acc 2 m/s2`",
    "blend": "a zone is a distance from the target: write `blend 10 mm`",
}
_SHARES: Mapping[str, str] = {"speed": "write `speed 50 %`", "acc": "write `acc 50 %`"}
"""The same behind the target of `mov`."""
_LETTERS: Mapping[str, tuple[str, str]] = {"v": ("speed", "m/s"), "a": ("acc", "m/s2"), "r": ("blend", "m")}
"""Settings that are a letter and `=`, with their units if the number has none."""
_MOST = {"v": 10.0, "a": 100.0, "r": 1.0}
"""Values from which on these units are implausible."""
_ZONES = frozenset(("c_dis", "c_ptp", "c_vel", "c_ori", "c_spl", "a_dis", "a_vel", "a_ori"))
_TERMINATION = re.compile(r"cnt([0-9]*)")
_DATA = re.compile(r"([vz])([0-9]+)")
_OF_DATA: Mapping[str, str] = {"v": "speed {0} mm/s", "z": "blend {0} mm"}
_OF_JOINTS = ("mov", "movj")


@frozen_dataclass
class Meant:
    """Equivalent of some words of another language.

    Attributes:
        hint: the correct form.
        fix: replacement, empty if uncertain.
        count: how many tokens they are.
    """

    hint: str
    fix: str
    count: int


def meant(line: Sequence[Token], at: int) -> Meant | None:
    """Return the meaning of the tokens of a motion from a place on; None if unknown."""
    token, behind, head = line[at], line[at + 1 : at + 3], line[0].word
    if fix := data(token.text):
        return _of_data(head, fix, 1)
    if token.word in _ZONES:
        return Meant(_EXAMPLES["blend"], "", 1)
    if found := _TERMINATION.fullmatch(token.word):
        return _exact("fine", 1) if found[1] == "0" else Meant(_EXAMPLES["blend"], "", 1)
    if token.word in _LETTERS and len(behind) == 2 and behind[0].word in ("=", ":="):
        return _by_letter(head, token, behind[1])
    word = _WORDS.get(token.word)
    if word is None or (behind and behind[0].word in ("=", ":=", ".")):
        return None
    if behind and behind[0].word == "fine":
        return _exact("fine", 2)
    if behind and (fix := data(behind[0].text)):
        return _of_data(head, fix, 2)
    if behind and behind[0].kind in ("number", "word"):
        return _exact(word, 1)
    return Meant(_example(head, word), "", 1)


def data(name: str) -> str:
    """Return the equivalent of speed and zone data such as `v500` and `z10`; empty for other names."""
    found = _DATA.fullmatch(name.lower())
    return _OF_DATA[found[1]].format(found[2]) if found else ""


def shared(head: str, word: str) -> str:
    """Return how a setting is written that is a share in this motion; empty where it is none."""
    return _SHARES.get(word, "") if head in _OF_JOINTS else ""


def of_letter(head: str, letter: str, number: str) -> str:
    """Return the equivalent of settings such as `v=0.25`; empty if uncertain, as for speeds of joints.

    Args:
        head: first word of the motion in this language.
        letter: text before `=`.
        number: text behind it, with or without a unit.
    """
    word, unit = _LETTERS.get(letter, ("", ""))
    digits, own = number_parts(number)
    if not word or shared(head, word) or (not own and float(digits) >= _MOST[letter]):
        return ""
    return f"{word} {number}" if own else f"{word} {number} {unit}"


def called(word: str) -> str:
    """Return the name here of a setting of another language, empty for other words."""
    return _WORDS.get(word, "")


def _of_data(head: str, fix: str, count: int) -> Meant:
    """Return the equivalent of speed and zone data; a tool speed does not apply to the joints of `mov`."""
    share = shared(head, fix.split(maxsplit=1)[0])
    return Meant(share, "", count) if share else _exact(fix, count)


def _by_letter(head: str, letter: Token, value: Token) -> Meant:
    fix = of_letter(head, letter.word, value.text) if value.kind == "number" else ""
    return _exact(fix, 3) if fix else Meant(_example(head, _LETTERS[letter.word][0]), "", 3)


def _example(head: str, word: str) -> str:
    return shared(head, word) or _EXAMPLES[word]


def _exact(text: str, count: int) -> Meant:
    return Meant(f"write `{text}`", text, count)

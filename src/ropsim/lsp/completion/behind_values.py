"""Words that follow a whole value, by the statement around it, and words of a guard."""

import re
from collections.abc import Iterable, Iterator

from ropsim import language
from ropsim.language import Role
from ropsim.lsp.analysis.names import Known
from ropsim.lsp.completion import words
from ropsim.lsp.completion.expected import type_of
from ropsim.lsp.completion.items import KEYWORD, OPERATOR, item, name_item, some_words, word_items
from ropsim.lsp.completion.next_words import sides
from ropsim.lsp.protocol.messages import Json

MOTION = re.compile(r"^\s*(?:\d+\.\s*)?(?:mov[jlc]?|lin|circ|spline)\b", re.IGNORECASE)
"""The verb of a motion at the beginning of a line."""

_SET_NAME = re.compile(r"(?:^|\bdo)\s*set\s+(\w+)\s+$", re.IGNORECASE | re.ASCII)
_BEHIND_TARGET = re.compile(
    rf"\b(?:{'|'.join((*words.MODIFIERS, *sorted(language.BEHIND_TARGETS), 'until'))})\b", re.IGNORECASE
)
_WORD = re.compile(r"\w+", re.ASCII)
_QUIET = re.compile(r"^\s*(?:set|with|wait|repeat|open|close|store|for\s+each)\b", re.IGNORECASE)
_ONLY_WITH = {
    "angle": re.compile(r"\b(?:circ|movc)\b", re.IGNORECASE),
    "along": re.compile(r"\btrack\b", re.IGNORECASE),
    "gain": re.compile(r"\btrack\b", re.IGNORECASE),
    "timeout": re.compile(r"\buntil\b(?!.*\btimeout\b)", re.IGNORECASE),
}
"""The line must contain this expression for a word behind its target."""
_STATES = ("on", "off")
_PLACED = ("above", "offset", "rel", "in")
_LOGIC = ("and", "or", "is", "mod")

_HEADS = tuple(
    (re.compile(rf"^\s*(?:{pattern})\b", re.IGNORECASE), wanted)
    for pattern, wanted in (
        ("if|elseif", (*_LOGIC, "then")),
        ("while", (*_LOGIC, "do")),
        ("until", _LOGIC),
        (r"for\b.*\bstep", ("do", "mod")),
        (r"for\b.*\bto", ("step", "do", "mod")),
        ("for", ("to", "mod")),
    )
)
_AT = re.compile(r"\bat\s+[^A-Za-z]*$", re.IGNORECASE)
_UNENDED = re.compile(r"^\s*(?:\d+\.\s*)?(?:(?:mov[jl]?|lin)\s+via\b|.*\buntil\b)", re.IGNORECASE)
"""Motions that no condition can end, or no other one."""
_GUARD = re.compile(r"\buntil\s+(.*)$", re.IGNORECASE)
_BARE = re.compile(r"(?:not\s+)?\w+\s+$", re.IGNORECASE)
_NUMBERS = re.compile(r"[^<>=]+[<>][^>=]", re.IGNORECASE)
_GRID = re.compile(r"^\s*pattern\b.*\bfrom\b(?!.*\bstep\b)", re.IGNORECASE)


def behind_value(line: str) -> Iterator[Json]:
    """Yield the words that may follow a value at the end of an incomplete statement."""
    if line.count("(") > line.count(")"):
        is_call = not MOTION.match(line)
        yield from some_words(words.INNER, (*(_PLACED if is_call else ()), "mod"), "3")
    elif (named := _SET_NAME.search(line)) is not None and named[1].lower() not in words.MODIFIERS:
        yield from (item(state, KEYWORD, f"set OUTPUT {state}", "") for state in _STATES)
    elif MOTION.match(line):
        yield from _in_motion(line)
    elif _is_last(line, ("until",), "timeout") and not line.lstrip().lower().startswith("until"):
        yield from some_words(words.INNER, _LOGIC, "1")
        yield from some_words(words.MOTIONS, ("timeout",), "1")
    elif not _QUIET.match(line):
        yield from _in_expression(line)


def _is_last(line: str, wanted: tuple[str, ...], other: str) -> bool:
    """Return whether one of some words stands in a line, with no other word behind it."""
    found = (word.lower() for word in reversed(_WORD.findall(line)))
    return next((word for word in found if word in wanted or word == other), other) != other


def _in_motion(line: str) -> Iterator[Json]:
    if _AT.search(line):
        yield from sides()
        return
    guard = _GUARD.search(line)
    if guard is not None and not _BEHIND_TARGET.search(guard[1]):
        yield from _in_guard(guard[1])
        return
    if _is_last(line, ("via", "spline"), "to"):
        yield from some_words(words.INNER, ("to",), "1")
    else:
        yield from _settings("1")
        own = (name for name in words.MOTIONS if name in language.BEHIND_TARGETS)
        fit = (name for name in own if name not in _ONLY_WITH or _ONLY_WITH[name].search(line))
        yield from some_words(words.MOTIONS, fit, "2")
        if not _UNENDED.match(line):
            yield item("until", KEYWORD, "until SIGNAL", "Ends the motion when the condition holds.", "2")
    if not _BEHIND_TARGET.search(line):
        yield from some_words(words.INNER, _PLACED, "3")
        yield from word_items(words.LOCATIONS, KEYWORD, "3")


def _in_guard(condition: str) -> Iterator[Json]:
    """Yield the words that follow a condition that ends a motion, or continue the condition."""
    more = ("is",) if _BARE.match(condition) else ("mod",) if _NUMBERS.match(condition) else ()
    yield from some_words(words.INNER, more, "1")
    yield from some_words(words.MOTIONS, ("timeout", "store"), "2")
    yield from _settings("3")
    yield from some_words(words.MOTIONS, ("at", "track"), "3")


def _settings(group: str) -> Iterator[Json]:
    """Yield settings that hold for one motion; a frame does not."""
    yield from some_words(words.MODIFIERS, (name for name in words.MODIFIERS if name != "frame"), group)


def _in_expression(line: str) -> Iterator[Json]:
    of_head = next((wanted for pattern, wanted in _HEADS if pattern.match(line)), None)
    if of_head is not None:
        yield from some_words(words.INNER, (word for word in of_head if word in words.INNER), "1")
        if "step" in of_head:
            yield item("step", KEYWORD, words.STATEMENTS["for"].form, "Counts by another number than 1.", "1")
        return
    if _GRID.match(line):
        yield item("step", KEYWORD, words.STATEMENTS["pattern"].form, "One vector for each count.", "0")
    yield from some_words(words.INNER, _PLACED, "1")
    yield from word_items(words.LOCATIONS, KEYWORD, "1")
    if not re.match(r"\s*(?:loc|frame|tool|pattern)\b", line, re.IGNORECASE):
        yield from some_words(words.INNER, _LOGIC, "2")


_UNTIL = re.compile(r"\buntil\s+(not\s+)?$", re.IGNORECASE)
_SIGNAL = re.compile(r"\buntil\s+(?:not\s+)?([A-Za-z_]\w*)\s+$", re.IGNORECASE | re.ASCII)
_NOT = tuple(some_words(words.INNER, ("not",), "1"))
_ORDER = {">": "until SIGNAL > value", "<": "until SIGNAL < value"}


def guard_completions(prefix: str, known: Iterable[Known]) -> list[Json] | None:
    """Return the signals that a motion can monitor, or the operators of an analog signal; else None.

    Args:
        prefix: the statement up to the word that is being typed.
        known: all names.
    """
    if MOTION.match(prefix) is None:
        return None
    signals = [one for one in known if one.role is Role.SIGNAL]
    until = _UNTIL.search(prefix)
    if until is not None:
        digital = [name_item(one, "0") for one in signals if type_of(one) == "bool"]
        return digital if until[1] is not None else [*digital, *_analog(signals), *_NOT]
    named = _SIGNAL.search(prefix)
    if named is not None and any(one.name == named[1] and type_of(one) == "num" for one in signals):
        return [item(sign, OPERATOR, form, "", "1") for sign, form in _ORDER.items()]
    return None


def _analog(signals: Iterable[Known]) -> Iterator[Json]:
    """Yield analog signals, which `not` does not negate."""
    yield from (name_item(one, "0") for one in signals if type_of(one) == "num")

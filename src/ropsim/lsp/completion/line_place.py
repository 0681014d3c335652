"""Completions at the end of an incomplete line."""

import re
from collections.abc import Mapping
from enum import Enum

from ropsim.language import TaskForm
from ropsim.lsp.completion import words
from ropsim.lsp.completion.call_place import call_place


class Place(Enum):
    """Completions at the end of a line."""

    NOTHING = "nothing"
    UNITS = "units of bare numbers"
    TYPE = "type"
    PATTERN = "pattern or list of points"
    LIST = "list of points"
    STATEMENT = "statement"
    OUTPUT = "output"
    INPUT = "input"
    STORE = "variable of a location"
    TASK = "task"
    SETTING = "output or setting"
    MODIFIER = "setting"
    TOOL = "tool"
    FRAME = "frame"
    UNIT = "unit"
    MEMBER = "coordinate"
    POSTURE = "posture"
    TURN = "turn"
    BEHIND_VALUE = "word behind a value"
    VALUE = "value"


_PLACES = tuple(
    (re.compile(pattern, re.IGNORECASE), offer)
    for pattern, offer in (
        (r"^\s*units\b.*$", Place.UNITS),
        (r"^\s*(?:task|const|var)\b.*(?::|->)\s*$", Place.TYPE),
        (r"^\s*(?:program|loc|frame|tool|signal|const|var|pattern|task)\s+$", Place.NOTHING),
        (r"^\s*task\b(?!.*=[^,)]*$)|^\s*signal\b.*\b(?:input|output)\b", Place.NOTHING),
        (r"^\s*pattern\b.*\bstep\s+(?:\([^()]*\)\s*,\s*)*$", Place.NOTHING),
        (r"^\s*pattern\s+\w+\s*=\s*grid(?:\s+\w+\s*x)*\s+$", Place.VALUE),
        (r"^\s*(?:stop|needs|assumes|load)\s+|^\s*(?:var\s+\w+|for\s+\w+)\s+$", Place.NOTHING),
        (r"^\s*var\s+\w+\s*:\s*\w+\s+$|\btrack\s+\w+\s+$", Place.NOTHING),
        (r"^\s*(?:mov[jl]?|lin|spline)\s+along\s+$", Place.LIST),
        (r"\bstore\s+$", Place.STORE),
        (r"\btrack\s+$", Place.INPUT),
        (r"^\s*(?:for\s+each\s+\w+\s+in)\s+$", Place.PATTERN),
        (r"^\s*(?:\d+\.\s*)?$", Place.STATEMENT),
        (r"\bdo\s+set\s+$", Place.OUTPUT),
        (r"^\s*call\s+$", Place.TASK),
        (r"^\s*set\s+$", Place.SETTING),
        (r"^\s*with\s+$|^\s*with\b.*,\s*$", Place.MODIFIER),
        (r"^\s*(?:open|close)\s+$|\btool\s+$", Place.TOOL),
        (r"(?:\bin|@|\bframe)\s*$", Place.FRAME),
        (r"(?<![\w.])\d+(?:\.\d+)?(?:e[+-]?\d+)?\s*$", Place.UNIT),
        (r"[A-Za-z_]\w*\.$", Place.MEMBER),
        (r"\bconfig\s*\([^()]*$", Place.POSTURE),
        (r"\b(?:rx|ry|rz|pitch|roll|yaw|like)\s+$", Place.VALUE),
        (r"\([^()]*;[^()]*$", Place.TURN),
    )
)
_BRANCH = re.compile(r"^.*\b(?:then|else)\s+", re.IGNORECASE)
_ENDS_VALUE = frozenset(("true", "false", "here", "home", "down", "fine"))
_ASKS_VALUE = frozenset(
    word
    for table in (words.STATEMENTS, words.INNER, words.MOTIONS, words.LOCATIONS, words.MODIFIERS, words.TURNS)
    for word in table
    if word not in _ENDS_VALUE
) | {"step", "each", "from"}
_ONE_WORD = re.compile(r"^\s*\w+\s*$", re.ASCII)
_LAST_WORD = re.compile(r"(?:^|[^\w.])([A-Za-z_][\w.]*)\s+$", re.ASCII)
_CLOSED = re.compile(r"(?:[)\]\"]\s*|\d[A-Za-z%/]*\s+|[\d\s](?:[A-Za-z]+/s2?|%)\s+)$", re.ASCII)


def statement_of(line: str) -> str:
    """Return the statement at the end of a line, behind the condition that it may have."""
    return _BRANCH.sub("", line)


def place_of(prefix: str, tasks: Mapping[str, TaskForm]) -> Place:
    """Return the completions at the end of a line.

    Args:
        prefix: the statement up to the word that is being typed.
        tasks: how each task is called.
    """
    found = next((offer for pattern, offer in _PLACES if pattern.search(prefix)), None)
    if found is not None:
        return found
    return Place.BEHIND_VALUE if _ends_value(prefix, tasks) else Place.VALUE


def _ends_value(prefix: str, tasks: Mapping[str, TaskForm]) -> bool:
    """Return whether a line ends with a whole value, behind which no other one can stand."""
    called = call_place(prefix, tasks)
    if called is not None and not called.typed:
        return False
    if _ONE_WORD.match(prefix):
        return False
    if _CLOSED.search(prefix):
        return True
    last = _LAST_WORD.search(prefix)
    return last is not None and last[1].lower() not in _ASKS_VALUE

"""Completion items in the protocol's form: values of the expected type, and components behind a dot."""

import re
from collections.abc import Iterable, Iterator, Mapping

from ropsim.language import PointTable, Role
from ropsim.lsp.analysis.names import Known
from ropsim.lsp.completion import words
from ropsim.lsp.completion.expected import LITERALS, may_give, type_of
from ropsim.lsp.completion.words import Word
from ropsim.lsp.protocol.messages import Json

KINDS = {
    Role.TASK: 3,
    Role.PARAMETER: 6,
    Role.LOCATION: 21,
    Role.FRAME: 22,
    Role.TOOL: 7,
    Role.SIGNAL: 5,
    Role.CONSTANT: 21,
    Role.VARIABLE: 6,
    Role.PATTERN: 13,
    Role.LIST: 13,
}
KEYWORD, FUNCTION, UNIT, TYPE, FIELD, LITERAL, OPERATOR = 14, 3, 11, 25, 5, 12, 24

NO_VALUES = (Role.FRAME, Role.TOOL, Role.PATTERN, Role.LIST)
"""Roles of names of the cell and of the text that denote no value."""


def item(label: str, kind: int, detail: str, documentation: str, group: str = "1") -> Json:
    """Return one completion item; items of a lesser group come first."""
    made: Json = {"label": label, "kind": kind, "detail": detail, "sortText": f"{group}{label.lower()}"}
    if documentation:
        made["documentation"] = {"kind": "plaintext", "value": documentation}
    return made


def word_items(table: Mapping[str, Word], kind: int, group: str) -> Iterator[Json]:
    """Yield words of the language with their meanings."""
    for name, word in table.items():
        yield item(name, kind, word.form, word.meaning, group)


def some_words(table: Mapping[str, Word], wanted: Iterable[str], group: str) -> Iterator[Json]:
    """Yield some words of a table."""
    yield from word_items({name: table[name] for name in wanted}, KEYWORD, group)


def name_item(one: Known, group: str = "1") -> Json:
    """Return a name of the cell or of the text."""
    detail = f"{one.role.value}: {one.text}" if one.origin == "cell" else one.text
    return item(one.name, KINDS[one.role], detail[:120], "", group)


_RUNNING = frozenset((Role.VARIABLE, Role.PARAMETER, Role.SIGNAL))
_PLACES = frozenset(("loc", "target", "joints"))
_MEANT = {("target", "loc"), ("target", "joints"), ("num", "int"), ("count", "int"), ("count", "num")}
_KNOWN_BEFORE = re.compile(r"^\s*(?:loc|frame|tool|const|pattern)\b", re.IGNORECASE)
_VERB = re.compile(r"^\s*(?:\d+\.\s*)?(?:mov[jlc]?|lin|circ|spline)\s+$", re.IGNORECASE)
_LISTED = re.compile(r"^\s*(?:\d+\.\s*)?(?:mov[jl]?|lin|spline)\s+$", re.IGNORECASE)
_JOINTS = words.Word("joints(a1, …)", "Joint coordinates, that of the first axis first.")


def values(prefix: str, known: list[Known], wanted: str) -> Iterator[Json]:
    """Yield the items for a place that expects a value.

    Args:
        prefix: the line up to the word that is being typed.
        known: all names.
        wanted: the expected type, empty if any is allowed.
    """
    unfit = (*NO_VALUES, *_RUNNING) if _KNOWN_BEFORE.match(prefix) else NO_VALUES
    for one in known:
        type_ = type_of(one)
        if one.role in unfit or not may_give(wanted, type_):
            continue
        is_meant = type_ == wanted or (wanted, type_) in _MEANT
        yield name_item(one, "1" if not wanted else "0" if is_meant else "2")
    for place, literal in enumerate(LITERALS.get(wanted, ())):
        yield item(literal, LITERAL, wanted, "", f"1{place}")
    yield from _places(prefix, wanted)
    if _LISTED.match(prefix) and any(one.role is Role.LIST for one in known):
        yield item("along", KEYWORD, words.MOTIONS["along"].form, words.MOTIONS["along"].meaning, "3")
    if wanted not in (*_PLACES, "count"):
        yield from word_items(words.FUNCTIONS, FUNCTION, "4")
    if wanted in ("", "bool"):
        yield from some_words(words.INNER, ("not",), "3")
    if not wanted:
        yield from some_words(words.INNER, ("true", "false"), "3")


def _places(prefix: str, wanted: str) -> Iterator[Json]:
    """Yield places without a name, and the word before via points."""
    is_run = _KNOWN_BEFORE.match(prefix) is None
    if wanted in ("", "loc", "target") and is_run:
        yield from some_words(words.INNER, ("here",), "1" if wanted else "3")
    if wanted == "target" and is_run:
        yield from some_words(words.INNER, ("home",), "1")
    if wanted in ("target", "joints") or (not wanted and prefix.count("(") == prefix.count(")")):
        yield item("joints(", KEYWORD, _JOINTS.form, _JOINTS.meaning, "1" if wanted else "3")
    if _VERB.match(prefix):
        yield item("via", KEYWORD, words.MOTIONS["via"].form, words.MOTIONS["via"].meaning, "3")


_POINT_NAME = re.compile(r'([A-Za-z_]\w*)\["[^"\\]*$', re.ASCII)


def point_names(line: str, lists: Mapping[str, PointTable]) -> Iterator[Json]:
    """Yield the names of points of the list whose index a line ends within, `rack["…`, in their order.

    Args:
        line: up to the word that is being typed.
        lists: those of the project by name.
    """
    if (named := _POINT_NAME.search(line)) and named[1] in lists:
        for name, number in lists[named[1]].names.items():
            yield item(name, LITERAL, f"point {number} of {named[1]}", "", f"0{number:05}")


_OWNER = re.compile(r"([A-Za-z_]\w*)\.$", re.ASCII)
_FOR_EACH = re.compile(r"^\s*for\s+each\b", re.IGNORECASE)
_COORDINATES = ("x", "y", "z", "rx", "ry", "rz")
_INDICES = ("col", "row", "layer")


def members(prefix: str, known: Iterable[Known]) -> Iterator[Json]:
    """Yield the components of the name that a line ends with; of a location if the type is unknown.

    Args:
        prefix: the line up to the word that is being typed, with the dot.
        known: all names.
    """
    named = _OWNER.search(prefix)
    owner = next((one for one in known if named is not None and one.name == named[1]), None)
    if owner is not None and (owner.role in NO_VALUES or type_of(owner) not in ("loc", "")):
        return
    if owner is not None and owner.role is Role.VARIABLE and _FOR_EACH.match(owner.text):
        for at, name in enumerate(_INDICES):
            yield item(name, FIELD, "place in the pattern, from 1", "", f"0{at}")
    for at, name in enumerate(_COORDINATES):
        yield item(name, FIELD, "coordinate", "", f"1{at}")

"""Values that can begin or go on an expression, those of the type that is asked for first."""

import re
from collections.abc import Iterator

from ropsim.language import Role
from ropsim.lsp import words
from ropsim.lsp.expected import LITERALS, may_give, type_of
from ropsim.lsp.items import FUNCTION, KEYWORD, LITERAL, item, name_item, some_words, word_items
from ropsim.lsp.messages import Json
from ropsim.lsp.names import Known

NO_VALUES = (Role.FRAME, Role.TOOL, Role.PATTERN)
"""What names of the cell and of the text stand for no value."""

_PLACES = frozenset(("loc", "target", "joints"))
_KNOWN_BEFORE = re.compile(r"^\s*(?:loc|frame|tool|const|pattern)\b", re.IGNORECASE)
_VERB = re.compile(r"^\s*(?:\d+\.\s*)?(?:mov[jlc]?|lin|circ|spline)\s+$", re.IGNORECASE)
_JOINTS = words.Word("joints(a1, …)", "Joint coordinates, that of the first axis first.")


def values(lead: str, known: list[Known], wanted: str) -> Iterator[Json]:
    """Yield what can stand where a value is asked for.

    Args:
        lead: the line up to the word that is being typed.
        known: all names.
        wanted: the type that the place asks for, empty where any may stand.
    """
    for one in known:
        type_ = type_of(one)
        if one.role in NO_VALUES or not may_give(wanted, type_):
            continue
        is_meant = type_ == wanted or (wanted == "target" and type_ in _PLACES)
        yield name_item(one, "1" if not wanted else "0" if is_meant else "2")
    for place, literal in enumerate(LITERALS.get(wanted, ())):
        yield item(literal, LITERAL, wanted, "", f"1{place}")
    yield from _places(lead, wanted)
    if wanted not in _PLACES:
        yield from word_items(words.FUNCTIONS, FUNCTION, "4")
    if wanted in ("", "bool"):
        yield from some_words(words.INNER, ("not",), "3")
    if not wanted:
        yield from some_words(words.INNER, ("true", "false"), "3")


def _places(lead: str, wanted: str) -> Iterator[Json]:
    """Yield places that have no name of their own, and the word before those on the way."""
    is_run = _KNOWN_BEFORE.match(lead) is None
    if wanted in ("", "loc", "target") and is_run:
        yield from some_words(words.INNER, ("here",), "1" if wanted else "3")
    if wanted == "target" and is_run:
        yield from some_words(words.INNER, ("home",), "1")
    if wanted in ("target", "joints") or (not wanted and lead.count("(") == lead.count(")")):
        yield item("joints(", KEYWORD, _JOINTS.form, _JOINTS.meaning, "1" if wanted else "3")
    if _VERB.match(lead):
        yield item("via", KEYWORD, words.MOTIONS["via"].form, words.MOTIONS["via"].meaning, "3")

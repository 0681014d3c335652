"""Values that can begin or go on an expression, those of the type that is asked for first."""

import re
from collections.abc import Iterator

from ropsim.language import Role
from ropsim.lsp import words
from ropsim.lsp.expected import LITERALS, may_give, type_of
from ropsim.lsp.items import FUNCTION, KEYWORD, LITERAL, NO_VALUES, item, name_item, some_words, word_items
from ropsim.lsp.messages import Json
from ropsim.lsp.names import Known

_RUNNING = frozenset((Role.VARIABLE, Role.PARAMETER, Role.SIGNAL))
_PLACES = frozenset(("loc", "target", "joints"))
_MEANT = {("target", "loc"), ("target", "joints"), ("num", "int"), ("count", "int"), ("count", "num")}
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
    unfit = (*NO_VALUES, *_RUNNING) if _KNOWN_BEFORE.match(lead) else NO_VALUES
    for one in known:
        type_ = type_of(one)
        if one.role in unfit or not may_give(wanted, type_):
            continue
        is_meant = type_ == wanted or (wanted, type_) in _MEANT
        yield name_item(one, "1" if not wanted else "0" if is_meant else "2")
    for place, literal in enumerate(LITERALS.get(wanted, ())):
        yield item(literal, LITERAL, wanted, "", f"1{place}")
    yield from _places(lead, wanted)
    if wanted not in (*_PLACES, "count"):
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

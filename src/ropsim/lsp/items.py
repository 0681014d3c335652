"""What completion offers, in the protocol's form."""

from collections.abc import Iterable, Iterator, Mapping

from ropsim.language import Role
from ropsim.lsp.messages import Json
from ropsim.lsp.names import Known
from ropsim.lsp.words import Word

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
}
KEYWORD, FUNCTION, UNIT, TYPE, FIELD, LITERAL, OPERATOR = 14, 3, 11, 25, 5, 12, 24

NO_VALUES = (Role.FRAME, Role.TOOL, Role.PATTERN)
"""What names of the cell and of the text stand for no value."""


def item(label: str, kind: int, detail: str, documentation: str, group: str = "1") -> Json:
    """Return one thing that can be written; those of a lesser group come first."""
    made: Json = {"label": label, "kind": kind, "detail": detail, "sortText": f"{group}{label.lower()}"}
    if documentation:
        made["documentation"] = {"kind": "plaintext", "value": documentation}
    return made


def word_items(table: Mapping[str, Word], kind: int, group: str) -> Iterator[Json]:
    """Yield words of the language with what they mean."""
    for name, word in table.items():
        yield item(name, kind, word.form, word.meaning, group)


def some_words(table: Mapping[str, Word], wanted: Iterable[str], group: str) -> Iterator[Json]:
    """Yield some words of a table."""
    yield from word_items({name: table[name] for name in wanted}, KEYWORD, group)


def name_item(one: Known, group: str = "1") -> Json:
    """Return a name of the cell or of the text."""
    detail = f"{one.role.value}: {one.text}" if one.origin == "cell" else one.text
    return item(one.name, KINDS[one.role], detail[:120], "", group)

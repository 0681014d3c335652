"""Cache of the compiler for the versions of texts that are being edited."""

from collections.abc import Hashable
from dataclasses import fields, replace

from ropsim.language.cutting.reading import PARSER
from ropsim.language.environment import Environment
from ropsim.language.questions import ENVIRONMENT, LISTS
from ropsim.language.syntax.shapes import Shapes
from ropsim.language.syntax.text import Parsed
from ropsim.query import Database, Once

MAX_KEPT = 250_000
MAX_TEXTS = 8
"""Texts with their surroundings for which answers are kept, those used last."""

_SHAPES = Shapes()


class LineCache:
    """Parsed lines, and answers about texts; it saves time and changes no result.

    A statement depends on the characters of its line only, so a kept one is always right; an answer is taken
    again only as long as nothing that it was made of has changed.
    """

    __slots__ = ("_databases", "_parsed")

    def __init__(self) -> None:
        self._parsed: dict[str, Parsed] = {}
        self._databases: list[tuple[Environment, str, Database]] = []

    def parsed(self, text: str) -> Parsed:
        """Return statement and fault of a logical line."""
        found = self._parsed.get(text)
        if found is None:
            if len(self._parsed) >= MAX_KEPT:
                self._parsed.clear()
            found = self._parsed[text] = _SHAPES.parsed(text)
        return found

    def database(self, environment: Environment, name: str = "") -> Database:
        """Return the database of the text of that name in this environment."""
        for k, (known, text, db) in enumerate(self._databases):
            if text == name and _differ_by_lists(known, environment):
                del self._databases[k]
                self._databases.append((environment, name, db))
                if known.lists is not environment.lists:
                    db.give({LISTS: environment.lists})
                return db
        db = Database()
        db.give({PARSER: self, **_inputs(environment)})
        self._databases = [*self._databases[-MAX_TEXTS + 1 :], (environment, name, db)]
        return db


def once(environment: Environment) -> Database:
    """Return a database for one compilation of a text in this environment."""
    db = Once()
    db.give({PARSER: LineCache(), **_inputs(environment)})
    return db


_FIELDS = tuple(one.name for one in fields(Environment) if one.name != "lists")


def _differ_by_lists(one: Environment, other: Environment) -> bool:
    """Return whether two environments are made of the same objects except for their lists of points."""
    return one is other or all(getattr(one, name) is getattr(other, name) for name in _FIELDS)


def _inputs(environment: Environment) -> dict[Hashable, object]:
    """Return an environment as inputs, lists apart: only results that read them depend on them."""
    around = replace(environment, lists={}) if environment.lists else environment
    return {ENVIRONMENT: around, LISTS: environment.lists}

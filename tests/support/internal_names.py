"""Names that no message shows: of our own Prolog and Python, read from the sources, and of variables."""

import ast
import re
from collections.abc import Iterator
from functools import cache

from ropsim.core import Diagnostic
from ropsim.prolog import Struct
from ropsim.tasks import words
from support.sources import SOURCE, trees

PACKAGES = ("prolog/", "tasks/", "workbench/")
"""Packages whose messages are about knowledge bases, goals and plans, or that pass them on."""
_STANDARD = ("type_error", "instantiation_error", "existence_error", "permission_error", "syntax_error")
"""Errors of the standard of Prolog, which are predicates of its library, too."""
_MODULE = re.compile(r"^:- module\((\w+)", re.MULTILINE)
_HEAD = re.compile(r"^([a-z]\w*)(?=[( ]|\.$)", re.MULTILINE)
_OWN_ATOM = re.compile(r"\bropsim_\w+")
_TOKEN = re.compile(r"[A-Za-z]\w*")
_LAID_OUT = re.compile(
    r"(?<![\w'\"])_G?\d+\b|\buser:\w|\bsystem:\w| object at |\b(?:Struct|Atom|Var)\("
    r"|Traceback|/swipl/|'\$|\$\w+/"
)
"""Variables without a name, modules, values as Python writes them, files of Prolog and its own predicates."""


@cache
def internal_names() -> frozenset[str]:
    """Return the names of our modules, predicates, classes and functions that are no words of users.

    Names of one plain word are words of people, too, and are left out; those of modules of Prolog are not.
    """
    modules, joined = set[str](), set[str]()
    for path in SOURCE.rglob("*.pl"):
        text = path.read_text("utf-8")
        if path.parent.name == "pl":
            modules |= set(_MODULE.findall(text)) | set(_OWN_ATOM.findall(text))
            joined |= set(_HEAD.findall(text))
    for place, tree in trees().items():
        if place.startswith(PACKAGES):
            joined.add(place.rpartition("/")[2].removesuffix(".py"))
            joined |= {one for node in ast.walk(tree) for one in _named(node)}
    return frozenset((modules | {one for one in joined if _is_joined(one)}) - _public())


def shown_internals(text: str, given: str = "") -> list[str]:
    """Return what a message shows of our own parts, but for what a user has written.

    Args:
        text: of the message.
        given: what the user wrote.
    """
    tokens = [one for one in _TOKEN.findall(text) if one in internal_names()]
    laid_out = [one[0] for one in _LAID_OUT.finditer(text)]
    return [one for one in (*tokens, *laid_out) if one not in given]


def words_of(finding: Diagnostic) -> str:
    """Return all text of a finding that people can see."""
    labels = (one.text for one in finding.secondary)
    fix = finding.fix.replacement if finding.fix else ""
    data = (str(one) for one in finding.data.values())
    parts = finding.message, finding.label, finding.hint, fix, *finding.notes, *labels, *data
    return "\n".join(filter(None, parts))


def _named(node: ast.AST) -> Iterator[str]:
    """Yield the names of a class or a function, and those of the error terms that are made here."""
    match node:
        case ast.ClassDef(name=name) | ast.FunctionDef(name=name):
            yield name.strip("_")
        case ast.Call(func=ast.Name(id=Struct.__name__), args=[ast.Constant(value=str() as name), *_]):
            yield name
        case _:
            pass


def _is_joined(name: str) -> bool:
    """Return whether a name is of several words in one."""
    return "_" in name.strip("_") or sum(one.isupper() for one in name) > 1


@cache
def _public() -> frozenset[str]:
    """Return the words of texts of tasks, and the names that tasks of the library have and name."""
    vocabulary = (
        words.PROPERTIES,
        words.STATEMENTS,
        words.KINDS,
        words.FACTS,
        words.OF_PATTERNS,
        words.GEOMETRY,
    )
    library = "".join(path.read_text("utf-8") for path in sorted(SOURCE.glob("tasks/library/*.pl")))
    return frozenset((*(one for some in vocabulary for one in some), *_TOKEN.findall(library), *_STANDARD))

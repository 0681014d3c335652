"""Wrong texts of knowledge bases and wrong goals: those that the tests have, and made ones by the hundred."""

import ast
import random
import re
from collections.abc import Iterator, Sequence
from pathlib import Path

from support.sources import SOURCE

TESTS = Path(__file__).parents[1]
LONGEST = 600
"""Longer texts are about limits of memory, which have tests of their own."""
_NAME = re.compile(r"\b[a-z]\w{2,}\b")
_SIGNS = ("(", ")", "[", "]", ",", ".", ":-", "-", "+", "'", '"', "|", " ")


def texts_of_tests(folder: str) -> list[str]:
    """Return the texts of clauses and goals that the tests of a folder have, each once."""
    found: dict[str, None] = {}
    for path in sorted((TESTS / "unit" / folder).glob("test_*.py")):
        for node in ast.walk(ast.parse(path.read_text("utf-8"))):
            if isinstance(node, ast.Constant) and isinstance(node.value, str):
                text = node.value
                if len(text) <= LONGEST and ("(" in text or ":-" in text):
                    found[text] = None
    return list(found)


def wrong_texts(count: int, seed: int) -> Iterator[str]:
    """Yield clauses of the library, each with one to three mistakes."""
    chance = random.Random(seed)
    clauses = [
        clause
        for path in sorted(SOURCE.glob("tasks/library/*.pl"))
        for clause in re.split(r"(?<=\.)\n(?=task|goal|given)", path.read_text("utf-8"))
    ]
    for _ in range(count):
        text = chance.choice(clauses)
        for _ in range(chance.randint(1, 3)):
            text = _mistaken(text, chance)
        yield f"{text}\n"


def wrong_goals(count: int, seed: int) -> Iterator[str]:
    """Yield goals that are mostly wrong: unknown, unbound, of other types, cyclic, endless, unreadable."""
    chance = random.Random(seed)
    for _ in range(count):
        made = [_goal(chance, 2) for _ in range(chance.randint(1, 3))]
        goal = chance.choice((", ", ", ", " ; ", " -> ")).join(made)
        yield _mistaken(goal, chance) if chance.random() < 0.15 else goal


def _mistaken(text: str, chance: random.Random) -> str:
    """Return a text with a name misspelt, or with a sign more, less or elsewhere."""
    names = [match.span() for match in _NAME.finditer(text)]
    if names and chance.random() < 0.5:
        begin, end = chance.choice(names)
        name = text[begin:end]
        place = chance.randrange(1, len(name))
        other = chance.choice(
            (name[:place] + name[place + 1 :], name[:place] + "x" + name[place:], "X", "7", "[]")
        )
        return text[:begin] + other + text[end:]
    place = chance.randrange(len(text) + 1)
    return text[:place] + chance.choice(_SIGNS) + text[place + chance.randint(0, 2) :]


_TERMS = (
    "X",
    "Y",
    "_",
    "a",
    "'B c'",
    "7",
    "-1",
    "2.5",
    '"text"',
    "[]",
    "[a|X]",
    "f(X)",
    "f(_, g(Y))",
    "foo/1",
    "{a}",
)
_CALLED = (
    "nowhere",
    "append",
    "atom_length",
    "succ",
    "is",
    "arg",
    "functor",
    "number_codes",
    "throw",
    "call",
    "findall",
    "assertz",
    "retract",
    "clause",
    "consult",
    "open",
    "shell",
    "halt",
    "must_be",
    "msort",
    "length",
    "between",
    "nb_getval",
    "format",
    "atom_to_term",
    "copy_term",
    "catch",
    "forall",
    "maplist",
    "setof",
    "type_error",
    "existence_error",
    "permission_error",
    "resource_error",
    "broken",
    "typed",
    "lying",
    "missing_part",
    "at",
)
_WHOLE = (
    "X = f(X)",
    "X = [a|X], throw(X)",
    "X is Y + 1",
    "X is 1 / 0",
    "X is foo",
    "X is a + 1",
    "repeat, fail",
    "length(L, L)",
    "throw(error(type_error(integer, _), _))",
    "throw(error(mine(_, _), _))",
    "throw(_)",
    "user:nowhere(1)",
    "freeze(X, nowhere(X)), X = 1",
    "numlist(1, 100000, L), msort(L, M), nowhere(M)",
    "@(nowhere, user)",
    "1",
    "X",
    "lists:nowhere",
    "throw(error(existence_error(procedure, user:foo/1), _))",
    "X = point{x: 1}",
    "X = _{a: 1}",
    "atom_length(L, _)",
)


def _goal(chance: random.Random, depth: int) -> str:
    if chance.random() < 0.3:
        return chance.choice(_WHOLE)
    arguments = [_term(chance, depth) for _ in range(chance.choice((0, 1, 1, 2, 2, 3)))]
    name = chance.choice(_CALLED)
    return f"{name}({', '.join(arguments)})" if arguments else name


def _term(chance: random.Random, depth: int) -> str:
    if depth and chance.random() < 0.2:
        return f"({_goal(chance, depth - 1)})"
    return chance.choice(_TERMS)


def groups(texts: Sequence[str], size: int) -> Iterator[Sequence[str]]:
    """Yield the texts in groups of a size."""
    for begin in range(0, len(texts), size):
        yield texts[begin : begin + size]

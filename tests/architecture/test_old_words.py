"""Names of modules, classes, functions, arguments and fields use the words of the field, see GLOSSARY.md."""

import ast
import re
from collections.abc import Iterator

import pytest

from support.sources import trees

OLD = {
    "stretch": "motion sequence",
    "hopeless": "infeasible",
    "trouble": "conflict",
    "wish": "request",
    "neediest": "binding constraint",
    "course": "trajectory, profile",
    "leg": "planned move",
    "piece": "segment",
    "flown": "achieved",
    "strain": "utilisation",
    "guide": "path following",
    "begun": "context",
    "whoever": "the noun",
}
"""Words that no name contains, with the standard ones."""
RENAMED = {
    "asked": "requested",
    "beside": "further, neighbours",
    "looked": "checked, sampled",
    "told": "reported, result",
    "walked": "evaluated",
}
"""Words that no name of these packages contains."""
PACKAGES = {"collision", "controller", "lsp", "motion", "nirox", "planning", "query", "simulation", "views"}
OF_MOTION = {
    "band": "limit grid",
    "corner": "blend",
    "demand": "constraint rows",
    "kept": "retimed",
    "look": "sample",
    "need": "binding constraint",
    "place": "path parameter",
    "room": "work, margin",
    "rough": "interpolation error",
    "stage": "path limits",
    "walk": "evaluate",
    "way": "path, distance",
}
"""Words that no name of `planning` and `motion` contains."""
ALLOWED = {
    "flow/events.py": {"flown"},  # a field of recordings: its name is part of the file format
    "studio/wire/command_messages.py": {"begun"},  # fields of messages
    "studio/wire/replies.py": {"begun"},
}
"""Words that a module may keep."""
TERMS = re.compile(r"look_ahead")
"""Terms of the field that contain an old word."""


def banned(package: str) -> dict[str, str]:
    """Return the words that names of a package do not contain."""
    return (
        OLD
        | (RENAMED if package in PACKAGES else {})
        | (OF_MOTION if package in {"motion", "planning"} else {})
    )


def words(name: str) -> Iterator[str]:
    """Yield the words of a name in small letters, without the endings of plurals and past tenses."""
    for word in re.findall(r"[a-z]+|[A-Z][a-z]*", TERMS.sub("", name)):
        yield re.sub(r"(?<=sh|ch)(es|ed)$|s$", "", word.lower())


def names(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Yield the names of classes, functions, arguments and fields, with their lines."""
    for node in ast.walk(tree):
        match node:
            case ast.FunctionDef() | ast.AsyncFunctionDef():
                yield node.lineno, node.name
                arguments = node.args
                yield from (
                    (one.lineno, one.arg)
                    for one in (*arguments.posonlyargs, *arguments.args, *arguments.kwonlyargs)
                )
            case ast.ClassDef():
                yield node.lineno, node.name
                fields = (one for one in node.body if isinstance(one, ast.AnnAssign))
                yield from ((one.lineno, one.target.id) for one in fields if isinstance(one.target, ast.Name))
            case _:
                pass


def old_words(module: str, tree: ast.Module) -> Iterator[str]:
    """Yield each old word in the names of a module, with its line."""
    stem, old = module.rpartition("/")[2].removesuffix(".py"), banned(module.partition("/")[0])
    for line, name in ((1, stem), *names(tree)):
        for word in words(name):
            if word in old and word not in ALLOWED.get(module, set()):
                yield f"{module}:{line}: {name}: say {old[word]}"


@pytest.mark.parametrize("package", sorted({name.partition("/")[0] for name in trees() if "/" in name}))
def test_no_name_has_an_old_word(package: str) -> None:
    modules = {name: tree for name, tree in trees().items() if name.startswith(f"{package}/")}
    found = [one for name, tree in sorted(modules.items()) for one in old_words(name, tree)]
    assert not found, "\n".join(found)


def test_an_old_word_is_found_in_each_kind_of_name() -> None:
    text = "class TwoLegs:\n    stretches: int\n\ndef f(last_wish: int) -> None: ...\n"
    found = list(old_words("cli/course.py", ast.parse(text)))
    assert [one.split(": ")[1] for one in found] == ["course", "TwoLegs", "stretches", "last_wish"]


def test_words_of_other_packages_are_old_in_motion() -> None:
    tree = ast.parse("def f(place: int, told: int, look_ahead: int) -> None: ...\n")
    found = {package: len(list(old_words(f"{package}/x.py", tree))) for package in ("cli", "lsp", "motion")}
    assert found == {"cli": 0, "lsp": 1, "motion": 2}

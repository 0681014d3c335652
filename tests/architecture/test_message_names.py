"""Messages about knowledge bases name what users wrote, and no part of ropsim, of Python or of Prolog."""

import ast
from collections.abc import Iterator

import pytest

from ropsim.cli import all_kinds
from support.internal_names import PACKAGES, internal_names, shown_internals
from support.sources import nodes, trees

CODES = ("P1", "P2")
"""The band of the packages that read Prolog."""
PROLOG = (":- ", "sandbox:", "safe_primitive")
"""Text that is given to Prolog and shown to nobody."""


def literals(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Yield each text with a blank, which is prose, with its line.

    Docstrings, annotations and texts for Prolog are none.
    """
    nodes = list(ast.walk(tree))
    skipped = {id(one.value) for one in nodes if isinstance(one, ast.Expr)}
    annotations = [getattr(one, name, None) for one in nodes for name in ("annotation", "returns")]
    skipped |= {id(one) for whole in annotations if whole is not None for one in ast.walk(whole)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in skipped:
            text = node.value
            if " " in text.strip() and not any(word in text for word in PROLOG):
                yield node.lineno, text


def messages() -> list[tuple[str, str]]:
    """Return the place and the text of all prose of the packages."""
    return [
        (f"{path}:{line}", text)
        for path, tree in trees().items()
        if path.startswith(PACKAGES)
        for line, text in literals(tree)
    ]


def test_no_message_is_written_with_an_internal_name() -> None:
    found = {place: names for place, text in messages() if (names := shown_internals(text))}
    assert found == {}


def test_no_message_shows_a_value_as_python_writes_it() -> None:
    """A conversion `!r`, or the name of a class, inside of the call that makes a finding."""
    found = [
        f"{path}:{node.lineno}"
        for path, tree in trees().items()
        if path.startswith(PACKAGES)
        for call in nodes(tree, ast.Call)
        if isinstance(call.func, ast.Attribute) and call.func.attr == "at"
        for node in ast.walk(call)
        if (isinstance(node, ast.FormattedValue) and node.conversion == ord("r"))
        or (isinstance(node, ast.Attribute) and node.attr in ("__name__", "__class__", "__qualname__"))
    ]
    assert found == []


def test_no_page_on_knowledge_bases_shows_an_internal_name() -> None:
    pages = {code: kind for code, kind in all_kinds().items() if code.startswith(CODES)}
    assert len(pages) > 40
    shown = {
        code: names
        for code, kind in pages.items()
        if (names := shown_internals(f"{kind.summary}\n{kind.explanation}"))
    }
    assert shown == {}


def test_internal_names_are_those_of_the_sources() -> None:
    expected = {
        "ropsim_kb",
        "ropsim_door",
        "ropsim_stop",
        "read_base",
        "check_call",
        "python_error",
        "KnowledgeBase",
    }
    assert expected <= internal_names()
    assert not internal_names() & {"in_rows", "wait_until", "collision_free", "chuck_of", "unload_pallet"}
    assert len(messages()) > 300


@pytest.mark.parametrize(
    ("text", "given", "shown"),
    [
        ("no predicate `read_base`", "", ["read_base"]),
        ("found _G123 and _45", "", ["_G123", "_45"]),
        ("user:foo/1 is unknown", "", ["user:f"]),
        ("<Host object at 0x7f>", "", [" object at "]),
        ("`read_base` is no task", "call(read_base(L))", []),
        ("a part `_Part` at 50 mm", "", []),
    ],
)
def test_what_is_internal_is_seen(text: str, given: str, shown: list[str]) -> None:
    assert shown_internals(text, given) == shown

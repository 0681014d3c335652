"""Places of keys and values."""

import pytest

from ropsim.core import SourceText, Span
from ropsim.tomltext import Path, positions

TEXT = '''# comment [not.a.section]
top = 1  # = 2
"quo\\u0074ed key" = 2
[a.b]
c = [1, [2, "x, ] y"], # comment ]
     {d = 3, e.f = 4}]
text = """
line with = and [brackets] \\""" quote"""
raw = \'\'\'it\'s\'\'\'
when = 1979-05-27 07:32:00
[[list]]
x = 1
[[list]]
x = 2
[list.sub]
y = 3
'''


def words(span: Span) -> str:
    return TEXT.split("\n")[span.line - 1][span.column - 1 : span.end_column - 1]


@pytest.mark.parametrize(
    ("path", "marked", "line"),
    [
        (("top",), "top", 2),
        (("quoted key",), '"quo\\u0074ed key"', 3),
        (("a",), "a", 4),
        (("a", "b"), "[a.b]", 4),
        (("a", "b", "c"), "c", 5),
        (("a", "b", "c", 2, "d"), "d", 6),
        (("a", "b", "c", 2, "e", "f"), "f", 6),
        (("a", "b", "raw"), "raw", 9),
        (("list", 1), "[[list]]", 13),
        (("list", 0, "x"), "x", 12),
        (("list", 1, "x"), "x", 14),
        (("list", 1, "sub", "y"), "y", 16),
    ],
)
def test_keys_are_found(path: Path, marked: str, line: int) -> None:
    span = positions(SourceText("t", TEXT)).key(path)
    assert (words(span), span.line) == (marked, line)


@pytest.mark.parametrize(
    ("path", "marked", "line"),
    [
        (("top",), "1", 2),
        (("a", "b", "c", 1, 1), '"x, ] y"', 5),
        (("a", "b", "c", 1), '[2, "x, ] y"]', 5),
        (("a", "b", "c", 2), "{d = 3, e.f = 4}", 6),
        (("a", "b", "text"), '"""', 7),
        (("a", "b", "raw"), "'''it's'''", 9),
        (("a", "b", "when"), "1979-05-27 07:32:00", 10),
        (("list", 1, "x"), "2", 14),
    ],
)
def test_values_are_found(path: Path, marked: str, line: int) -> None:
    span = positions(SourceText("t", TEXT)).value(path)
    assert (words(span), span.line) == (marked, line)


def test_an_unknown_path_gives_the_nearest_thing_around_it() -> None:
    places = positions(SourceText("t", TEXT))
    assert words(places.key(("a", "b", "nothing", 3))) == "[a.b]"
    assert places.key(("nothing",)).line == 1


@pytest.mark.parametrize(("opened", "closed"), [("[", "]"), ("{a = ", "}")])
def test_values_are_found_however_deep_they_are_nested(opened: str, closed: str) -> None:
    depth = 2_000  # more than a recursion could go
    places = positions(SourceText("t", f"x = {opened * depth}1{closed * depth}\nlast = 2\n"))
    assert len(places.values) == depth + 2
    assert places.value(("last",)).line == 2

"""Documents: positions in UTF-16, every kind of line end, changes as an editor sends them."""

import pytest

from ropsim.core import Span
from ropsim.lsp.testing import ContentChange, Document, Position, Range

ROBOT = "\N{ROBOT FACE}"


def change(start: tuple[int, int], end: tuple[int, int], text: str) -> ContentChange:
    return ContentChange(text, Range(Position(*start), Position(*end)))


def test_a_character_beyond_the_basic_plane_counts_two_units() -> None:
    document = Document("a", 1, f'print "{ROBOT}", x')
    assert document.column(Position(0, 11)) == 10
    assert document.position(0, 10) == {"line": 0, "character": 11}


def test_a_position_inside_of_a_surrogate_pair_is_the_character_after_it() -> None:
    assert Document("a", 1, ROBOT + "b").column(Position(0, 1)) == 1


@pytest.mark.parametrize("end", ["\n", "\r\n", "\r"])
def test_every_line_end_ends_a_line(end: str) -> None:
    document = Document("a", 1, f"one{end}two{end}")
    assert [document.line(k) for k in range(4)] == ["one", "two", "", ""]
    assert document.offset(Position(1, 1)) == 4 + len(end)


def test_line_ends_of_every_kind_may_be_mixed() -> None:
    document = Document("a", 1, "one\r\ntwo\rthree\nfour\r\n")
    assert [document.line(k) for k in range(5)] == ["one", "two", "three", "four", ""]
    plain = Document("a", 1, "one\r\n\ntwo\u2028\x0c\r\n")
    assert [plain.line(k) for k in range(4)] == ["one", "", "two\u2028\x0c", ""]


def test_positions_beyond_a_line_or_the_text_are_its_end() -> None:
    document = Document("a", 1, "one\r\ntwo")
    assert document.offset(Position(0, 99)) == 3
    assert document.offset(Position(9, 0)) == 8


def test_changes_are_made_one_after_the_other() -> None:
    document = Document("a", 1, "mov a\r\nlin b\r\n")
    after = document.changed([change((1, 4), (1, 5), "infeed"), change((0, 0), (1, 0), "")], 2)
    assert after.text == "lin infeed\r\n"
    assert after.version == 2


def test_a_change_without_range_is_the_whole_text() -> None:
    assert Document("a", 1, "x").changed([ContentChange("y")], 2).text == "y"


def test_a_range_that_ends_before_it_starts_is_an_insertion() -> None:
    assert Document("a", 1, "abc").changed([change((0, 2), (0, 1), "-")], 2).text == "ab-c"


def test_a_span_of_a_whole_line_marks_its_words() -> None:
    document = Document("a", 1, "one\n  two  ")
    assert document.range_of(Span.whole_line("a", 2)) == {
        "start": {"line": 1, "character": 2},
        "end": {"line": 1, "character": 5},
    }


def test_a_uri_that_is_no_file_names_itself() -> None:
    document = Document("untitled:1", 1, "")
    assert document.path is None
    assert document.name == "untitled:1"


def test_blanks_in_a_file_uri_are_read() -> None:
    assert Document("file:///a%20b/c.task", 1, "").name == "/a b/c.task"

"""XML of strangers: bounded, without entities, every element with its place."""

from ropsim.core import SourceText
from ropsim.exchange.files.xml_tree import MOST_DEPTH
from ropsim.exchange.testing import (
    LOST_DESCRIPTION,
    MOST_ATTRIBUTE,
    MOST_ELEMENTS,
    MOST_NOTES,
    NOT_XML,
    Element,
    Notes,
    read_xml,
)

BOMB = """<?xml version="1.0"?>
<!DOCTYPE lolz [<!ENTITY a "ha"><!ENTITY b "&a;&a;&a;&a;">]>
<robot name="&b;"/>"""
OUTSIDE = '<!DOCTYPE r [<!ENTITY x SYSTEM "file:///etc/hostname">]><robot>&x;</robot>'


def read(text: str) -> tuple[Element | None, list[str]]:
    notes = Notes()
    root = read_xml(SourceText("a.xml", text), notes)
    return root, [str(one) for one in notes.found]


def test_elements_know_where_they_stand() -> None:
    root, found = read('<?xml version="1.0" encoding="latin-1"?>\n<a>\n  <b x="é"/> words\n  <c/>\n</a>')
    assert found == []
    assert root is not None
    assert [(one.name, str(one.span)) for one in root.children] == [("b", "a.xml:3:3"), ("c", "a.xml:4:3")]
    assert root.children[0].attributes["x"] == "é"
    assert root.text == "words"


def test_a_mistake_is_told_where_the_reader_could_not_go_on() -> None:
    root, found = read("<a>\n  <b>\n</a>")
    assert root is None
    assert found[0].startswith("a.xml:3:3: error[X980]")


def test_entities_and_document_types_are_refused_with_their_place() -> None:
    for text, place in ((BOMB, "a.xml:2:"), (OUTSIDE, "a.xml:1:")):
        root, found = read(text)
        assert root is None
        assert found[0].startswith(place)
        assert "X981" in found[0]


def test_an_entity_that_nobody_defines_is_no_xml() -> None:
    assert "X980" in read("<a>&b;</a>")[1][0]


def test_size_depth_and_attributes_are_bounded() -> None:
    assert "deep" in read("<a>" * (MOST_DEPTH + 1))[1][0]
    assert read("<a>" * MOST_DEPTH + "</a>" * MOST_DEPTH)[1] == []
    assert "characters" in read(f'<a b="{"c" * (MOST_ATTRIBUTE + 1)}"/>')[1][0]
    assert "elements" in read(f"<a>{'<b/>' * MOST_ELEMENTS}</a>")[1][0]


def test_only_so_many_findings_are_kept() -> None:
    notes = Notes()
    for _ in range(10 * MOST_NOTES):
        notes.add(NOT_XML, None, "a")
    assert len(notes.found) == MOST_NOTES


def test_an_error_behind_many_hints_still_forbids_the_robot() -> None:
    notes = Notes()
    for _ in range(10 * MOST_NOTES):
        notes.add(LOST_DESCRIPTION, None, "a")
    notes.add(NOT_XML, None, "b " * 2000)
    assert notes.fatal
    (error,) = [one for one in notes.found if one.is_error]
    assert len(error.message) < 500

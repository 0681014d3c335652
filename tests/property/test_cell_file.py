"""Any text at all gets a cell or findings, never an exception, and every finding points into the text."""

import tomllib
from typing import Any

from hypothesis import example, given, settings
from hypothesis import strategies as st

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.tomltext import positions
from support.examples import examples
from support.fuzzing.cells import RIGHT

VALUES = ["nan", "-inf", "1e308", "0xffffffffffffffffff", '"text"', "[]", "{}", "true", "[[1]]", "1979-05-27"]


def check(text: str) -> None:
    source = SourceText("cell.toml", text)
    cell, findings = read_cell(source, "folder")
    assert (cell is None) == any(found.is_error for found in findings)
    for found in findings:
        assert found.span is not None
        assert 1 <= found.span.line <= len(source.lines)
        assert 1 <= found.span.column <= len(source.line(found.span.line)) + 1


def test_the_text_that_is_mutated_below_is_right() -> None:
    cell, findings = read_cell(SourceText("cell.toml", RIGHT), "folder")
    assert cell is not None
    assert findings == ()


@settings(max_examples=examples(200), derandomize=True)
@given(st.binary(max_size=200))
@example(b"\xef\xbb\xbf[robot]")
@example(b"a = [[[[[[[[[[[[[[[[[[[[")
def test_random_bytes(content: bytes) -> None:
    check(content.decode("utf-8", errors="replace"))


@settings(max_examples=examples(200), derandomize=True)
@given(st.data())
def test_mutations_of_a_right_file(data: st.DataObject) -> None:
    text = RIGHT
    for _ in range(data.draw(st.integers(1, 3))):
        start = data.draw(st.integers(0, len(text)))
        end = data.draw(st.integers(start, min(start + 20, len(text))))
        text = text[:start] + data.draw(st.text(alphabet="[]{}=.,\"#\n 'ax19-", max_size=4)) + text[end:]
    check(text)


@settings(max_examples=examples(200), derandomize=True)
@given(st.data())
def test_foreign_values_in_a_right_file(data: st.DataObject) -> None:
    lines = RIGHT.split("\n")
    chosen = data.draw(st.sampled_from([k for k, line in enumerate(lines) if " = " in line]))
    key = lines[chosen].split(" = ")[0]
    lines[chosen] = f"{key} = {data.draw(st.sampled_from(VALUES))}"
    check("\n".join(lines))


@settings(max_examples=examples(200), derandomize=True)
@given(st.data())
def test_every_value_of_a_valid_file_has_a_place_that_holds_it(data: st.DataObject) -> None:
    source = SourceText("t", RIGHT)
    places = positions(source)
    path = data.draw(st.sampled_from(sorted(places.values, key=str)))
    span = places.values[path]
    value: Any = tomllib.loads(RIGHT)
    for step in path:
        value = value[step]
    marked = source.line(span.line)[span.column - 1 : span.end_column - 1]
    assert tomllib.loads(f"x = {marked}")["x"] == value

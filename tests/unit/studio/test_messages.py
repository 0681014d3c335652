"""Both sides of `/ws/studio` know the same messages with the same fields."""

import json
import math
import re
from pathlib import Path
from typing import get_args

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st

from ropsim.studio import commands, messages

PAGE_SIDE = Path(__file__).parents[3] / "frontend" / "src" / "wire"
BY_THE_WORKER = {"layout", "placed", "printed", "stamped"}
"""Messages of a live run that are put together in the worker."""

INTERFACE = re.compile(r"^export interface (\w+)(?: extends (\w+))? \{\n(.*?)^\}", re.MULTILINE | re.DOTALL)
FIELD = re.compile(r"^  readonly (\w+): ([^\n]+)", re.MULTILINE)


def page_side() -> dict[str, dict[str, str]]:
    """Return the fields of each interface of the page, with their types."""
    text = "".join((PAGE_SIDE / name).read_text("utf-8") for name in ("commands.ts", "messages.ts"))
    found = {name: (base, dict(FIELD.findall(body))) for name, base, body in INTERFACE.findall(text)}
    return {name: {**(found[base][1] if base else {}), **fields} for name, (base, fields) in found.items()}


def by_tag() -> dict[str, set[str]]:
    """Return the fields of the page's messages by their tag."""
    return {
        fields["type"].strip("'"): set(fields) - {"type"}
        for fields in page_side().values()
        if "type" in fields
    }


def structs() -> dict[str, set[str]]:
    """Return the fields of the server's messages by their tag."""
    kinds = [*get_args(commands.Command), *get_args(messages.Message)]
    tagged = [kind for kind in kinds if isinstance(kind, type) and issubclass(kind, msgspec.Struct)]
    return {str(kind.__struct_config__.tag): set(kind.__struct_fields__) for kind in tagged}


@pytest.mark.skipif(not PAGE_SIDE.exists(), reason="the sources of the pages are not part of this tree")
def test_messages_have_the_same_fields_on_both_sides() -> None:
    theirs = {tag: fields for tag, fields in by_tag().items() if tag not in BY_THE_WORKER}
    assert structs() == theirs


@pytest.mark.skipif(not PAGE_SIDE.exists(), reason="the sources of the pages are not part of this tree")
def test_parts_of_messages_have_the_same_fields_on_both_sides() -> None:
    theirs = page_side()
    assert set(messages.DocumentState.__struct_fields__) == set(theirs["DocumentState"])
    assert set(messages.TrustState.__struct_fields__) == set(theirs["TrustState"])


def test_a_command_is_read_from_its_json() -> None:
    text = '{"type":"jog_joints","id":7,"q":[0,1.5],"tool":"jaws"}'
    assert commands.read_command(text) == (commands.JogJoints(7, (0.0, 1.5), "jaws"), "")


HOSTILE = [
    "",
    "{",
    "[]",
    "null",
    '{"type":"sing"}',
    '{"type":"edit"}',
    '{"type":"hello","tab":1}',
    '{"type":"jog_tcp","id":1,"q":[],"tool":"","target":[1,2]}',
    "[" * 100_000,
    b"\xff\xfe",
]


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_a_text_that_is_no_command_is_told_in_words(text: str | bytes) -> None:
    command, problem = commands.read_command(text)
    assert command is None
    assert problem


@given(st.one_of(st.text(), st.binary()))
def test_no_text_raises(text: str | bytes) -> None:
    command, problem = commands.read_command(text)
    assert (command is None) == bool(problem)


def test_numbers_that_are_not_finite_are_sent_as_null() -> None:
    assert messages.wire({"type": "live", "speed": float("nan")}) == b'{"type":"live","speed":null}'


def test_names_that_are_no_unicode_are_sent_all_the_same() -> None:
    sent = messages.wire(
        messages.RunStatus(1, "done", "a\udcff", findings=({"time": math.nan, "x": "\udcff"},))
    )
    message = json.loads(sent)
    assert (message["type"], message["program"]) == ("run", "a\ufffd")
    assert message["findings"] == [{"time": None, "x": "\ufffd"}]


@pytest.mark.parametrize(
    "text",
    [
        json.dumps({"type": "edit", "document": "a", "text": "", "version": 2**60}),
        json.dumps({"type": "edit", "document": "a" * 5000, "text": "", "version": 1}),
        json.dumps({"type": "jog_joints", "id": 1, "q": [0.0] * 1000, "tool": ""}),
        json.dumps({"type": "run", "program": "a" * 5000, "fidelity": "dynamic"}),
        json.dumps({"type": "signal", "name": "a" * 5000, "value": 1.0}),
        '{"type":"signal","name":"a","value":1e999}',
        '{"type":"hello","tab":"\\ud800"}',
        '{"type":"edit","x":' + "[" * 100_000,
    ],
)
def test_what_is_beyond_measure_is_no_command(text: str) -> None:
    command, words = commands.read_command(text)
    assert command is None
    assert words

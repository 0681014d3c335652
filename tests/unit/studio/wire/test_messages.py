"""Both sides of `/ws/studio` know the same messages: the types of the pages are written from the records."""

import json
import math
import subprocess
import sys
from collections.abc import Mapping
from enum import Enum
from pathlib import Path
from typing import Literal

import msgspec
import pytest
from hypothesis import given
from hypothesis import strategies as st
from tools import wire_types

from ropsim.core import frozen_dataclass
from ropsim.studio.testing import PoseNumbers, commands, content, messages
from support.characters import ANY

ROOT = Path(__file__).parents[4]
PAGE_SIDE = ROOT / "frontend" / "src" / "wire"


@pytest.mark.skipif(not PAGE_SIDE.exists(), reason="an sdist carries the pages built, not their sources")
def test_the_types_of_the_pages_are_those_of_the_records() -> None:
    command = [sys.executable, "tools/wire_types.py", "--check"]
    result = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=False)
    assert (result.returncode, result.stderr) == (0, ""), result.stdout


class Sample(msgspec.Struct, frozen=True, tag_field="type", tag="sample"):
    """A record.

    Attributes:
        pose: None where it
            has none.
    """

    pose: PoseNumbers | None
    level: Literal["low", "high"]
    names: tuple[messages.JogWords, ...]
    counts: Mapping[str, int]
    pair: tuple[int, str]
    either: tuple[int | str, ...]
    scene: content.Scene | None
    place: commands.Place


def test_a_record_becomes_an_interface() -> None:
    assert wire_types.interface(Sample) == "\n".join(
        [
            "/** A record. */",
            "export interface Sample {",
            "  readonly type: 'sample'",
            "  /** Null where it has none. */",
            "  readonly pose: Pose | null",
            "  readonly level: 'low' | 'high'",
            "  readonly names: readonly JogWords[]",
            "  readonly counts: Readonly<Record<string, number>>",
            "  readonly pair: readonly [number, string]",
            "  readonly either: readonly (number | string)[]",
            "  readonly scene: SceneDescription | null",
            "  readonly place: string",
            "}",
        ]
    )


def test_a_record_comes_after_those_that_it_holds() -> None:
    assert list(wire_types.parts(Sample)) == [messages.JogWords, Sample]


class Colour(Enum):
    RED = "red"
    GREEN = "green"


@frozen_dataclass
class Kept:
    """A record of a file.

    Attributes:
        limit: -inf where
            unknown, NaN where not asked for.
    """

    colour: Colour
    limit: float = -math.inf
    rate: float = math.nan
    count: float = 0.0
    end: float | None = None


def test_numbers_of_a_record_that_may_not_be_finite_may_be_null() -> None:
    assert wire_types.interface(Kept) == "\n".join(
        [
            "/** A record of a file. */",
            "export interface Kept {",
            "  readonly colour: 'red' | 'green'",
            "  /** Null where unknown, null where not asked for. */",
            "  readonly limit: number | null",
            "  readonly rate: number | null",
            "  readonly count: number",
            "  readonly end: number | null",
            "}",
        ]
    )


def test_a_record_that_several_files_need_stands_in_one() -> None:
    texts = wire_types.texts()
    assert "import type { Destinations } from './facts'" in texts["result.ts"]
    assert [name for name, text in texts.items() if "interface Destinations" in text] == ["facts.ts"]


def test_a_type_without_a_rule_is_refused() -> None:
    with pytest.raises(TypeError, match="no TypeScript for"):
        wire_types.typescript(set[int])


def test_a_command_is_read_from_its_json() -> None:
    text = '{"type":"jog_joints","id":7,"station":"left","q":[0,1.5],"tool":"jaws"}'
    assert commands.read_command(text) == (commands.JogJoints("left", (0.0, 1.5), "jaws", 7), "")


HOSTILE = [
    "",
    "{",
    "[]",
    "null",
    '{"type":"sing"}',
    '{"type":"edit"}',
    '{"type":"hello","tab":1}',
    '{"type":"jog_tcp","id":1,"station":"robot","q":[],"tool":"","target":[1,2]}',
    "[" * 100_000,
    b"\xff\xfe",
]


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_a_text_that_is_no_command_is_told_in_words(text: str | bytes) -> None:
    command, problem = commands.read_command(text)
    assert command is None
    assert problem


@given(st.one_of(st.text(ANY), st.binary()))
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


EMPTY_STEP: dict[str, object] = {"name": "", "points": [], "values": []}
UNMEASURED_STEPS: list[list[dict[str, object]]] = [
    [EMPTY_STEP] * 201,
    [{"name": "a" * 5000, "points": [], "values": []}],
    [{"name": "", "points": [""] * 65, "values": []}],
    [{"name": "", "points": [], "values": [5]}],
    [{"name": "", "points": []}],
]


@pytest.mark.parametrize(
    "text",
    [
        json.dumps({"type": "edit", "document": "a", "text": "", "version": 2**60}),
        json.dumps({"type": "edit", "document": "a" * 5000, "text": "", "version": 1}),
        json.dumps({"type": "jog_joints", "id": 1, "station": "robot", "q": [0.0] * 1000, "tool": ""}),
        json.dumps({"type": "run", "program": "a" * 5000, "fidelity": "dynamic"}),
        json.dumps({"type": "signal", "name": "a" * 5000, "value": 1.0}),
        *(json.dumps({"type": "check_tasks", "id": 1, "steps": steps}) for steps in UNMEASURED_STEPS),
        '{"type":"signal","name":"a","value":1e999}',
        '{"type":"hello","tab":"\\ud800"}',
        '{"type":"edit","x":' + "[" * 100_000,
    ],
)
def test_what_is_beyond_measure_is_no_command(text: str) -> None:
    command, words = commands.read_command(text)
    assert command is None
    assert words

"""Every key that the reader of cell files asks for is explained where the manual speaks of its section."""

import re
from pathlib import Path

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.parts import PART_KINDS, Use

MANUAL = (Path(__file__).parents[3] / "docs" / "reference" / "cell-file.md").read_text("utf-8")
ARM = '[robot]\nmodel = "puma560"\n'
STRANGE = "qqqqqqqqqqqq = 1"
"""Stands for a key that nobody knows; the finding lists those that are known there."""

LOOK = {"size", "diameter", "height", "shapes"}
"""What a body looks like, explained in one sentence."""


def asked_for(text: str) -> set[str]:
    """Return the keys that are known where a cell file has the strange one."""
    _, findings = read_cell(SourceText("cell.toml", text.replace("?", STRANGE) + "\n"), "")
    (found,) = (one for one in findings if one.code == "X802")
    return set(re.findall(r"`(\w+)`", found.hint))


def words_of(text: str) -> set[str]:
    """Return the words in backticks of a text, and the two keys that the word orientation stands for."""
    quoted = re.findall(r"`([^`]*)`", text)
    plain = re.sub(r"`[^`]*`", "", text)
    orientation = {"rpy", "quaternion"} if "orientation" in plain else set()
    return {word for one in quoted for word in re.findall(r"\w+", one)} | orientation


def behind(opening: str) -> str:
    """Return the manual from a line on that begins so."""
    (_, after) = MANUAL.split(f"\n{opening}", 1)
    return opening + after


def told(opening: str) -> set[str]:
    """Return the words of the row, or else of the paragraph, that begins so."""
    return words_of(behind(opening).split("\n" if opening.startswith("|") else "\n\n")[0])


def listed(opening: str) -> set[str]:
    """Return the words of the first column of the first table behind a line that begins so."""
    rows = behind(opening).partition("\n| key")[2] if not opening.startswith("| key") else behind(opening)
    return {word for row in rows.split("\n\n")[0].splitlines()[1:] for word in words_of(row.split("|")[1])}


def kinds_of_sensors() -> list[str]:
    """Return the kinds that the reader knows, from its finding about one that it does not know."""
    text = f'{ARM}[signals.a]\ninput = 1\nsensor = {{ kind = "none such" }}\n'
    (found,) = (one for one in read_cell(SourceText("cell.toml", text), "")[1] if one.code == "X808")
    return re.findall(r"`([^`]*)`", found.message.partition("allowed are")[2])


UNITS = words_of(behind("## Units").partition("\nThe tables")[0])
ROBOT, STATION, CONTROLLER = listed("## `[robot]`"), listed("## `[stations."), listed("## `[controller]`")
TRACK, POSITIONER = listed("| key of `track`"), listed("| key of `positioner`")
MECHANISM, DEVICE = listed("| key of `mechanism`"), listed("## `[devices.")
CONVEYOR = DEVICE | listed("**`conveyor`**")
MOVED = DEVICE | listed("**`slide`**") | LOOK
TOOL, SHAPES, SIGNAL = listed("## `[tools."), listed("### Shapes"), listed("## `[signals.")
PARTS, DESTINATIONS, SENSOR = (
    listed("## `[[parts]]`"),
    listed("### Destinations"),
    listed("### Sensors at tools"),
)
SENSOR_ERRORS = listed("| key of an error")

SENSORS = behind("### Sensors of the joint controller").partition("\n### ")[0]
ENTITIES = behind("### Entities from modules of the project").partition("\n## ")[0]

LIBRARY = listed("### Parts of the library")
HEADS = {
    Use.TOOL: "[tools.a]",
    Use.OBJECT: "[[objects]]",
    Use.CONVEYOR: '[devices.a]\nkind = "conveyor"',
    Use.TURNTABLE: '[devices.a]\nkind = "turntable"',
}

KINDS_OF_SENSORS = kinds_of_sensors()
EXPLAINED = [
    (f"?\n{ARM}", {*re.findall(r"^## `\[+(\w+)", MANUAL, re.MULTILINE), *UNITS}),
    (f"{ARM}[cell]\n?", listed("## `[cell]`")),
    (f"{ARM}[units]\n?", UNITS),
    (f"{ARM}?", ROBOT),
    (
        f"{ARM}base = {{ ? }}",
        told("| `base` | world frame | inline table with `position` and orientation of the b"),
    ),
    (f"{ARM}[controller]\n?", CONTROLLER),
    ('[robot]\nmodel = "two_link"\n[controller]\n?', CONTROLLER),
    (f"{ARM}[controller.entities]\n?", words_of(ENTITIES)),
    (f"{ARM}[controller.sensors]\n?", words_of(SENSORS)),
    (f"{ARM}[controller.sensors]\ncoordinate = {{ ? }}", words_of(SENSORS)),
    (f"{ARM}track = {{ ? }}", TRACK),
    (f'{ARM}track = {{ kind = "gantry", ? }}', TRACK),
    (f"{ARM}track = {{ mount = {{ ? }} }}", told("| `mount`")),
    (f"{ARM}positioner = {{ ? }}", POSITIONER),
    (f'{ARM}positioner = {{ kind = "tilt_and_turn", ? }}', POSITIONER),
    (f"{ARM}positioner = {{ base = {{ ? }} }}", told("| `base` | needed")),
    ("[stations.a]\n?", STATION),
    ('[stations.a]\nrobot = "puma560"\n[stations.a.controller]\n?', CONTROLLER),
    ('[stations.a.mechanism]\nkind = "slide"\n?', MECHANISM),
    ('[stations.a.mechanism]\nkind = "turntable"\n?', MECHANISM),
    (f'{ARM}[devices.a]\nkind = "conveyor"\n?', CONVEYOR),
    (
        f'{ARM}[devices.a]\nkind = "conveyor"\nbase = {{ ? }}',
        told("| `base` | world frame | inline table with `position` and orientation of its"),
    ),
    (f'{ARM}[devices.a]\nkind = "conveyor"\nstop = {{ ? }}', told("| `stop`")),
    (f'{ARM}[devices.a]\nkind = "slide"\n?', MOVED),
    (f'{ARM}[devices.a]\nkind = "slide"\nstep = 1\n?', MOVED),
    (f'{ARM}[devices.a]\nkind = "turntable"\ndiameter = 1\n?', MOVED),
    (f"{ARM}[tools.a]\n?", TOOL),
    (f"{ARM}[tools.a]\ngripper = {{ ? }}", told("`gripper`:")),
    (f"{ARM}[tools.a]\ngripper = {{ fingers = {{ ? }} }}", told("`fingers`:")),
    (f"{ARM}[tools.a]\nparts = [{{ ? }}]", told("| `parts`")),
    (f"{ARM}[tools.a]\nshapes = [{{ ? }}]", SHAPES),
    (f'{ARM}[tools.a]\npart = {{ kind = "two_finger_gripper" }}\n?', TOOL),
    (f'{ARM}[devices.a]\nkind = "conveyor"\npart = {{ kind = "belt_conveyor" }}\n?', CONVEYOR),
    (f'{ARM}[devices.a]\nkind = "turntable"\npart = {{ kind = "turntable" }}\n?', MOVED),
    (f'{ARM}[[objects]]\npart = {{ kind = "table" }}\n?', listed("## `[[objects]]`")),
    *(
        (
            f'{ARM}{head}\npart = {{ kind = "{kind.name}", ? }}',
            LIBRARY | {one.name for one in kind.parameters},
        )
        for kind in PART_KINDS.values()
        for head in (HEADS[kind.use],)
    ),
    (f"{ARM}[frames.a]\n?", told("A task frame K") | told("`parent = ")),
    (f"{ARM}[locations.a]\n?", listed("## `[locations.")),
    (f"{ARM}[stations.b]\n[locations.a]\nexternal = [1]\n?", listed("## `[locations.")),
    (f"{ARM}[[parts]]\n?", PARTS),
    (f"{ARM}[[parts]]\ngrid = {{ ? }}", told("| `grid` | one part")),
    (f"{ARM}[[parts]]\ndestination = {{ ? }}", DESTINATIONS),
    (f"{ARM}[[parts]]\ndestination = {{ grid = {{ ? }} }}", told("| `grid` | |")),
    (f"{ARM}[[supplies]]\n?", told("A place where parts appear")),
    (f"{ARM}[[sinks]]\n?", told("A place where released parts")),
    (f"{ARM}[supports]\n?", listed("## `[supports]`")),
    (f"{ARM}[contacts.a]\n?", listed("## `[contacts.NAME]`")),
    (f"{ARM}[[objects]]\n?", listed("## `[[objects]]`")),
    (f'{ARM}[[objects]]\nshapes = [{{ mesh = "a.stl", ? }}]', SHAPES),
    *(
        (f"{ARM}[[objects]]\nshapes = [{{ {shape} = {{ ? }} }}]", told(f"| `{shape}` |"))
        for shape in ("cylinder", "capsule", "sphere", "prism", "circle", "arc")
    ),
    (f"{ARM}[signals.a]\ninput = 1\n?", SIGNAL),
    *(
        (f'{ARM}[signals.a]\ninput = 1\nsensor = {{ kind = "{kind}", ? }}', SENSOR | SENSOR_ERRORS)
        for kind in KINDS_OF_SENSORS
    ),
    (f"{ARM}[classic]\n?", told("How task files of the classic form")),
]


def test_the_manual_names_every_kind_of_sensor() -> None:
    row = next(line for line in behind("### Sensors at tools").splitlines() if line.startswith("| `kind`"))
    assert {"distance", "force"} < set(KINDS_OF_SENSORS)
    assert set(re.findall(r'`"([^"`]*)"`', row)) == set(KINDS_OF_SENSORS)


@pytest.mark.parametrize(("text", "explained"), EXPLAINED, ids=[text for text, _ in EXPLAINED])
def test_every_key_that_is_known_in_a_section_is_explained_there(text: str, explained: set[str]) -> None:
    asked = asked_for(text)
    assert asked
    assert sorted(asked - explained) == []

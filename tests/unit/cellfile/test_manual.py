"""The manual of the cell file is true: its example is right and every key of the example is documented."""

import math
import re
import tomllib
from pathlib import Path

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import SourceText
from ropsim.model import Entity, NamedEntity

MANUAL = (Path(__file__).parents[3] / "docs" / "reference" / "cell-file.md").read_text("utf-8")
EXAMPLES = re.findall(r"```toml\n(.*?)```", MANUAL, flags=re.DOTALL)


def keys_of(value: object) -> set[str]:
    if isinstance(value, dict):
        return set(value) | {key for inner in value.values() for key in keys_of(inner)}
    if isinstance(value, list):
        return {key for inner in value for key in keys_of(inner)}
    return set()


@pytest.mark.parametrize("example", EXAMPLES)
def test_every_example_is_a_right_cell_file(example: str) -> None:
    cell, findings = read_cell(SourceText("cell.toml", example), "folder")
    assert findings == ()
    assert cell is not None


def test_the_examples_show_what_they_are_about() -> None:
    first, external, measured, chosen, own, stations, axis, devices, library, frames, pressed, sensing = (
        read_cell(SourceText("", one), "")[0] for one in EXAMPLES
    )
    assert first is not None
    assert len(first.parts) == 37
    assert external is not None
    assert external.first.robot.n == 8
    assert external.external["stock"].values == pytest.approx((1.2, math.pi / 2.0))
    assert measured is not None
    coordinate, pressure = measured.first.controller.sensors.sensors
    assert coordinate.step.tolist() == [math.pi / 2.0**15] * 2
    assert pressure.step.tolist() == [25e6 / 2.0**12] * 2
    assert (pressure.delay, pressure.noise.tolist()) == (1e-3, [1e4, 1e4])
    assert chosen is not None
    assert chosen.first.controller.built_in == (
        NamedEntity(Entity.INTERPOLATOR, "trapezoidal"),
        NamedEntity(Entity.JOINT_INTERPOLATOR, "linear"),
    )
    assert own is not None
    (entity,) = own.first.controller.entities
    assert (entity.entity, entity.file.path) == (Entity.PATH_PLANNER, "controllers/reduced.py")
    assert stations is not None
    assert list(stations.stations) == ["left", "right"]
    assert axis is not None
    assert [one.robot.has_arm for one in axis.stations.values()] == [False]
    assert devices is not None
    assert list(devices.devices) == ["belt", "door", "table"]
    assert library is not None
    assert library.first.tools["jaws"].mass == 0.7126
    assert library.first.default_tool == "jaws"
    assert list(library.devices) == ["belt"]
    assert pressed is not None
    (contact,) = pressed.contacts
    assert (contact.moving, contact.standing) == ("peg", ("block", "floor"))
    assert (contact.stiffness, contact.damping) == (2e5, 400.0)
    assert frames is not None
    assert frames.located == {"corner": "fixture"}
    assert sensing is not None
    assert all(signal.sensor is not None for signal in sensing.signals.values())


def test_the_keys_of_the_example_are_explained() -> None:
    names = {"jaws", "pallet", "infeed", "corner", "part_ready", "lamp"}
    keys = keys_of(tomllib.loads(EXAMPLES[0])) - names
    sections = MANUAL.replace(EXAMPLES[0], "")
    assert [key for key in sorted(keys) if f"`{key}`" not in sections and f"[{key}" not in sections] == []

"""The manual of NIROX: its example is right, and entities have the parameters that its table names."""

import re
import shlex
from pathlib import Path

import pytest

from ropsim.cli.testing import main
from ropsim.core import SourceText
from ropsim.nirox import ConformanceClass, nirox_schema, read_nirox
from support.manual import DOCS, blocks
from support.nirox_texts import TEXT

PAGE = DOCS / "reference" / "nirox.md"
LISTED = (
    "ROBOT_ARM",
    "ROBOT_FRAME",
    "RIGID_LINK_MASS_PROPERTIES",
    "COULOMB_VISCOUS_FRICTION",
    "DRIVE_TRAIN",
    "GEAR_TRANSMISSION",
    "JOINT_LIMITS",
    "AXIS_COORDINATE",
    "JOINT_COUPLING",
    "LOOP_CUT",
)
MANUAL = PAGE.read_text("utf-8")


def test_the_example_of_the_manual_is_a_robot_with_drives() -> None:
    (example,) = blocks(PAGE, "step")
    assert example.text == TEXT
    found = read_nirox(SourceText("two_links.stp", example.text))
    assert found.findings == ()
    assert found.conformance is ConformanceClass.CC4


def test_the_commands_of_the_manual_say_what_it_shows(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.chdir(tmp_path)
    (block,) = blocks(PAGE, "console")
    for example in block.text.split("$ ropsim ")[1:]:
        words, _, shown = example.partition("\n")
        assert main(shlex.split(words)) == 0
        assert capsys.readouterr().out.startswith(shown.rstrip("…\n"))


def test_the_table_of_the_manual_has_the_parameters_of_the_schema_in_their_order() -> None:
    for entity in LISTED:
        (row,) = re.findall(rf"^\| `{entity}` \| ([^|]+) \|", MANUAL, re.MULTILINE)
        told = re.findall(r"\b[a-z_0-9]+\b", re.sub(r"\([^)]*\)|\[[^]]*\]", "", row.partition(":")[0]))
        known = [one.attribute.name for one in nirox_schema().parameters[entity.lower()]]
        assert told == known


def test_the_manual_names_every_entity_that_nirox_adds() -> None:
    text = nirox_schema().entities
    added = list(text)[list(text).index("robot_arm") :]
    abstract = {name for name in added if text[name].abstract}
    assert [name for name in added if name not in abstract and f"`{name.upper()}`" not in MANUAL] == []

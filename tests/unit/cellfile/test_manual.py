"""The manual of the cell file is true: its example is right and every key of the example is documented."""

import re
import tomllib
from pathlib import Path

from ropsim.cellfile import read_cell
from ropsim.core import SourceText

MANUAL = (Path(__file__).parents[3] / "docs" / "reference" / "cell-file.md").read_text("utf-8")
EXAMPLES = re.findall(r"```toml\n(.*?)```", MANUAL, flags=re.DOTALL)


def keys_of(value: object) -> set[str]:
    if isinstance(value, dict):
        return set(value) | {key for inner in value.values() for key in keys_of(inner)}
    if isinstance(value, list):
        return {key for inner in value for key in keys_of(inner)}
    return set()


def test_the_example_is_a_right_cell_file() -> None:
    (example,) = EXAMPLES
    cell, findings = read_cell(SourceText("cell.toml", example), "folder")
    assert findings == ()
    assert cell is not None
    assert len(cell.parts) == 37


def test_every_key_that_the_reader_knows_stands_in_the_manual() -> None:
    asked: set[str] = set()
    for section in ("cell", "units", "robot", "controller", "tools.a", "locations.a", "signals.a", "classic"):
        text = f'[robot]\nmodel = "puma560"\n[{section}]\nqqqqqqqqqqqq = 1\n'
        if section == "robot":
            text = '[robot]\nmodel = "puma560"\nqqqqqqqqqqqq = 1\n'
        _, findings = read_cell(SourceText("cell.toml", text), "folder")
        for found in findings:
            if found.code == "X802":
                asked.update(re.findall(r"`(\w+)`", found.hint))
    for text in ("[[objects]]\n", "[[objects]]\nshapes = [{ zzzz = 1 }]\n", "[[parts]]\n", "[[supplies]]\n"):
        _, findings = read_cell(
            SourceText("cell.toml", f'[robot]\nmodel = "puma560"\n{text}qqqqqqqqqqqq = 1\n'), ""
        )
        for found in findings:
            if found.code == "X802":
                asked.update(re.findall(r"`(\w+)`", found.hint))
    assert {"kp", "speed_override", "gripper", "down", "changes", "size", "shapes", "grid", "arc"} <= asked
    assert [key for key in sorted(asked) if f"`{key}`" not in MANUAL] == []


def test_the_keys_of_the_example_are_explained() -> None:
    names = {"jaws", "pallet", "infeed", "corner", "part_ready", "lamp"}
    keys = keys_of(tomllib.loads(EXAMPLES[0])) - names
    sections = MANUAL.replace(EXAMPLES[0], "")
    assert [key for key in sorted(keys) if f"`{key}`" not in sections and f"[{key}" not in sections] == []

"""Bodies of the cell file: objects that hang on each other, and names that only one body may have."""

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Cell

ROBOT = '[robot]\nmodel = "puma560"\ntool = "jaws"\n[tools.jaws]\nposition = [0, 0, 100]\n'
PART = '[[parts]]\nname = "{0}"\nsize = [60, 60, 40]\nmass = 0.5\nposition = [0, 0, 40]\n'


def thing(name: str, parent: str = "", position: str = "[1, 2, 3]") -> str:
    hangs = f'parent = "{parent}"\n' if parent else ""
    return f'[[objects]]\nname = "{name}"\n{hangs}position = {position}\nsize = [10, 10, 10]\n'


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", ROBOT + text), "folder")


def test_an_object_is_given_in_the_frame_of_its_parent() -> None:
    cell, findings = read(thing("plate", "table", "[10, 20, 30]") + thing("table", "", "[500, 0, 700]"))
    assert findings == ()
    assert cell is not None
    plate, table = cell.objects
    assert (plate.parent, table.parent) == ("table", "")
    assert plate.X_PO.position == pytest.approx([0.01, 0.02, 0.03])


def test_a_parent_that_is_not_there_is_named_with_the_nearest() -> None:
    cell, (found,) = read(thing("table") + thing("plate", "tabel"))
    assert cell is None
    assert (found.code, found.message) == ("X809", "object `tabel` is not defined in this cell")
    assert "`table`" in found.hint
    assert found.span is not None
    assert found.span.line == 12


@pytest.mark.parametrize("names", [("a",), ("a", "b"), ("a", "b", "c")])
def test_objects_that_hang_on_each_other_in_a_ring_are_each_noted(names: tuple[str, ...]) -> None:
    above = (*names[1:], names[0])
    text = "".join(thing(name, parent) for name, parent in zip(names, above, strict=True))
    cell, findings = read(text + thing("free") + thing("rider", "a"))
    assert cell is None
    assert [found.code for found in findings] == ["X818"] * len(names)
    assert "`a` on " in findings[0].message
    assert [found.span.line for found in findings if found.span] == [8 + 5 * k for k in range(len(names))]


@pytest.mark.parametrize("name", ["base", "link1", "link6", "tool:jaws"])
@pytest.mark.parametrize("sort", ["object", "part"])
def test_the_names_of_the_bodies_of_the_robot_are_taken(name: str, sort: str) -> None:
    cell, (found,) = read(thing(name) if sort == "object" else PART.format(name))
    assert cell is None
    assert (found.code, found.message) == ("X810", f"the name `{name}` is taken")
    assert "robot" in found.hint


@pytest.mark.parametrize("text", [thing(""), PART.format(""), thing("") + thing("")])
def test_a_body_needs_a_name_that_is_not_empty(text: str) -> None:
    cell, findings = read(text)
    assert cell is None
    assert {(found.code, found.message.partition("name` ")[2]) for found in findings} == {
        ("X803", "is empty")
    }


def test_a_part_cannot_have_the_name_of_an_object() -> None:
    cell, (found,) = read(thing("tray") + PART.format("tray"))
    assert cell is None
    assert found.code == "X810"
    assert found.span is not None
    assert found.span.line == 11
    assert read(thing("link7") + PART.format("tray"))[1] == ()


def test_a_long_ring_is_told_in_short_and_a_long_chain_is_none() -> None:
    def thing(k: int, parent: str) -> str:
        return f'[[objects]]\nname = "o{k}"\nposition = [0, 0, 1]\nsize = [1, 1, 1]\n{parent}\n'

    chain = "".join(thing(k, f'parent = "o{k - 1}"' if k else "") for k in range(2000))
    cell, findings = read(chain)
    assert cell is not None
    assert findings == ()
    ring = "".join(thing(k, f'parent = "o{(k - 1) % 40}"') for k in range(40))
    _, findings = read(ring)
    assert [found.code for found in findings] == ["X818"] * 40
    assert findings[3].message.endswith(
        "`o3` on `o2` on `o1` on `o0` on `o39` on `o38` on `o37` on `o36` on … on `o3`"
    )

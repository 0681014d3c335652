"""Stations and devices in the cell file: what a right file means, and what a wrong one is answered."""

import math

import pytest

from ropsim.cellfile import read_cell
from ropsim.core import Diagnostic, SourceText
from ropsim.model import Barrier, BeltDrive, Cell, IndexDrive, SwitchDrive

ROBOT = '[robot]\nmodel = "puma560"\n'
SIGNALS = (
    "[signals.go]\noutput = 1\n[signals.there]\ninput = 1\n[signals.off]\ninput = 2\n[signals.level]\n"
    "input = 1\nanalog = true\n[signals.pulse]\ninput = 3\nchanges = [[1, true]]\n"
)
BELT = '[devices.belt]\nkind = "conveyor"\nlength = 1000\nwidth = 200\nspeed = 300\n'
MOVES = 'signal = "go"\nspeed = 90\nacceleration = 400\n'
DOOR = '[devices.door]\nkind = "slide"\nsize = [900, 30, 1200]\n' + MOVES
TABLE = '[devices.table]\nkind = "turntable"\ndiameter = 500\n' + MOVES


def read(text: str) -> tuple[Cell | None, tuple[Diagnostic, ...]]:
    return read_cell(SourceText("cell.toml", text), "folder")


def cell_of(text: str) -> Cell:
    cell, findings = read(ROBOT + text + SIGNALS)
    assert [str(found) for found in findings] == []
    assert cell is not None
    return cell


def findings_of(text: str) -> tuple[Diagnostic, ...]:
    cell, findings = read(text)
    assert (cell is None) == any(found.is_error for found in findings)
    return findings


def place(found: Diagnostic, text: str) -> str:
    """Return the marked characters."""
    assert found.span is not None
    line = text.split("\n")[found.span.line - 1]
    return line[found.span.column - 1 : found.span.end_column - 1]


def test_a_conveyor_runs_by_a_signal_and_stops_at_its_barrier() -> None:
    belt = cell_of(BELT + 'run = "go"\nstop = { at = 900, signal = "there" }\n').devices["belt"]
    assert belt.drive == BeltDrive(0.3, 1.0, "go", 1.0, Barrier(0.9, "there"))
    assert (belt.listens, belt.tells) == (("go",), ("there",))


def test_a_door_has_two_positions_and_a_table_steps() -> None:
    cell = cell_of(DOOR + 'on = 900\nis_on = "there"\nis_off = "off"\n' + TABLE + "step = 90\n")
    assert cell.devices["door"].drive == SwitchDrive("go", 0.0, 0.9, 0.09, 0.4, "off", "there")
    table = cell.devices["table"].drive
    assert isinstance(table, IndexDrive)
    assert (table.step, table.speed) == pytest.approx((math.pi / 2, math.pi / 2))


CASES = [
    pytest.param("[devices.a]\n", "X803", "[devices.a]", "needs `kind`", id="no kind"),
    pytest.param("[devices.a]\nkind = 'lift'\nlength = 3\n", "X808", "'lift'", "allowed are", id="lift"),
    pytest.param("[devices.a]\nkind = 3\n", "X804", "3", "needed is text", id="number for kind"),
    pytest.param("[devices]\na = 3\n", "X804", "3", "section `[devices.a]`", id="number for device"),
    pytest.param("devices = 3\n", "X804", "3", "needed is a section", id="number for devices"),
    pytest.param(BELT.replace("belt", "'my belt'"), "X816", "[devices.'my belt']", "", id="name"),
    pytest.param(BELT.replace("300", "inf"), "X807", "inf", "", id="infinitely fast"),
    pytest.param(BELT.replace("300", "nan"), "X807", "nan", "", id="nan"),
    pytest.param(BELT.replace("300", "0"), "X806", "0", "", id="a belt that stands"),
    pytest.param(BELT.replace("300", "1e9"), "X806", "1e9", "", id="a belt beyond all speed"),
    pytest.param(BELT.replace("length = 1000", "length = 0"), "X806", "0", "", id="no length"),
    pytest.param(
        BELT + "stop = { at = 1001, signal = 'there' }\n", "X806", "1001", "0 to 1000 mm", id="stop beyond"
    ),
    pytest.param(BELT + "stop = { at = 900 }\n", "X803", None, "needs `signal`", id="stop without signal"),
    pytest.param(BELT + "stop = 900\n", "X804", "900", "needed is a section", id="number for stop"),
    pytest.param(BELT + "run = 'went'\n", "X809", "'went'", "signal `went`", id="unknown signal"),
    pytest.param(BELT + "run = 'level'\n", "X809", "'level'", "analog", id="analog run"),
    pytest.param(
        BELT + "stop = { at = 1, signal = 'go' }\n", "X809", None, "no on/off input", id="output as barrier"
    ),
    pytest.param(BELT + "stop = { at = 1, signal = 'pulse' }\n", "X820", "'pulse'", "changes", id="changes"),
    pytest.param(
        BELT + "run = 'there'\nstop = { at = 1, signal = 'there' }\n",
        "X821", "'there'", "`belt` follows `belt`", id="follows itself",
    ),
    pytest.param(DOOR, "X803", "[devices.door]", "needs `on`", id="no position"),
    pytest.param(DOOR + "on = 1\nstep = 3\n", "X812", "on", "`step` both say", id="on and step"),
    pytest.param(DOOR + "step = 0\n", "X806", "0", "never move", id="no step"),
    pytest.param(DOOR.replace('"go"', '""') + "on = 1\n", "X803", '""', "never move", id="empty signal"),
    pytest.param(
        DOOR + "on = 1\nis_on = 'there'\nis_off = 'there'\n",
        "X820", "'there'", "for something else", id="on and off at once",
    ),
    pytest.param(DOOR + "on = 1\nis_on = 'level'\n", "X809", "'level'", "no on/off input", id="analog is_on"),
    pytest.param(DOOR + "on = 1\ndiameter = 3\n", "X812", "diameter", "looks like", id="two looks"),
    pytest.param(DOOR.replace("size", "sizes") + "on = 1\n", "X802", "sizes", "no meaning", id="misspelt"),
    pytest.param(TABLE + "step = 9000\n", "X806", "9000", "", id="25 turns"),
    pytest.param(
        DOOR + "on = 1\nis_on = 'there'\n" + TABLE + "on = 1\nis_on = 'there'\n",
        "X820", "'there'", "device `door`", id="two devices set one input",
    ),
    pytest.param(
        DOOR.replace('"go"', '"off"') + "on = 1\nis_on = 'there'\n"
        + TABLE.replace('"go"', '"there"') + "on = 1\nis_on = 'off'\n",
        "X821", '"off"', "`door` follows `table` follows `door`", id="two in a circle",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("text", "code", "marked", "words"), CASES)
def test_each_mistake_of_a_device_gets_one_finding_at_its_place(
    text: str, code: str, marked: str | None, words: str
) -> None:
    whole = (text + ROBOT if text.startswith("devices") else ROBOT + text) + SIGNALS
    (found,) = findings_of(whole)
    assert (found.code, words in found.message) == (code, True), found.message
    if marked is not None:
        assert place(found, whole) == marked


def test_a_chain_of_devices_that_is_no_circle_is_right() -> None:
    chain = (
        DOOR + 'on = 900\nis_on = "there"\n'
        + TABLE.replace('"go"', '"there"') + 'on = 90\nis_on = "off"\n'
        + BELT + 'run = "off"\n'
    )  # fmt: skip
    assert list(cell_of(chain).devices) == ["door", "table", "belt"]


STATIONS = [
    pytest.param("", "X803", "add `robot`", id="nothing"),
    pytest.param("[stations]\n", "X803", "add `robot`", id="no station"),
    pytest.param("stations = 3\n", "X804", "", id="number for stations"),
    pytest.param("[stations]\na = 3\n", "X804", "", id="number for a station"),
    pytest.param("[stations.a]\n", "X803", "add `robot`", id="no robot"),
    pytest.param("[stations.a]\nrobot = 'puma'\n", "X860", "did you mean", id="unknown robot"),
    pytest.param("[stations.a]\nrobot = 3\n", "X804", "", id="number for robot"),
    pytest.param(ROBOT + "[stations.robot]\nrobot = 'scara'\n", "X810", "another name", id="robot twice"),
    pytest.param("[stations.a]\nrobot = 'scara'\nprogram = 3\n", "X804", "", id="number for program"),
    pytest.param("[stations.a]\nrobot = 'scara'\ntool = 'jaws'\n", "X809", "none", id="unknown tool"),
    pytest.param("[stations.a]\nrobot = 'scara'\ntools = ['jaws']\n", "X809", "none", id="unknown tools"),
    pytest.param("[stations.a]\nrobot = 'scara'\ntools = 3\n", "X804", "", id="number for tools"),
    pytest.param(
        "[tools.pen]\nposition = [0, 0, 9]\n[stations.a]\nrobot = 'scara'\ntools = []\ntool = 'pen'\n",
        "X809",
        "add it to `tools`",
        id="tool that it does not have",
    ),
    pytest.param("[stations.a]\nrobot = 'scara'\n[controller]\n", "X802", "", id="controller of nobody"),
    pytest.param("[stations.a]\nrobot = 'scara'\nmodel = 'scara'\n", "X802", "", id="model"),
    pytest.param(
        "[stations.a]\nrobot = 'scara'\n" + BELT.replace("belt", "a"), "X810", "another name", id="device"
    ),
]


@pytest.mark.parametrize(("text", "code", "hint"), STATIONS)
def test_each_mistake_of_a_station_gets_one_finding(text: str, code: str, hint: str) -> None:
    (found,) = findings_of(text)
    assert found.code == code
    assert hint in found.hint
    assert found.span is not None


@pytest.mark.parametrize("name", ["left", "left/base", "left/link6", "left/tool:pen", "belt", "belt/link1"])
@pytest.mark.parametrize("sort", ["part", "object"])
def test_names_of_stations_devices_and_their_bodies_are_taken(name: str, sort: str) -> None:
    head = (
        '[tools.pen]\nposition = [0, 0, 9]\n[stations.left]\nrobot = "puma560"\ntool = "pen"\n'
        + BELT + SIGNALS
    )  # fmt: skip
    mass = "mass = 1\n" if sort == "part" else ""
    thing = f'[[{sort}s]]\nname = "{name}"\nsize = [9, 9, 9]\nposition = [0, 0, 9]\n{mass}'
    (found,) = findings_of(head + thing)
    assert (found.code, found.message) == ("X810", f"the name `{name}` is taken")
    assert "of this cell has it" in found.hint or "a body of " in found.hint

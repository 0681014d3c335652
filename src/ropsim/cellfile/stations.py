"""The stations of a cell file: `[robot]`, the short form of one, and `[stations.NAME]`."""

from collections.abc import Mapping

from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.poses import read_base
from ropsim.cellfile.quantity import Units
from ropsim.cellfile.robot import read_robot
from ropsim.cellfile.tomltext.checks import TomlTable
from ropsim.model import ROBOT, Station, Tool


def read_stations(root: TomlTable, tools: Mapping[str, Tool], units: Units) -> dict[str, Station | None]:
    """Return the stations by name, None for one whose robot is missing or unknown.

    Args:
        root: the file.
        tools: of the cell, by name.
        units: of the file.
    """
    tables = root.named("stations")
    stations: dict[str, Station | None] = {}
    told = not isinstance(root.values.get("stations", {}), dict)  # that they are no section
    if "robot" in root or not (tables or told):
        root.require("robot")
        stations[ROBOT] = _short(root, tools, units)
    for name, table in tables.items():
        if name in stations:
            message = f"`{name}` is the name of the station that `[robot]` describes"
            hint = "give the station another name, or describe all of them under `[stations]`"
            root.findings.add(kinds.DUPLICATE_CELL_NAME, table.findings.places.key(table.path), message, hint)
        stations[name] = _long(name, table, tools, units)
    return stations


def _short(root: TomlTable, tools: Mapping[str, Tool], units: Units) -> Station | None:
    table = root.table("robot")
    X_WB = read_base(table, units)
    tool = table.reference("tool", tools, "tool")
    section = read_robot(table, "model", root.table("controller"), X_WB, units)
    program = root.table("cell").text("program", "main")
    if section is None:
        return None
    return Station(ROBOT, section.model, section.controller, X_WB, tools, tool, section.start, program)


def _long(name: str, table: TomlTable, tools: Mapping[str, Tool], units: Units) -> Station | None:
    X_WB = read_base(table, units)
    tool = table.reference("tool", tools, "tool")
    own = _tools(table, tool, tools)
    program = table.text("program", name)
    section = read_robot(table, "robot", table.table("controller"), X_WB, units)
    if section is None:
        return None
    return Station(name, section.model, section.controller, X_WB, own, tool, section.start, program)


def _tools(table: TomlTable, tool: str, tools: Mapping[str, Tool]) -> dict[str, Tool]:
    """Return the tools of a station: those of the key `tools`, else the one it begins with."""
    if "tools" not in table:
        return {tool: tools[tool]} if tool else {}
    value = table.values["tools"]
    if not isinstance(value, list) or not all(isinstance(one, str) for one in value):
        table.wrong_type(("tools",), value, "a list of names of tools")
        return {}
    own = {}
    for k, one in enumerate(value):
        if one in tools:
            own[one] = tools[one]
        else:
            known = ", ".join(f"`{each}`" for each in sorted(tools)) or "none"
            message = f"tool `{one[:60]}` is not defined in this cell"
            hint = f"tools of this cell: {known}"
            table.findings.add(kinds.UNKNOWN_CELL_NAME, table.value_span("tools", k), message, hint)
    if tool and tool not in own:
        message = f"`{tool}` is in force at the start, but not among `tools`"
        table.findings.add(kinds.UNKNOWN_CELL_NAME, table.value_span("tool"), message, "add it to `tools`")
    return own

"""The stations of a cell file: `[robot]`, the short form of one, and `[stations.NAME]`."""

from collections.abc import Mapping

from ropsim import robots
from ropsim.cellfile import diagnostics as kinds
from ropsim.cellfile.devices.body_shapes import read_body_shapes
from ropsim.cellfile.poses import read_base
from ropsim.cellfile.robots.robot import RobotSection, read_driven, read_robot
from ropsim.cellfile.robots.robot_files import RobotLibrary
from ropsim.model import ROBOT, JointType, RobotModel, Station, Tool
from ropsim.spatial import Pose
from ropsim.tomltext import (
    CONFLICTING_KEYS,
    MASS,
    MOMENT,
    UNKNOWN_CELL_NAME,
    VALUE_OUT_OF_RANGE,
    Question,
    Sort,
    TomlTable,
    Units,
    read_kind,
)

KINDS = ("slide", "turntable")
_LIGHTEST = 0.1  # [kg]
_LEAST_INERTIA = 1e-3  # [kg·m²]


def read_stations(
    root: TomlTable, tools: Mapping[str, Tool], library: RobotLibrary, units: Units
) -> dict[str, Station | None]:
    """Return the stations by name, None for one whose robot is missing or unknown.

    Args:
        root: the file.
        tools: of the cell, by name.
        library: the robots that it can name.
        units: of the file.
    """
    tables = root.named("stations")
    stations: dict[str, Station | None] = {}
    is_reported = not isinstance(root.values.get("stations", {}), dict)  # that they are no section
    if "robot" in root or not (tables or is_reported):
        root.require("robot")
        stations[ROBOT] = _short(root, tools, library, units)
    for name, table in tables.items():
        if name in stations:
            message = f"`{name}` is the name of the station that `[robot]` describes"
            hint = "give the station another name, or describe all of them under `[stations]`"
            root.findings.add(kinds.DUPLICATE_CELL_NAME, table.findings.places.key(table.path), message, hint)
        stations[name] = _long(name, table, tools, library, units)
    _check_serving(tables, stations)
    return stations


def _check_serving(tables: Mapping[str, TomlTable], stations: Mapping[str, Station | None]) -> None:
    """Note where all programs of a cell serve: there is none that they could serve."""
    working = any(one is None or (one.program and not one.serves) for one in stations.values())
    serving = [name for name, one in stations.items() if one is not None and one.serves]
    if working or not serving:
        return
    names = ", ".join(f"`{name}`" for name in serving)
    message = f"{names} would serve other stations, but no other one of this cell has a program"
    hint = "take `serves` away from the station whose program says when the work is done"
    table = tables[serving[0]]
    table.findings.add(kinds.NOBODY_TO_SERVE, table.key_span("serves"), message, hint)


def _short(root: TomlTable, tools: Mapping[str, Tool], library: RobotLibrary, units: Units) -> Station | None:
    table = root.table("robot")
    X_WB = read_base(table, units)
    tool = table.reference("tool", tools, "tool")
    section = read_robot(table, library.arm(table, "model"), root.table("controller"), X_WB, units)
    program = root.table("cell").text("program", "main")
    if section is None:
        return None
    return Station(ROBOT, section.model, section.controller, X_WB, tools, tool, section.start, program)


def _long(
    name: str, table: TomlTable, tools: Mapping[str, Tool], library: RobotLibrary, units: Units
) -> Station | None:
    X_WB = read_base(table, units)
    tool = table.reference("tool", tools, "tool")
    own = _tools(table, tool, tools)
    program, serves = table.text("program", name), table.flag("serves", default=False)
    settings = table.table("controller")
    if "mechanism" in table:
        section = _one_axis(table, settings, X_WB, units)
    else:
        section = read_robot(table, library.arm(table, "robot"), settings, X_WB, units)
    if section is None:
        return None
    return Station(name, section.model, section.controller, X_WB, own, tool, section.start, program, serves)


def _one_axis(table: TomlTable, settings: TomlTable, X_WB: Pose, units: Units) -> RobotSection | None:
    """Return the section of a station that has a mechanism of one axis in place of a robot."""
    if "robot" in table:
        message = f"`{table.name_of('robot')}` and `mechanism` both say what the station moves"
        table.text("robot", "")
        table.findings.add(CONFLICTING_KEYS, table.key_span("robot"), message, "keep one of them")
    return read_driven(table, read_mechanism(table.table("mechanism"), units), settings, X_WB, units)


def _tools(table: TomlTable, tool: str, tools: Mapping[str, Tool]) -> dict[str, Tool]:
    """Return the tools of a station: from the key `tools`, else its initial tool."""
    table.ask("tools", Question(Sort.TEXTS, names="tool"))
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
            table.findings.add(UNKNOWN_CELL_NAME, table.value_span("tools", k), message, hint)
    if tool and tool not in own:
        message = f"`{tool}` is in force at the start, but not among `tools`"
        table.findings.add(UNKNOWN_CELL_NAME, table.value_span("tool"), message, "add it to `tools`")
    return own


def read_mechanism(table: TomlTable, units: Units) -> RobotModel | None:
    """Return the robot of one axis that a table describes; None where its kind is missing or unknown.

    Args:
        table: `mechanism` of a station.
        units: of the file.
    """
    kind = read_kind(table, KINDS)
    if not kind:
        return None
    slides = kind == "slide"
    type_ = JointType.PRISMATIC if slides else JointType.REVOLUTE
    load = "mass" if slides else "inertia"
    table.require("low", "high", "speed", "acceleration", load)
    way = units.position if slides else units.turn
    low, high = table.number("low", way, 0.0), table.number("high", way, 1.0)
    speed = table.number("speed", units.rate(type_, 1), 1.0)
    acceleration = table.number("acceleration", units.rate(type_, 2), 1.0)
    quantity = MASS.within(_LIGHTEST, MASS.high) if slides else MOMENT.within(_LEAST_INERTIA, MOMENT.high)
    axis = robots.AxisData(low, high, speed, acceleration, table.number(load, quantity, 1.0))
    shapes = read_body_shapes(table, units)
    table.finish()
    if {"low", "high"} <= set(table.values) and not low < high:
        message = f"`{table.name_of('high')}` is not above `low`: the axis could not move"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("high"), message)
        return None
    return (robots.driven_slide if slides else robots.driven_rotary)(shapes, axis)

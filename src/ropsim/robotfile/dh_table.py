"""The rows of `joints`: a Denavit–Hartenberg table with the limits of its joints."""

from dataclasses import replace
from math import pi, tau

from ropsim.core import frozen_dataclass
from ropsim.model import (
    WITHOUT_END,
    CoupledAxis,
    DhRow,
    Joint,
    JointLimits,
    JointType,
    fixed_part,
    interface_from_dh,
    joints_from_dh,
    joints_from_modified_dh,
)
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.coupled_rows import read_coupled_rows
from ropsim.spatial import Pose
from ropsim.tomltext import MOMENT, VALUE_OUT_OF_RANGE, Quantity, TomlTable, Units, note_radians

MOST_JOINTS = 32

SPEEDS = {JointType.REVOLUTE: pi / 2.0, JointType.PRISMATIC: 0.25}
"""Estimated speed if a row states no speed [rad/s | m/s]."""
TO_FULL_SPEED = 0.25
"""Estimated acceleration: full speed is reached in this time [s]."""
RISE = 10.0
"""Estimated jerk over acceleration [1/s]."""

ENDLESS = "endless"
"""Limits of a joint that turns without end."""

EFFORT = MOMENT.within(1e-6, 1e7)
_TURNS = Quantity("turns", 1.0, -WITHOUT_END / tau, WITHOUT_END / tau)


@frozen_dataclass
class DhTable:
    """Contents of the rows.

    Attributes:
        convention: `standard` or `modified`.
        rows: of the table.
        X_B0: frame 0 of the table in the base frame.
        joints: of the arm, in the base frame.
        coupled: axes that move their joints together with others.
        estimated: which of speeds, accelerations and jerks are estimates for some joint.
    """

    convention: str
    rows: tuple[DhRow, ...]
    X_B0: Pose
    joints: tuple[Joint, ...]
    coupled: tuple[CoupledAxis, ...]
    estimated: tuple[str, ...]

    def frame(self, number: int) -> Pose:
        """Return frame i of the table in the frame of joint i, for i from 0."""
        if self.convention == "modified":
            return Pose()
        return Pose.from_matrix(fixed_part(self.rows[number]))

    def carrier(self, number: int) -> Pose:
        """Return frame i - 1 of the table in the frame of the carrier (base, joint) of joint i, i from 0."""
        return self.frame(number - 1) if number else self.X_B0

    @property
    def interface(self) -> Pose:
        """Return the last frame of the table in the frame of the last joint."""
        return Pose() if self.convention == "modified" else interface_from_dh(self.rows)


def read_dh_table(root: TomlTable, convention: str, units: Units, X_B0: Pose) -> DhTable | None:
    """Return the joints of a file; None without any, or too many.

    Args:
        root: the file.
        convention: `standard` or `modified`.
        units: of the file.
        X_B0: frame 0 of the table in the base frame.
    """
    tables = root.tables("joints")
    if not 1 <= len(tables) <= MOST_JOINTS:
        if isinstance(root.values.get("joints", []), list):
            found = f"`joints` has {len(tables)} rows" if "joints" in root else "there are no `joints`"
            root.findings.add(
                kinds.NO_JOINTS,
                root.value_span("joints"),
                f"{found}, an arm has 1 to {MOST_JOINTS}",
                "give a row for each joint",
            )
        return None
    guessed: dict[str, None] = {}
    read = [_row(table, units, guessed) for table in tables]
    rows, limits = tuple(row for row, _ in read), tuple(limit for _, limit in read)
    make = joints_from_modified_dh if convention == "modified" else joints_from_dh
    names = names_of(tables)
    joints = tuple(
        replace(joint, name=name) for joint, name in zip(make(rows, limits, X_B0), names, strict=True)
    )
    coupled = read_coupled_rows(tables, joints, units)
    for table in tables:
        table.finish()
    return DhTable(convention, rows, X_B0, joints, coupled, tuple(guessed))


def _row(table: TomlTable, units: Units, guessed: dict[str, None]) -> tuple[DhRow, JointLimits]:
    type_ = JointType(table.choice("type", ("revolute", "prismatic"), "revolute"))
    for key in ("alpha", "theta"):
        note_radians(table, key, units)
    a, d = (table.number(key, units.position, 0.0) for key in ("a", "d"))
    alpha, theta = (table.number(key, units.turn, 0.0) for key in ("alpha", "theta"))
    return DhRow(a, alpha, d, theta, type_), read_limits(table, type_, units, guessed)


def read_limits(table: TomlTable, type_: JointType, units: Units, guessed: dict[str, None]) -> JointLimits:
    """Return the limits of an axis; the words of those that are estimates are added to `guessed`."""
    table.require("limits")
    lower, upper = read_bounds(table, type_, units)
    for key, words in (("speed", "speeds"), ("acceleration", "accelerations"), ("jerk", "jerks")):
        if table.present and key not in table:
            guessed[words] = None
    speed = table.number("speed", units.rate(type_, 1), SPEEDS[type_])
    fastest = units.rate(type_, 2).high
    acceleration = table.number("acceleration", units.rate(type_, 2), min(speed / TO_FULL_SPEED, fastest))
    jerk = table.number("jerk", units.rate(type_, 3), min(RISE * acceleration, units.rate(type_, 3).high))
    effort = table.number("effort", EFFORT, float("inf"))
    return JointLimits(lower, upper, speed, acceleration, jerk, effort)


def read_bounds(table: TomlTable, type_: JointType, units: Units) -> tuple[float, float]:
    """Return the `limits` of a coordinate that turns (REVOLUTE) or slides [rad | m]."""
    way = units.turn if type_ is JointType.REVOLUTE else units.position
    return _wide_range(table, type_) or _range(table, "limits", way)


def _wide_range(table: TomlTable, type_: JointType) -> tuple[float, float] | None:
    """Return the limits of a joint that turns without end, or many times [rad]; None where it has others."""
    value = table.values.get("limits")
    if type_ is not JointType.REVOLUTE or not isinstance(value, str | dict):
        return None
    if isinstance(value, str):
        table.choice("limits", (ENDLESS,), ENDLESS)
        return -WITHOUT_END, WITHOUT_END
    inner = table.table("limits")
    inner.require("turns")
    lower, upper = _range(inner, "turns", _TURNS)
    inner.finish()
    return lower * tau, upper * tau


def _range(table: TomlTable, key: str, way: Quantity) -> tuple[float, float]:
    """Return two numbers of a list, in SI units, the lower one first."""
    noted = len(table.findings.items)
    lower, upper = table.numbers(key, 2, way, (0.0, 1.0))
    if lower < upper:
        return lower, upper
    if len(table.findings.items) == noted:  # no second complaint about stand-ins
        first, last = (way.show(value / way.scale) for value in (lower, upper))
        message = f"`{table.name_of(key)}` goes from {first} to {last}, allowed is a lower number first"
        table.findings.add(VALUE_OUT_OF_RANGE, table.value_span(key), message)
    return 0.0, 1.0


def names_of(tables: tuple[TomlTable, ...]) -> list[str]:
    """Return the names of the joints, with duplicates noted."""
    names: list[str] = []
    for number, table in enumerate(tables, start=1):
        name = table.text("name", str(number)) or str(number)
        if name in names:
            message = f"two joints are called `{name[:60]}`"
            span = table.value_span("name") if "name" in table else table.findings.places.key(table.path)
            table.findings.add(kinds.JOINT_NAME_TWICE, span, message, "give each a name of its own")
        names.append(name)
    return names

"""The rows of `joints` in a file of frames: where each joint stands, on which link, and how it moves."""

from collections.abc import Mapping, Sequence
from math import inf

from ropsim.core import frozen_dataclass, near
from ropsim.model import BASE_LINK, Coupling, Joint, JointLimits, JointType, first_coordinates
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.dh_table import EFFORT, MOST_JOINTS, names_of, read_bounds, read_limits
from ropsim.robotfile.frames.words import BASE, TYPES, coordinate_kinds
from ropsim.tomltext import NUMBER, TomlTable, Units, cut, read_pose

MOST_FRAMES = 4 * MOST_JOINTS
_LEAD = NUMBER.within(-1e3, 1e3)
_FACTOR = NUMBER.within(-1e6, 1e6)
_SINGLE = (JointType.REVOLUTE, JointType.PRISMATIC, JointType.SCREW)


@frozen_dataclass
class FrameRows:
    """Contents of the rows.

    Attributes:
        joints: of the robot.
        axes: numbers of the driven ones, in their order.
        couplings: coordinates that follow others.
        estimated: which of speeds, accelerations and jerks are estimates for some axis.
    """

    joints: tuple[Joint, ...]
    axes: tuple[int, ...]
    couplings: tuple[Coupling, ...]
    estimated: tuple[str, ...]

    @property
    def places(self) -> dict[str, int]:
        """Return the number of each link by the name of its joint, and that of the base."""
        return {BASE: BASE_LINK} | {joint.name: number for number, joint in enumerate(self.joints)}


def read_frame_rows(root: TomlTable, units: Units) -> FrameRows | None:
    """Return the joints of a file of frames; None without any, or too many.

    Args:
        root: the file, with the keys `joints` and `axes`.
        units: of the file.
    """
    tables = root.tables("joints")
    if not 1 <= len(tables) <= MOST_FRAMES:
        message = f"`joints` has {len(tables)} rows, a robot has 1 to {MOST_FRAMES}"
        root.findings.add(kinds.NO_JOINTS, root.value_span("joints"), message, "give a row for each joint")
        return None
    names, guessed = names_of(tables), dict[str, None]()
    types = [JointType(table.choice("type", TYPES, "revolute")) for table in tables]
    follow = [table.table("follows") for table in tables]
    axes = _axes(root, names, types, [one.present for one in follow])
    joints = tuple(
        _joint(table, (number, type_), names, axes, units, guessed)
        for number, (table, type_) in enumerate(zip(tables, types, strict=True))
    )
    couplings = _couplings(tables, follow, joints)
    for table in (*tables, *(one for one in follow if one.present)):
        table.finish()
    return FrameRows(joints, axes, couplings, tuple(guessed))


def _axes(
    root: TomlTable, names: Sequence[str], types: Sequence[JointType], follows: Sequence[bool]
) -> tuple[int, ...]:
    """Return the driven joints: those that the file names, else all of one freedom that follow none."""
    free = tuple(
        number
        for number, (type_, behind) in enumerate(zip(types, follows, strict=True))
        if type_ in _SINGLE and not behind
    )
    if "axes" not in root:
        return free
    value = root.values["axes"]
    if not isinstance(value, list) or not all(isinstance(one, str) for one in value):
        root.wrong_type(("axes",), value, "a list of names of joints")
        return free
    known = {names[number]: number for number in free}
    found = []
    for place, name in enumerate(value):
        if name in known and known[name] not in found:
            found.append(known[name])
            continue
        _unknown(root, ("axes", place), f"axis `{cut(str(name))}`", str(name), known)
    return tuple(found) or free


def _unknown(
    table: TomlTable, steps: tuple[str | int, ...], words: str, name: str, known: Mapping[str, int]
) -> None:
    close = near(name, known, limit=1)
    listed = ", ".join(f"`{cut(one)}`" for one in list(known)[:12]) or "none"
    hint = f"did you mean `{close[0]}`?" if close else ""
    message = f"{words} is not to be had here, allowed are {listed}"
    table.findings.add(kinds.BAD_BODY_NAME, table.value_span(*steps), message, hint)


def link_named(table: TomlTable, key: str, known: Mapping[str, int], default: int) -> int:
    """Return the number of a link by the name of its joint, or of the base; noted where it is none."""
    if key not in table:
        return default
    name = table.text(key, BASE)
    if name in known:
        return known[name]
    _unknown(table, (key,), f"body `{cut(name)}`", name, known)
    return default


def _joint(
    table: TomlTable,
    which: tuple[int, JointType],
    names: Sequence[str],
    axes: Sequence[int],
    units: Units,
    guessed: dict[str, None],
) -> Joint:
    number, type_ = which
    known = {BASE: BASE_LINK} | {name: place for place, name in enumerate(names[:number])}
    parent = link_named(table, "on", known, number - 1)
    placement = read_pose(table, units)
    measure = coordinate_kinds(type_)[0] if type_.freedoms else JointType.REVOLUTE
    offset = table.number("offset", units.turn if measure is JointType.REVOLUTE else units.position, 0.0)
    lead = 0.0
    if type_ is JointType.SCREW:
        table.require("lead")
        lead = table.number("lead", units.position, 1.0)
    read = read_limits if number in axes else _passive_limits
    limits = read(table, measure, units, guessed)
    return Joint(
        names[number],
        type_,
        placement,
        offset,
        limits.lower,
        limits.upper,
        limits.max_speed,
        limits.max_acceleration,
        limits.max_jerk,
        limits.max_effort,
        parent,
        lead,
    )


def _passive_limits(
    table: TomlTable, type_: JointType, units: Units, guessed: dict[str, None]
) -> JointLimits:
    """Return the limits of a joint that is no axis: only what the row says."""
    del guessed
    lower, upper = read_bounds(table, type_, units) if "limits" in table else (-inf, inf)
    speed, acceleration, jerk = (
        table.number(key, units.rate(type_, order), inf) if key in table else inf
        for order, key in enumerate(("speed", "acceleration", "jerk"), start=1)
    )
    effort = table.number("effort", EFFORT, inf) if "effort" in table else inf
    return JointLimits(lower, upper, speed, acceleration, jerk, effort)


def _couplings(
    tables: Sequence[TomlTable], follow: Sequence[TomlTable], joints: Sequence[Joint]
) -> tuple[Coupling, ...]:
    """Return the joints of one freedom that follow others of one freedom."""
    first, found = first_coordinates(tuple(joints)), []
    known = {one.name: number for number, one in enumerate(joints) if one.type in _SINGLE}
    for number, (table, given) in enumerate(zip(tables, follow, strict=True)):
        constant = table.number("follows_from", NUMBER, 0.0) if "follows_from" in table else 0.0
        if not given.present:
            continue
        terms = []
        for name in given.values:
            factor = given.number(name, _FACTOR, 1.0)
            if name in known and joints[number].type in _SINGLE:
                terms.append((first[known[name]], factor))
            else:
                _unknown(given, (name,), f"joint `{cut(name)}` to follow", name, known)
        found.append(Coupling(first[number], tuple(terms), constant))
    return tuple(found)

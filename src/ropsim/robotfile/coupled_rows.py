"""The keys `coupled` and `joint_limits` of rows: axes that move their joints together with others."""

from collections.abc import Sequence
from math import inf

from ropsim.core import near
from ropsim.model import CoupledAxis, Joint, JointType
from ropsim.robotfile.diagnostics import BAD_COUPLED_ROW
from ropsim.tomltext import VALUE_OUT_OF_RANGE, Quantity, TomlTable, Units, cut

_FACTOR = Quantity("", 1.0, -10.0, 10.0)


def read_coupled_rows(
    tables: Sequence[TomlTable], joints: Sequence[Joint], units: Units
) -> tuple[CoupledAxis, ...]:
    """Return the axes of rows that have `coupled`, in the order of the rows.

    Args:
        tables: rows of `joints`.
        joints: that they describe, with the limits of the axes.
        units: of the file.
    """
    found = []
    for number, table in enumerate(tables):
        given = table.table("coupled")
        others = _others(given, joints, number) if given.present else ()
        limits = _limits(table, joints[number], units)
        if others:
            found.append(CoupledAxis(number, others, *limits))
        elif "joint_limits" in table and not given.present:
            table.findings.add(
                BAD_COUPLED_ROW,
                table.key_span("joint_limits"),
                f"joint `{cut(joints[number].name)}` has `joint_limits` and is not `coupled`",
                "its `limits` are those of the joint",
            )
    return tuple(found)


def _others(given: TomlTable, joints: Sequence[Joint], number: int) -> tuple[tuple[int, float], ...]:
    """Return the numbers of the joints that a row names, with their factors."""
    own, places = joints[number], {joint.name: place for place, joint in enumerate(joints)}
    known = [one.name for one in joints[:number] if one.type is own.type]
    allowed = ", ".join(f"`{cut(name)}`" for name in known) or "none"
    found = []
    for name in given.values:
        factor = given.number(name, _FACTOR, 1.0)
        if name in known:
            found.append((places[name], factor))
            continue
        close = near(name, known, limit=1)
        given.findings.add(
            BAD_COUPLED_ROW,
            given.key_span(name),
            f"joint `{cut(own.name)}` is coupled with `{cut(name)}`, allowed are joints before it that "
            f"move as it does: {allowed}",
            f"did you mean `{close[0]}`?" if close else "",
        )
    return tuple(found)


def _limits(table: TomlTable, joint: Joint, units: Units) -> tuple[float, float]:
    """Return the limits of the joint itself [rad | m]."""
    way = units.turn if joint.type is JointType.REVOLUTE else units.position
    if "joint_limits" not in table:
        return -inf, inf
    lower, upper = table.numbers("joint_limits", 2, way, (-way.high, way.high))
    if lower < upper:
        return lower, upper
    first, last = (way.show(value / way.scale) for value in (lower, upper))
    message = (
        f"`{table.name_of('joint_limits')}` goes from {first} to {last}, allowed is a lower number first"
    )
    table.findings.add(VALUE_OUT_OF_RANGE, table.value_span("joint_limits"), message)
    return -inf, inf

"""Where the numbers of a robot file come from, as the file says, and which of them are estimates."""

from collections.abc import Sequence

from ropsim.model import OriginKind, ParameterOrigin
from ropsim.robotfile.dh_table import RISE, SPEEDS, TO_FULL_SPEED, DhTable
from ropsim.robotfile.estimation.link_masses import DENSITY
from ropsim.robotfile.links import Links
from ropsim.tomltext import TomlTable

_KINDS = tuple(kind.value for kind in OriginKind)
_RULE = f"shares of the mass of the arm by its class, as cylinders of {DENSITY:g} kg/m³ from joint to joint"


def read_origins(root: TomlTable, name: str) -> tuple[ParameterOrigin, ...]:
    """Return the contents of the keys `source` and `origins`.

    Args:
        root: the file.
        name: of the file, which is the source where none is given.
    """
    source = root.text("source", "")
    rows = root.tables("origins")
    given = [_origin(row) for row in rows]
    whole = "all other numbers of its file" if rows else "all numbers of its file"
    if source:
        return (*given, ParameterOrigin(whole, OriginKind.PUBLISHED, source))
    return (
        tuple(given)
        if given
        else (ParameterOrigin(whole, OriginKind.DERIVED, f"as in {name}; it names no source"),)
    )


def estimates(table: DhTable, links: Links) -> tuple[ParameterOrigin, ...]:
    """Return the groups of parameters that rules of the reader have made, with these rules."""
    found = []
    if table.estimated:
        found.append(
            ParameterOrigin(f"joint {_and(table.estimated)}", OriginKind.ESTIMATED, _limits_rule(table))
        )
    if links.estimated and links.has_mass:
        found.append(ParameterOrigin(_and(links.estimated), OriginKind.ESTIMATED, _RULE))
    return tuple(found)


def _origin(table: TomlTable) -> ParameterOrigin:
    table.require("parameters", "kind", "source")
    origin = ParameterOrigin(
        table.text("parameters", ""),
        OriginKind(table.choice("kind", _KINDS, "derived")),
        table.text("source", ""),
    )
    table.finish()
    return origin


def _limits_rule(table: DhTable) -> str:
    parts = []
    if "speeds" in table.estimated:
        turning, sliding = SPEEDS.values()
        parts.append(f"where none is given {turning:.3g} rad/s, {sliding:.3g} m/s")
    if "accelerations" in table.estimated:
        parts.append(f"full speed within {TO_FULL_SPEED:g} s")
    if "jerks" in table.estimated:
        parts.append(f"full acceleration within {1.0 / RISE:g} s")
    return "; ".join(parts)


def _and(words: Sequence[str]) -> str:
    return f"{', '.join(words[:-1])} and {words[-1]}" if len(words) > 1 else words[0]

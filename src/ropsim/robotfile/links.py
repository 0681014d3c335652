"""The rows of `links`: masses, centres of mass, inertias and looks of the link of each joint."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from ropsim.core import frozen_dataclass
from ropsim.model import ArmClass, Link, snapped
from ropsim.robotfile import diagnostics as kinds
from ropsim.robotfile.dh_table import DhTable
from ropsim.robotfile.estimation.link_masses import LinkMasses, bodies, link_masses, link_masses_of_moving
from ropsim.spatial import Array, Pose, frozen
from ropsim.tomltext import MASS, ORIGIN, Look, TomlTable, Units, read_look, read_shapes, read_tensor


@frozen_dataclass
class Links:
    """Contents of the rows.

    Attributes:
        links: of the arm, in the frames of their joints.
        estimated: which of masses, centres of mass and inertias are estimates for some link.
    """

    links: tuple[Link, ...]
    estimated: tuple[str, ...]

    @property
    def has_mass(self) -> bool:
        """Return whether there is anything that dynamics could be computed with."""
        return any(link.mass > 0.0 or link.inertia.any() for link in self.links)


def read_links(root: TomlTable, table: DhTable, X_nM: Pose, arm_class: ArmClass, units: Units) -> Links:
    """Return the links of a file; without masses if the file states no masses.

    Args:
        root: the file, with the keys `links`, `mass` and `total_mass`.
        table: its joints.
        X_nM: mechanical interface in the frame of the last joint.
        arm_class: of the arm, for the shares of masses and for their centres.
        units: of the file.
    """
    rows = root.tables("links")
    count = len(table.joints)
    if rows and len(rows) != count:
        root.wrong_count(("links",), rows, f"{count}, one per joint")
    tables = (*rows, *(TomlTable({}, ("links",), root.findings, present=False) for _ in range(count)))[:count]
    guessed: dict[str, None] = {}
    masses = _masses(root, tables, arm_class, guessed)
    stand_ins = bodies(table.joints, X_nM, arm_class, masses)
    links = tuple(
        _link(tables[k], masses[k], stand_ins[k], table.frame(k), units, guessed) for k in range(count)
    )
    for row in rows:
        row.finish()
    return Links(links, tuple(guessed))


def _masses(
    root: TomlTable, tables: Sequence[TomlTable], arm_class: ArmClass, guessed: dict[str, None]
) -> list[float]:
    """Return the masses [kg]: from the file, and for the others shares of that of the whole arm."""
    given = [table.number("mass", MASS, 0.0) if "mass" in table else None for table in tables]
    missing = [k for k, mass in enumerate(given) if mass is None]
    known = sum(mass for mass in given if mass is not None)
    whole = _whole(root, arm_class, len(tables))
    if whole is not None:
        key, moving = ("mass", "of all links") if "mass" in root else ("total_mass", "with the base")
        spare, found = sum(whole.links) - known, root.number(key, MASS, 0.0)
        if known > found or (missing and spare <= 0.0):
            message = f"`{key}` {moving} is {found:g} kg, the rows of `links` have {known:g} kg"
            hint = "`mass` is that of all moving links together, `total_mass` that of the arm with its base"
            root.findings.add(kinds.MASS_USED_UP, root.value_span(key), message, hint)
        if missing:
            guessed["masses of the links"] = None
        shares = sum(whole.links[k] for k in missing)
        return [
            max(spare * whole.links[k] / shares, 0.0) if mass is None else mass
            for k, mass in enumerate(given)
        ]
    if missing and len(missing) < len(tables):
        names = ", ".join(str(k + 1) for k in missing)
        which = f"link {names} has" if len(missing) == 1 else f"links {names} have"
        message = f"{which} no mass, the others have one"
        root.findings.add(
            kinds.SOME_MASSES,
            tables[missing[0]].value_span(),
            message,
            "give each its `mass`, or the whole arm one",
        )
    return [mass or 0.0 for mass in given]


def _whole(root: TomlTable, arm_class: ArmClass, count: int) -> LinkMasses | None:
    """Return the masses of all links by rule; nothing where the file states no mass of the arm."""
    moving = root.number("mass", MASS, 0.0) if "mass" in root else None
    total = root.number("total_mass", MASS, 0.0) if "total_mass" in root else None
    if moving is not None:
        return link_masses_of_moving(arm_class, count, moving)
    return link_masses(arm_class, count, total) if total is not None else None


def _link(
    table: TomlTable,
    mass: float,
    stand_in: Link,
    X_JF: Pose,
    units: Units,
    guessed: dict[str, None],
) -> Link:
    """Return a link whose data stand in frame F of the table, in the frame of its joint."""
    R = snapped(X_JF.rotation())
    com = stand_in.com if mass > 0.0 else frozen(ORIGIN)
    if "com" in table:
        com = frozen(R @ np.array(table.numbers("com", 3, units.position, ORIGIN)) + X_JF.position)
    elif mass > 0.0:
        guessed["centres of mass"] = None
    inertia: Array = np.zeros((3, 3))
    if "inertia" in table:
        inertia = snapped(R @ read_tensor(table) @ R.T)
    elif mass > 0.0:
        guessed["moments of inertia"] = None
        inertia = stand_in.inertia
    shapes = read_shapes(table, units, read_look(table, Look()))
    placed = tuple(replace(shape, pose=X_JF @ shape.pose) for shape in shapes)
    return Link(mass, com, frozen(inertia), placed)

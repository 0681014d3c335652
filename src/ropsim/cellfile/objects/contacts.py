"""The sections `[contacts.NAME]` of a cell file: bodies that are pressed on others on purpose."""

from collections.abc import Iterator, Mapping

from ropsim.cellfile.diagnostics import CONTACT_CANNOT_ACT
from ropsim.model import (
    FLOOR,
    BodyTree,
    Cell,
    MeantContact,
    Mesh,
    body_tree,
    pressing_bodies,
    resisting_bodies,
)
from ropsim.tomltext import UNKNOWN_CELL_NAME, Quantity, Question, Sort, TomlTable, Units, cut

_STIFFNESS = Quantity("N/mm", 1e3, 1.0, 1e9)
_DAMPING = Quantity("N·s/mm", 1e3, 1e-3, 1e7)
_FRICTION = Quantity("", 1.0, 0.0, 5.0)
_STIFF = 1e5
"""Stands in while a missing stiffness is being reported [N/m]."""
_LAG = 2e-3
"""Damping over stiffness where none is given [s]."""
_DEPTH = 1e-3
"""Greatest depth where none is given [m]."""
_LEAST_DEPTH, _MOST_DEPTH = 1e-5, 0.05
"""Of the greatest depth [m]."""


def read_contacts(
    tables: Mapping[str, TomlTable],
    moving: Mapping[str, str],
    standing: Mapping[str, str],
    units: Units,
) -> tuple[MeantContact, ...]:
    """Return the meant contacts in the order of the file.

    Args:
        tables: `[contacts.NAME]`.
        moving: the sort of each tool and part, by name.
        standing: the sort of each object, part and device, by name.
        units: of the file.
    """
    found = []
    for name, table in tables.items():
        table.require("of", "with", "stiffness")
        of = table.reference("of", moving, "tool or part")
        table.ask("with", Question(Sort.TEXTS, names="object, part or device"))
        others = tuple(_others(table, of, {**standing, FLOOR: "floor"})) if "with" in table else ()
        stiffness = table.number("stiffness", _STIFFNESS, _STIFF)
        contact = MeantContact(
            name,
            of,
            others,
            stiffness,
            table.number("damping", _DAMPING, _LAG * stiffness),
            table.number("friction", _FRICTION, 0.2),
            table.number("depth", units.position.within(_LEAST_DEPTH, _MOST_DEPTH), _DEPTH),
        )
        table.finish()
        if of and others:
            found.append(contact)
    return tuple(found)


def note_formless(cell: Cell, tables: Mapping[str, TomlTable]) -> None:
    """Note the contacts of bodies that have no shape with an inside, or are drawn by a mesh.

    Args:
        cell: with its contacts.
        tables: `[contacts.NAME]`.
    """
    if not cell.contacts:
        return
    tree = body_tree(cell)
    for contact in cell.contacts:
        table = tables[contact.name]
        if wrong := _formless(tree, pressing_bodies(cell, contact)[:1]):
            table.findings.add(CONTACT_CANNOT_ACT, table.value_span("of"), *wrong)
        for k, name in enumerate(contact.standing):
            if wrong := _formless(tree, _of_one(cell, contact, name)):
                table.findings.add(CONTACT_CANNOT_ACT, table.value_span("with", k), *wrong)


def _of_one(cell: Cell, contact: MeantContact, name: str) -> tuple[str, ...]:
    if name == FLOOR:
        return ()
    alone = MeantContact(contact.name, contact.moving, (name,), contact.stiffness, contact.damping)
    return resisting_bodies(cell, alone)


def _formless(tree: BodyTree, names: tuple[str, ...]) -> tuple[str, str] | None:
    """Return message and hint where no body, or one of them, has a form that forces can be computed of."""
    if not names:
        return None
    bodies = tree.by_name()
    shapes = [shape for name in names if name in bodies for shape in bodies[name].shapes]
    said = cut(names[0])
    if any(isinstance(shape.solid, Mesh) for shape in shapes):
        return f"`{said}` is drawn by a mesh, whose surface is not known here", _HINT
    if not shapes:
        return f"`{said}` has no shape", _HINT
    return None


_HINT = "give it `shapes` of boxes, cylinders, spheres, prisms or bodies of revolution"


def _others(table: TomlTable, of: str, known: Mapping[str, str]) -> Iterator[str]:
    """Yield the names of `with` that are known and not the moving body itself; note the others."""
    value = table.values["with"]
    if not isinstance(value, list) or not value or not all(isinstance(one, str) for one in value):
        table.wrong_type(("with",), value, "a list of names of objects, parts, devices, or `floor`")
        return
    for k, one in enumerate(value):
        if one not in known:
            names = ", ".join(f"`{each}`" for each in sorted(known)[:12])
            message = f"object, part or device `{cut(one)}` is not defined in this cell"
            hint = f"defined are {names}"
            table.findings.add(UNKNOWN_CELL_NAME, table.value_span("with", k), message, hint)
        elif one == of:
            message = f"`{one}` cannot be pressed on itself"
            hint = "name what it is pressed on"
            table.findings.add(CONTACT_CANNOT_ACT, table.value_span("with", k), message, hint)
        else:
            yield one

"""The bodies of meant contacts: tools with their fingers, parts, and what stands."""

from ropsim.model.cell.cell import Cell
from ropsim.model.cell.cell_bodies import link_name, tool_body
from ropsim.model.cell.meant_contact import FLOOR, MeantContact


def pressing_bodies(cell: Cell, contact: MeantContact) -> tuple[str, ...]:
    """Return the names of the bodies that are pressed on others: a part, or a tool of each station."""
    found = []
    for station in cell.stations.values():
        tool = station.tools.get(contact.moving)
        if tool is not None:
            body = tool_body(contact.moving, station.name)
            joints = tool.fingers.mechanism.joints if tool.fingers else ()
            found += [body, *(f"{body}/finger{k + 1}" for k in range(len(joints)))]
    return tuple(found) or (contact.moving,)


def resisting_bodies(cell: Cell, contact: MeantContact) -> tuple[str, ...]:
    """Return the names of the bodies that others are pressed on; of a device all, `FLOOR` for the floor."""
    found: list[str] = []
    for name in contact.standing:
        device = cell.devices.get(name)
        if device is None:
            found.append(name)
        else:
            found += [link_name(k, name) for k in range(len(device.mechanism.joints) + 1)]
    return tuple(found)


def meant_depths(cell: Cell) -> dict[frozenset[str], float]:
    """Return how deep two bodies may be in each other [m], by pairs with a meant contact."""
    return {
        frozenset((one, other)): contact.depth
        for contact in cell.contacts
        for one in pressing_bodies(cell, contact)
        for other in resisting_bodies(cell, contact)
        if other != FLOOR
    }

"""The rows of `links` in a file of frames: what each joint moves, in the frame of the joint."""

import numpy as np

from ropsim.model import Link
from ropsim.spatial import frozen
from ropsim.tomltext import MASS, ORIGIN, Look, TomlTable, Units, read_look, read_shapes, read_tensor


def read_frame_links(root: TomlTable, count: int, units: Units) -> tuple[Link, ...]:
    """Return the links of a file; those without a row, or without keys in it, have no mass.

    Args:
        root: the file, with the key `links`.
        count: of the joints.
        units: of the file.
    """
    rows = root.tables("links")
    if rows and len(rows) != count:
        root.wrong_count(("links",), rows, f"{count}, one per joint")
    found = []
    for row in rows:
        mass = row.number("mass", MASS, 0.0)
        com = frozen(np.array(row.numbers("com", 3, units.position, ORIGIN)))
        inertia = read_tensor(row)
        found.append(Link(mass, com, inertia, read_shapes(row, units, read_look(row, Look()))))
        row.finish()
    nothing = Link(0.0, frozen(np.zeros(3)), frozen(np.zeros((3, 3))))
    return (*found, *(nothing for _ in range(count)))[:count]

"""The body tree of a cell: which body hangs on which, and which joint moves it."""

from collections.abc import Mapping
from dataclasses import field

from ropsim.model.cell.body import WORLD, Body, BodyKind
from ropsim.model.mechanism.mechanism import Mechanism
from ropsim.spatial import record


@record
class BodyTree:
    """All bodies of a cell at time 0.

    Attributes:
        bodies: in the order in which a scene lists them; a parent may come after its child.
        mechanisms: the mechanisms whose joints move bodies, by name.
    """

    bodies: tuple[Body, ...]
    mechanisms: Mapping[str, Mechanism] = field(default_factory=dict)

    def by_name(self) -> dict[str, Body]:
        """Return the bodies by name."""
        return {body.name: body for body in self.bodies}

    def places(self) -> dict[str, int]:
        """Return the place of each body in `bodies`, by name."""
        return {body.name: place for place, body in enumerate(self.bodies)}

    def names(self, *kinds: BodyKind) -> tuple[str, ...]:
        """Return the names of the bodies of some kinds, in order."""
        return tuple(body.name for body in self.bodies if body.kind in kinds)

    def moving(self) -> tuple[str, ...]:
        """Return the names of the bodies that joints move: links of robots and devices, in order."""
        return tuple(body.name for body in self.bodies if body.mover is not None)

    def of_mechanism(self, name: str) -> tuple[str, ...]:
        """Return the names of the bodies that the joints of a mechanism move, in order."""
        return tuple(body.name for body in self.bodies if body.mover and body.mover.mechanism == name)


def carrier(bodies: Mapping[str, Body], parents: Mapping[str, str], name: str) -> str:
    """Return the body nearest to a body that a joint moves, itself included; `WORLD` where none does.

    Bodies with one carrier keep their places to each other, however the joints move.

    Args:
        bodies: by name.
        parents: parents of bodies whose attachment differs from `bodies`, by name.
        name: of a body, or `WORLD`.
    """
    while name != WORLD and bodies[name].mover is None:
        name = parents.get(name, bodies[name].parent)
    return name

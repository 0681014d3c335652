"""A link: the rigid body that a joint moves."""

from ropsim.model.geometry import Shape
from ropsim.spatial import Array, frozen, record


@record
class Link:
    """The rigid body that a joint moves; all quantities in the frame of that joint.

    Attributes:
        mass: [kg].
        com: centre of mass [m], shape (3,).
        inertia: inertia tensor about the centre of mass [kg·m²], shape (3, 3).
        shapes: what it looks like; without any, views draw a stand-in.
    """

    mass: float
    com: Array
    inertia: Array
    shapes: tuple[Shape, ...] = ()

    def __post_init__(self) -> None:
        object.__setattr__(self, "com", frozen(self.com))
        object.__setattr__(self, "inertia", frozen(self.inertia))

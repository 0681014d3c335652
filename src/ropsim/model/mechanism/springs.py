"""Springs and dampers of a mechanism: between points of two bodies, and on coordinates of joints."""

from ropsim.spatial import Array, frozen, record


@record
class Spring:
    """A massless spring with a damper beside it, stretched between points of two bodies.

    It pulls its ends together with F = k·(l - l_0) + d·l̇, l being the distance of the two points. At l = 0 it
    has no direction and no force.

    Attributes:
        name: such as `balance`.
        link_1: number of a link from 0, `BASE_LINK` for the base.
        point_1: where it is fastened there, in the frame of the link [m], shape (3,).
        link_2: number of another link.
        point_2: where it is fastened to that one [m], shape (3,).
        stiffness: k [N/m]; 0 for a damper alone.
        free_length: l_0, at which the spring bears no force [m].
        damping: d [N·s/m]; 0 for none.
    """

    name: str
    link_1: int
    point_1: Array
    link_2: int
    point_2: Array
    stiffness: float
    free_length: float = 0.0
    damping: float = 0.0

    def __post_init__(self) -> None:
        object.__setattr__(self, "point_1", frozen(self.point_1))
        object.__setattr__(self, "point_2", frozen(self.point_2))


@record
class JointSpring:
    """A spring with a damper beside it on a coordinate Q of a joint: τ = -k·(Q - Q_0) - d·Q̇.

    Attributes:
        name: such as `return spring`.
        coordinate: number of the coordinate, from 0, counted joint by joint as in a `Coupling`.
        stiffness: k [N·m/rad | N/m]; 0 for a damper alone.
        rest: Q_0, at which the spring bears nothing [rad | m].
        damping: d [N·m·s/rad | N·s/m]; 0 for none.
    """

    name: str
    coordinate: int
    stiffness: float
    rest: float = 0.0
    damping: float = 0.0

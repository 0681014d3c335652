"""Structure on which generated code of an arm depends, and the numbers passed at run time.

The structure holds joints, geometry, the blocks of the drives, and which inertial parameters are zero; arms
of one structure share their code. Masses, inertias, payload, gravity, motors, gears, friction are numbers.
"""

from functools import lru_cache

import numpy as np

from ropsim.codegen import Scalar, Tracer, given
from ropsim.core import frozen_dataclass
from ropsim.dynamics.drives import DriveChain, chain_of
from ropsim.dynamics.inertia import interface_step, step_bodies, tip_body
from ropsim.model import BASE_LINK, JointType, Mechanism, Payload, joint_tree
from ropsim.spatial import Array, Pose, frozen

RIGHT_ANGLE_TOLERANCE = 4e-15
"""Entries of a rotation matrix this near to 0 or ±1 are meant to be exactly that: the rounding of a right
angle that went through a quaternion."""

Placement = tuple[tuple[float, ...], tuple[float, ...]]
"""Rotation matrix by rows, and origin [m]."""

BODY = 10
"""Numbers of a body: its barycentric parameters."""

MOST_JOINTS = 12
"""Longest serial chain for straight-line code; longer ones are loops over the joints."""


@frozen_dataclass
class ArmStructure:
    """Everything about an arm that its code depends on; compared by content.

    Attributes:
        types: of the steps, REVOLUTE or PRISMATIC; see `model.JointTree`.
        parents: step that each hangs on, -1 for the base.
        placements: of each step at coordinate 0 in the frame of its parent.
        offsets: added to the coordinates [rad | m].
        spread: for each step its row of (T, c): its coordinate is T·q + c; empty where step i is axis i.
        tip: step that carries the mechanical interface, -1 for the base.
        interface: mechanical interface in the frame of that step.
        drives: the blocks of each drive; empty without drives.
        present: which of the numbers may differ from 0, in the order of `arm_numbers`.
    """

    types: tuple[JointType, ...]
    parents: tuple[int, ...]
    placements: tuple[Placement, ...]
    offsets: tuple[float, ...]
    spread: tuple[tuple[float, ...], ...]
    tip: int
    interface: Placement
    drives: tuple[DriveChain, ...]
    present: tuple[bool, ...]

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return len(self.spread[0]) - 1 if self.spread else self.m

    @property
    def m(self) -> int:
        """Return the number of steps."""
        return len(self.types)

    @property
    def is_long(self) -> bool:
        """Return whether loops over its steps are shorter than straight-line code: of a long serial arm.

        Arms with branches or couplings are straight-line code at any length.
        """
        serial = not self.spread and self.parents == tuple(range(-1, self.m - 1)) and self.tip == self.m - 1
        return serial and self.m > MOST_JOINTS


@frozen_dataclass
class TracedNumbers:
    """The numbers of an arm as scalars.

    Attributes:
        base_acceleration: of the base in its own axes: minus free fall, which stands for gravity; 3.
        bodies: barycentric parameters of the body on each step, that at the interface with its payload; m
            times 10.
        drives: numbers of each drive.
    """

    base_acceleration: list[Scalar]
    bodies: list[list[Scalar]]
    drives: list[list[Scalar]]


@lru_cache(maxsize=256)
def structure_of(robot: Mechanism) -> ArmStructure:
    """Return the structure of an arm."""
    tree = joint_tree(robot)
    drives = tuple(chain_of(drive) for drive in robot.drives)
    tip, X_SM = interface_step(robot)
    fixed = [-robot.gravity != 0.0]
    for step, body in enumerate(step_bodies(robot)):
        fixed.append(np.full(BODY, fill_value=True) if step == tip else body != 0.0)
    always = (True,) * sum(chain.size for chain in drives)
    return ArmStructure(
        types=tree.types,
        parents=tree.parents,
        placements=tuple(_placement(placement) for placement in tree.placements),
        offsets=tuple(map(float, tree.offsets)),
        spread=() if tree.parallel else tuple(map(tuple, np.column_stack((tree.T, tree.c)).tolist())),
        tip=tip,
        interface=_placement(X_SM),
        drives=drives,
        present=(*np.concatenate(fixed).tolist(), *always),
    )


@lru_cache(maxsize=256)
def arm_numbers(robot: Mechanism, payload: Payload | None = None) -> Array:
    """Return the numbers that the code of an arm is given, read-only.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.

    Returns:
        Minus free fall [m/s²], 3; barycentric parameters of the body on each step, 10 each, that at the
        interface with the payload; the numbers of each drive, block by block.
    """
    tip, _ = interface_step(robot)
    bodies = list(step_bodies(robot))
    if tip != BASE_LINK:
        bodies[tip] = tip_body(robot, payload)
    drives = [np.array(chain_of(drive).numbers(drive)) for drive in robot.drives]
    return frozen(np.concatenate([-robot.gravity, *bodies, *drives]))


def traced_numbers(tracer: Tracer, structure: ArmStructure) -> TracedNumbers:
    """Return the numbers of an arm of this structure as scalars; zeros are constants."""
    return split_numbers(structure, given(tracer, structure.present))


def split_numbers(structure: ArmStructure, numbers: list[Scalar]) -> TracedNumbers:
    """Return scalars in the order of `arm_numbers` as named fields."""
    first = 3 + BODY * structure.m
    bodies = [numbers[k : k + BODY] for k in range(3, first, BODY)]
    drives = []
    for chain in structure.drives:
        drives.append(numbers[first : first + chain.size])
        first += chain.size
    return TracedNumbers(numbers[:3], bodies, drives)


def _placement(pose: Pose) -> Placement:
    R = pose.rotation()
    whole = np.round(R)
    R = np.where(np.abs(R - whole) < RIGHT_ANGLE_TOLERANCE, whole, R)
    return tuple(R.ravel().tolist()), tuple(pose.position.tolist())

"""What generated code of an arm depends on, and the numbers that it is given at run time.

The structure holds joints, geometry, the blocks of the drives, and which inertial parameters are zero; arms
of one structure share their code. Masses, inertias, payload, gravity, motors, gears, friction are numbers.
"""

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from ropsim.codegen import Scalar, Tracer, given
from ropsim.dynamics.drives import DriveChain, chain_of
from ropsim.dynamics.inertia import last_body, link_parameters
from ropsim.model import JointType, Payload, RobotModel
from ropsim.spatial import Array, Pose, frozen

RIGHT_ANGLE_TOLERANCE = 4e-15
"""Entries of a rotation matrix this near to 0 or ±1 are meant to be exactly that: the rounding of a right
angle that went through a quaternion."""

Placement = tuple[tuple[float, ...], tuple[float, ...]]
"""Rotation matrix by rows, and origin [m]."""

BODY = 10
"""Numbers of a body: its barycentric parameters."""


@dataclass(frozen=True, slots=True)
class ArmStructure:
    """Everything about an arm that its code depends on; compared by content.

    Attributes:
        types: of the joints.
        placements: of each joint at coordinate 0 in the frame of the joint before it.
        offsets: added to the coordinates [rad | m].
        interface: mechanical interface in the frame of the last joint.
        drives: the blocks of each drive; empty without drives.
        present: which of the numbers may differ from 0, in the order of `arm_numbers`.
    """

    types: tuple[JointType, ...]
    placements: tuple[Placement, ...]
    offsets: tuple[float, ...]
    interface: Placement
    drives: tuple[DriveChain, ...]
    present: tuple[bool, ...]

    @property
    def n(self) -> int:
        """Return the number of joints."""
        return len(self.types)


@dataclass(frozen=True, slots=True)
class TracedNumbers:
    """The numbers of an arm as scalars.

    Attributes:
        base_acceleration: of the base in its own axes: minus free fall, which stands for gravity; 3.
        bodies: barycentric parameters of each body, the last one with its payload; n times 10.
        drives: numbers of each drive.
    """

    base_acceleration: list[Scalar]
    bodies: list[list[Scalar]]
    drives: list[list[Scalar]]


@lru_cache(maxsize=256)
def structure_of(robot: RobotModel) -> ArmStructure:
    """Return the structure of an arm."""
    drives = tuple(chain_of(drive) for drive in robot.drives)
    fixed = [-robot.gravity, *(link_parameters(link) for link in robot.links[:-1])]
    always = BODY + sum(chain.size for chain in drives)
    return ArmStructure(
        types=tuple(joint.type for joint in robot.joints),
        placements=tuple(_placement(joint.placement) for joint in robot.joints),
        offsets=tuple(float(joint.offset) for joint in robot.joints),
        interface=_placement(robot.X_nM),
        drives=drives,
        present=(*(bool(x) for x in (np.concatenate(fixed) != 0.0).tolist()), *(True,) * always),
    )


@lru_cache(maxsize=256)
def arm_numbers(robot: RobotModel, payload: Payload | None = None) -> Array:
    """Return the numbers that the code of an arm is given, read-only.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.

    Returns:
        Minus free fall [m/s²], 3; barycentric parameters of each body, 10 each, the last one with the
        payload; the numbers of each drive, block by block.
    """
    bodies = [*(link_parameters(link) for link in robot.links[:-1]), last_body(robot, payload)]
    drives = [np.array(chain_of(drive).numbers(drive)) for drive in robot.drives]
    return frozen(np.concatenate([-robot.gravity, *bodies, *drives]))


def traced_numbers(tracer: Tracer, structure: ArmStructure) -> TracedNumbers:
    """Return the numbers of an arm of this structure as scalars; those that are zero are constants."""
    numbers = given(tracer, structure.present)
    first = 3 + BODY * structure.n
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

"""Structure on which generated code of an arm depends, and the numbers passed at run time.

The structure holds joints, geometry, the blocks of the drives, and which inertial parameters are zero; arms
of one structure share their code. Masses, inertias, payload, gravity, motors, gears, friction are numbers.
"""

from functools import lru_cache

import numpy as np

from ropsim.codegen import Scalar, Tracer, given
from ropsim.core import frozen_dataclass
from ropsim.dynamics.drives import SUPPLY_SIZE, DriveChain, chain_of, supply_groups, supply_numbers
from ropsim.dynamics.fastened import (
    CutPlaces,
    Placement,
    SpringPlaces,
    cut_places,
    placement_of,
    spring_numbers,
    spring_places,
    sprung_rows,
)
from ropsim.dynamics.inertia import interface_step, step_bodies, tip_body
from ropsim.kinematics import independent_rows
from ropsim.model import BASE_LINK, JointType, Mechanism, Payload, joint_tree
from ropsim.spatial import Array, frozen

BODY = 10
"""Numbers of a body: its barycentric parameters."""

SPRING = 3
"""Numbers of a spring."""

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
        spread: for each step its row of (T, P, c): its coordinate is T·q + P·z + c, where closed chains
            determine z; empty where step i is axis i.
        tip: step that carries the mechanical interface, -1 for the base.
        interface: mechanical interface in the frame of that step.
        drives: the blocks of each drive; empty without drives.
        present: which of the numbers may differ from 0, in the order of `arm_numbers`.
        passive: how many coordinates z closed chains determine.
        cuts: of closed chains.
        springs: between bodies.
        sprung: (T, P, c) of the coordinate of each spring on one.
        watched: rows of the cuts that determine z; see `kinematics.independent_rows`.
        supplies: drives at each supply of oil with an accumulator, from 0.
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
    passive: int = 0
    cuts: tuple[CutPlaces, ...] = ()
    springs: tuple[SpringPlaces, ...] = ()
    sprung: tuple[tuple[float, ...], ...] = ()
    watched: tuple[int, ...] = ()
    supplies: tuple[tuple[int, ...], ...] = ()

    @property
    def n(self) -> int:
        """Return the number of axes."""
        return len(self.spread[0]) - 1 - self.passive if self.spread else self.m

    @property
    def count(self) -> int:
        """Return the number of coordinates that move the tree: of the axes, and those of closed chains."""
        return self.n + self.passive

    @property
    def rows(self) -> int:
        """Return the number of directions that cuts hold."""
        return sum(sum(cut.held) for cut in self.cuts)

    @property
    def m(self) -> int:
        """Return the number of steps."""
        return len(self.types)

    @property
    def is_long(self) -> bool:
        """Return whether loops over its steps are shorter than straight-line code: of a long serial arm.

        Arms with branches, couplings or springs are straight-line code at any length.
        """
        plain = not (self.spread or self.springs or self.sprung)
        serial = plain and self.parents == tuple(range(-1, self.m - 1)) and self.tip == self.m - 1
        return serial and self.m > MOST_JOINTS


@frozen_dataclass
class TracedNumbers:
    """The numbers of an arm as scalars.

    Attributes:
        base_acceleration: of the base in its own axes: minus free fall, which stands for gravity; 3.
        bodies: barycentric parameters of the body on each step, that at the interface with its payload; m
            times 10.
        drives: numbers of each drive.
        springs: stiffness, free length and damping of each spring between bodies, then stiffness, rest and
            damping of each one on a coordinate.
        supplies: numbers of each supply of oil with an accumulator.
    """

    base_acceleration: list[Scalar]
    bodies: list[list[Scalar]]
    drives: list[list[Scalar]]
    springs: list[list[Scalar]]
    supplies: list[list[Scalar]]


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
    supplies, of_springs = supply_groups(robot.drives), spring_numbers(robot) != 0.0
    given_oil = (True,) * (len(supplies) * SUPPLY_SIZE)
    spread = np.column_stack((tree.T, tree.P, tree.c))
    return ArmStructure(
        types=tree.types,
        parents=tree.parents,
        placements=tuple(placement_of(placement) for placement in tree.placements),
        offsets=tuple(map(float, tree.offsets)),
        spread=() if tree.parallel else tuple(map(tuple, spread.tolist())),
        tip=tip,
        interface=placement_of(X_SM),
        drives=drives,
        present=(*np.concatenate(fixed).tolist(), *always, *of_springs.tolist(), *given_oil),
        passive=tree.P.shape[1],
        cuts=cut_places(robot),
        springs=spring_places(robot),
        sprung=sprung_rows(robot),
        watched=independent_rows(robot) if robot.cuts else (),
        supplies=supplies,
    )


@lru_cache(maxsize=256)
def arm_numbers(robot: Mechanism, payload: Payload | None = None) -> Array:
    """Return the numbers that the code of an arm is given, read-only.

    Args:
        robot: the arm.
        payload: body at the mechanical interface; None for none.

    Returns:
        Minus free fall [m/s²], 3; barycentric parameters of the body on each step, 10 each, that at the
        interface with the payload; the numbers of each drive, block by block; three for each spring; those
        of the supplies of oil.
    """
    tip, _ = interface_step(robot)
    bodies = list(step_bodies(robot))
    if tip != BASE_LINK:
        bodies[tip] = tip_body(robot, payload)
    drives = [np.array(chain_of(drive).numbers(drive)) for drive in robot.drives]
    behind = spring_numbers(robot), supply_numbers(robot.drives)
    return frozen(np.concatenate([-robot.gravity, *bodies, *drives, *behind]))


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
    end = len(structure.present) - SUPPLY_SIZE * len(structure.supplies)
    springs = [numbers[k : k + SPRING] for k in range(first, end, SPRING)]
    supplies = [numbers[k : k + SUPPLY_SIZE] for k in range(end, len(structure.present), SUPPLY_SIZE)]
    return TracedNumbers(numbers[:3], bodies, drives, springs, supplies)

"""Mechanisms for tests: random trees with joints of all types and random couplings."""

from dataclasses import dataclass

import numpy as np

from ropsim.model import BASE_LINK, Coupling, Drive, Joint, JointType, RobotModel
from ropsim.spatial import Array, Pose
from support.arms import random_link

ONE_FREEDOM = (JointType.REVOLUTE, JointType.PRISMATIC, JointType.SCREW)


@dataclass(frozen=True)
class Tree:
    """A mechanism, and the coordinates of all its joints as C·q + c, known beside the model."""

    robot: RobotModel
    C: Array
    c: Array


def random_tree(seed: int, count: int = 6, drives: tuple[Drive, ...] = ()) -> Tree:
    """Return a tree of joints of any type; all but one with one freedom are axes, the rest is coupled."""
    rng = np.random.default_rng(seed)
    joints: list[Joint] = []
    for number in range(count):
        type_ = ONE_FREEDOM[number] if number < 2 else list(JointType)[rng.integers(len(JointType))]
        parent = int(rng.integers(BASE_LINK, number))
        placement = Pose(rng.uniform(-0.5, 0.5, 3), rng.normal(size=4))
        lead = float(rng.uniform(-0.2, 0.2)) if type_ is JointType.SCREW else 0.0
        offset = float(rng.uniform(-0.5, 0.5))
        name = f"{number}{type_.value}"
        joints.append(Joint(name, type_, placement, offset, -3.0, 3.0, 2.0, 10.0, 100.0, 1.0, parent, lead))
    single = [number for number, joint in enumerate(joints) if joint.type in ONE_FREEDOM]
    axes = sorted(int(one) for one in rng.permutation(single)[: max(1, len(single) - 1)])
    rng.shuffle(axes)
    first = np.concatenate([[0], np.cumsum([joint.type.freedoms for joint in joints])]).tolist()
    C, c = np.zeros((first[-1], len(axes))), np.zeros(first[-1])
    for place, number in enumerate(axes):
        C[first[number], place] = 1.0
    known = [first[number] for number in axes]
    couplings = []
    for number in range(first[-1]):
        if number in known:
            continue
        others = [int(one) for one in rng.choice(known, size=min(2, len(known)), replace=False)]
        terms = tuple((other, float(rng.uniform(-1.5, 1.5))) for other in others)
        constant = float(rng.uniform(-0.5, 0.5))
        couplings.append(Coupling(number, terms, constant))
        C[number] = sum(factor * C[other] for other, factor in terms)
        c[number] = sum(factor * c[other] for other, factor in terms) + constant
        known.append(number)
    rng.shuffle(couplings)
    robot = RobotModel(
        name=f"tree_{seed}",
        title="random tree",
        joints=tuple(joints),
        links=tuple(random_link(rng) for _ in joints),
        drives=drives[: len(axes)],
        home=np.zeros(len(axes)),
        axes=tuple(axes),
        couplings=tuple(couplings),
        gravity=rng.uniform(-10.0, 10.0, 3),
        X_nM=Pose(rng.uniform(-0.2, 0.2, 3), rng.normal(size=4)),
    )
    return Tree(robot, C, c)

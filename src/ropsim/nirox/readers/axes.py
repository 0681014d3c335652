"""Axes of an arm, and the cuts of its closed chains."""

import numpy as np

from ropsim.model import ALL_DIRECTIONS, Coupling, DhRow, Direction, JointType, LoopCut
from ropsim.nirox.pair_words import BOOLEANS, FREE
from ropsim.nirox.readers.mechanism import Mechanism
from ropsim.nirox.readers.seen import Seen


def read_couplings(seen: Seen, mechanism: Mechanism) -> tuple[Coupling, ...]:
    """Return the coordinates that follow others; raises `ImpossibleError` where one is not there."""
    first = np.concatenate([[0], np.cumsum([one.type.freedoms for one in mechanism.moved])]).tolist()

    def coordinate(entry: int, pair: int, place: int) -> int:
        number = mechanism.pairs.get(pair)
        if number is None or not 1 <= place <= mechanism.moved[number].type.freedoms:
            raise seen.impossible(entry, f"{seen.called(pair)} has no coordinate {place} in this mechanism")
        return int(first[number]) + place - 1

    found = []
    for number, entry in enumerate(seen.extent("joint_coupling")):
        seen.take(entry, "coupling", number)
        places = zip(seen.refs(entry, "followed"), seen.integers(entry, "coordinates"), strict=True)
        others = [coordinate(entry, pair, place) for pair, place in places]
        terms = tuple(zip(others, seen.reals(entry, "factors"), strict=True))
        dependent = coordinate(entry, seen.ref(entry, "pair"), seen.integer(entry, "coordinate"))
        found.append(Coupling(dependent, terms, seen.real(entry, "constant_term")))
    return tuple(found)


def read_dh_table(seen: Seen, mechanism: Mechanism) -> tuple[DhRow, ...]:
    """Return the rows of the DH table; raises `ImpossibleError` where one has no joint that can have it."""
    rows = []
    for entry in seen.extent("denavit_hartenberg_row"):
        number = mechanism.pairs.get(seen.ref(entry, "pair"))
        type_ = mechanism.moved[number].type if number is not None else JointType.FIXED
        if number is None or type_ not in (JointType.REVOLUTE, JointType.PRISMATIC):
            raise seen.impossible(entry, "a row of the table is of a pair that turns or slides")
        seen.take(entry, "dh", number)
        a, alpha, d, theta = (seen.real(entry, one) for one in ("a", "alpha", "d", "theta"))
        rows.append(DhRow(a, alpha, d, theta, type_))
    return tuple(rows)


def read_external(seen: Seen, pairs: list[int]) -> tuple[int, ...]:
    """Return the numbers of the external axes; raises `ImpossibleError` where one is no axis.

    Args:
        seen: the file.
        pairs: of the axes.
    """
    found: list[int] = []
    for entry in seen.extent("external_axis"):
        pair = seen.ref(entry, "pair")
        if pair not in pairs:
            raise seen.impossible(entry, "an external axis is one of the axes of the arm")
        found.append(pairs.index(pair))
        seen.take(entry, "external", found[-1])
    return tuple(found)


def read_cuts(seen: Seen, mechanism: Mechanism) -> tuple[LoopCut, ...]:
    """Return the closed chains; raises `ImpossibleError` where one is cut at a pair that cannot be."""
    return tuple(
        _cut(seen, mechanism, number, pair, cut)
        for number, (pair, cut) in enumerate(mechanism.cut_pairs.items())
    )


def _cut(seen: Seen, mechanism: Mechanism, number: int, pair: int, cut: int) -> LoopCut:
    joint, loop = seen.ref(pair, "joint"), seen.ref(cut, "loop")
    ends = [seen.ref(joint, name) for name in ("edge_start", "edge_end")]
    if any(one not in mechanism.links for one in ends):
        raise seen.impossible(pair, "its links do not belong to the mechanism")
    poses = [
        mechanism.frames[link]
        @ mechanism.places.pose(seen.ref(pair, f"transform_item_{place}"), (word, number))
        for place, (link, word) in enumerate(zip(ends, ("cut place", "cut body"), strict=True), start=1)
    ]
    first, second = (mechanism.links[one] for one in ends)
    for one, word in ((cut, "cut"), (pair, "cut pair"), (joint, "cut joint"), (loop, "loop")):
        seen.take(one, word, number)
    if joint in mechanism.pair_of:
        seen.take(mechanism.pair_of[joint][1], "cut pair", number, "relation")
    moved = {one.joint: place for place, one in enumerate(mechanism.moved)}
    for edge in seen.refs(loop, "edge_list"):
        seen.take(edge, "loop edge", number, moved.get(seen.ref(edge, "edge_element"), -1))
    return LoopCut(first, poses[0], second, poses[1], _held(seen, pair))


def _held(seen: Seen, pair: int) -> tuple[Direction, ...]:
    """Return the directions in which the frames of a pair cannot part."""
    entity = next((one for one in FREE if seen.is_a(pair, one)), "")
    if entity:
        return tuple(one for one in ALL_DIRECTIONS if one not in FREE[entity])
    if not seen.is_a(pair, "low_order_kinematic_pair"):
        raise seen.impossible(pair, "a chain is not cut at a pair of this kind", "cut it at another one")
    rows = zip(ALL_DIRECTIONS, BOOLEANS, strict=True)
    return tuple(one for one, name in rows if not seen.flag(pair, name))

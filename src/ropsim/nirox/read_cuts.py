"""The closed chains of a file, cut at the pairs that it names."""

from ropsim.model import ALL_DIRECTIONS, Direction, LoopCut
from ropsim.nirox.pair_words import BOOLEANS, FREE
from ropsim.nirox.read_mechanism import Mechanism
from ropsim.nirox.seen import Seen


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

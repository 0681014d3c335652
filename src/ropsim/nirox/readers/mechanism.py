"""Links, pairs and closed chains of a file: which joint moves which link, and where the cuts are."""

from functools import partial

from ropsim.core import frozen_dataclass
from ropsim.model import BASE_LINK, JointType
from ropsim.nirox.diagnostics import IMPOSSIBLE
from ropsim.nirox.pair_words import PAIRS
from ropsim.nirox.readers.places import Places
from ropsim.nirox.readers.seen import Seen
from ropsim.nirox.readers.tree_steps import tree_steps
from ropsim.nirox.readers.units import Units, units_of
from ropsim.spatial import Pose

MOST_JOINTS = 200
"""Joints of a file that are read; the largest machines have some thirty."""
_OVER = Pose.from_tuple((0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0))
"""Rx(180°): turns a joint round whose second link is the nearer one to the base."""


@frozen_dataclass
class Moved:
    """A joint of the tree.

    Attributes:
        pair: number of its instance.
        joint: number of the kinematic joint.
        link: number of the link that it moves.
        parent: number of the moved joint that carries it, from 0; `BASE_LINK` for the base.
        type: of the joint.
        placement: of its frame in the frame of the link that carries it, which is that of its joint.
    """

    pair: int
    joint: int
    link: int
    parent: int
    type: JointType
    placement: Pose


class Mechanism:
    """The mechanism of a file.

    Attributes:
        moved: the joints of the tree, each behind the one that carries it.
        links: number of the joint that moves each link, from 0, by the number of its instance.
        pairs: number of the joint of each pair.
        frames: X_JL of each link: the frame in which the file describes it, in that of its joint.
        units: of the mechanism.
        pair_of: pair and relationship of each kinematic joint.
        cut_pairs: the cut of each pair that is taken out of a chain.
        places: placements of the file.
    """

    def __init__(self, seen: Seen, arm: int) -> None:
        """Read the mechanism of an arm; raises `ImpossibleError` where it cannot be followed."""
        self._seen = seen
        mechanism = seen.ref(arm, "mechanism")
        seen.take(mechanism, "mechanism")
        self.base = seen.ref(arm, "base")
        seen.take(self.base, "link", BASE_LINK)
        relations = seen.refs(mechanism, "items")
        self.units = units_of(seen, seen.ref(mechanism, "context_of_items"))
        self.places = Places(seen, self._representations())
        self.moved: list[Moved] = []
        self.links: dict[int, int] = {self.base: BASE_LINK}
        self.pairs: dict[int, int] = {}
        self.frames: dict[int, Pose] = {self.base: Pose()}
        self.pair_of = self._pairs(relations)
        self.cut_pairs = {seen.ref(one, "cut_pair"): one for one in seen.extent("loop_cut")}
        self._tree(self._joints(seen.ref(mechanism, "represented_topology")))

    def _representations(self) -> dict[int, Units]:
        """Return the units of the representations of links, and take these."""
        seen, known, found = self._seen, dict[int, Units](), dict[int, Units]()
        for number in seen.extent("rigid_link_representation"):
            context = seen.ref(number, "context_of_items")
            if context not in known:
                known[context] = units_of(seen, context)
            found[number] = known[context]
        return found

    def _pairs(self, relations: list[int]) -> dict[int, tuple[int, int]]:
        """Return the pair and the relationship of each kinematic joint."""
        found = {}
        for relation in relations:
            pair = self._seen.ref(relation, "transformation_operator")
            found[self._seen.ref(pair, "joint")] = pair, relation
        return found

    def _joints(self, topology: int) -> list[int]:
        """Return the kinematic joints of the tree, in the order of the file."""
        seen = self._seen
        if seen.is_a(topology, "kinematic_topology_network_structure"):
            seen.take(topology, "network")
            topology = seen.ref(topology, "parent_structure")
        elif seen.is_a(topology, "kinematic_topology_directed_structure"):
            topology = seen.ref(topology, "parent_structure")
        seen.take(topology, "topology")
        seen.take(seen.ref(topology, "context_of_items"), "context", "topology")
        found = []
        for joint in seen.refs(topology, "items"):
            if joint not in self.pair_of:
                seen.note(IMPOSSIBLE, joint, "no pair of the mechanism is of this joint", "add its pair")
            elif self.pair_of[joint][0] not in self.cut_pairs:
                found.append(joint)
        if len(found) > MOST_JOINTS:
            words = f"the mechanism has {len(found)} joints, allowed are {MOST_JOINTS}"
            raise seen.impossible(topology, words)
        return found

    def _tree(self, joints: list[int]) -> None:
        """Move the links one after the other, along the joints that lead to them."""
        seen = self._seen
        ends = [(seen.ref(one, "edge_start"), seen.ref(one, "edge_end")) for one in joints]
        found = tree_steps(self.base, ends)
        for place, near, far in found.steps:
            self._move(joints[place], near, far)
        for place in found.closing:
            words = "it closes a chain of joints that is not cut"
            seen.note(IMPOSSIBLE, joints[place], words, "name the pair to cut in a LOOP_CUT")
        for place in found.apart:
            words = "no way of joints leads from the base to it"
            seen.note(IMPOSSIBLE, joints[place], words, "join it, or take it out")

    def _move(self, joint: int, near: int, far: int) -> None:
        """Add the joint that moves one link against another one, which is nearer to the base."""
        seen, number = self._seen, len(self.moved)
        pair, relation = self.pair_of[joint]
        type_ = self._type(pair)
        items = [seen.ref(pair, f"transform_item_{place}") for place in (1, 2)]
        keys: list[tuple[str, int]] = [("place", number), ("body", number)]
        turned = seen.ref(joint, "edge_start") == far
        if turned:
            items.reverse()
            if type_.freedoms > 1:
                raise seen.impossible(
                    joint, "a joint of several freedoms starts at the link farther from the base"
                )
        X_LJ, X_FJ = (
            seen.attempt(partial(self.places.pose, item, key, type_), Pose())
            for item, key in zip(items, keys, strict=True)
        )
        if turned and type_.freedoms:
            X_LJ, X_FJ = X_LJ @ _OVER, X_FJ @ _OVER
        seen.take(joint, "joint", number)
        seen.take(pair, "pair", number)
        seen.take(relation, "pair", number, "relation")
        seen.take(far, "link", number)
        self.moved.append(Moved(pair, joint, far, self.links[near], type_, self.frames[near] @ X_LJ))
        self.links[far], self.pairs[pair] = number, number
        self.frames[far] = Pose() if X_FJ.is_identity else X_FJ.inverse()

    def _type(self, pair: int) -> JointType:
        for type_, entity in PAIRS.items():
            if self._seen.is_a(pair, entity):
                return type_
        raise self._seen.impossible(
            pair, "the model has no joint of this kind", "allowed are " + ", ".join(PAIRS.values())
        )

    def take_representations(self) -> None:
        """Take the representations of the links, with the contexts that they are in."""
        seen = self._seen
        for number in seen.extent("rigid_link_representation"):
            link = self.links.get(seen.ref(number, "represented_link"))
            if link is not None:
                seen.take(number, "representation", link)
                seen.take(seen.ref(number, "context_of_items"), "context", link)
        for arm in seen.extent("robot_arm"):
            mechanism = seen.ref(arm, "mechanism")
            seen.take(seen.ref(mechanism, "context_of_items"), "context", "mechanism")

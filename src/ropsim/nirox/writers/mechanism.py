"""Links, joints, pairs and closed chains of a robot as instances."""

from collections.abc import Iterator
from math import isfinite

from ropsim.core import Diagnostic
from ropsim.model import BASE_LINK, Joint, JointType, RobotModel
from ropsim.nirox.building import DERIVED, UNSET, Building
from ropsim.nirox.diagnostics import LOST
from ropsim.nirox.pair_words import PAIRS
from ropsim.nirox.writers.cuts import write_cut
from ropsim.nirox.writers.places import write_placement
from ropsim.part21 import Enumeration, Record, Reference, Value
from ropsim.spatial import Pose


class MechanismWriting:
    """The kinematic part of a robot while it is written."""

    def __init__(self, building: Building, robot: RobotModel) -> None:
        self._building = building
        self._robot = robot
        self._items: dict[int, list[Reference]] = {link: [] for link in range(-1, len(robot.joints))}
        self._ends = {(joint.parent, number) for number, joint in enumerate(robot.joints)}
        self._cuts: list[int] = []

    def place_on(self, link: int, placement: Reference) -> None:
        """Let a placement be an item of the representation of a link."""
        if placement not in self._items[link]:
            self._items[link].append(placement)

    def write(self) -> Reference:
        """Make links, joints, pairs and loops, and return the representation of the mechanism."""
        building, robot = self._building, self._robot
        building.add(("link", BASE_LINK), "KINEMATIC_LINK", "base")
        for number, joint in enumerate(robot.joints):
            building.add(("link", number), "KINEMATIC_LINK", f"link {joint.name}")
        for number, joint in enumerate(robot.joints):
            ends = building.at(("link", joint.parent)), building.at(("link", number))
            building.add(("joint", number), "KINEMATIC_JOINT", joint.name, *ends)
            self._pair(number, joint)
        for number, cut in enumerate(robot.cuts):
            if (cut.first, cut.second) not in self._ends:
                self._ends.add((cut.first, cut.second))
                self._cuts.append(number)
                first, second = write_cut(building, robot, number)
                self.place_on(cut.first, first)
                self.place_on(cut.second, second)
        return self._mechanism()

    def losses(self) -> Iterator[Diagnostic]:
        """Yield the closed chains that have no place in the schema."""
        for number in range(len(self._robot.cuts)):
            if number not in self._cuts:
                words = f"closed chain {number + 1} of `{self._robot.name}` does not go over"
                hint = "two links have one pair between them: join an auxiliary link"
                yield LOST.at(None, f"{words}: its two links are joined already", hint=hint)

    def _pair(self, number: int, joint: Joint) -> None:
        first = write_placement(self._building, ("place", number), joint.placement, joint.type)
        second = write_placement(self._building, ("body", number), Pose(), joint.type)
        self.place_on(joint.parent, first)
        self.place_on(number, second)
        values: list[Value] = [
            joint.name,
            DERIVED,
            UNSET,
            first,
            second,
            self._building.at(("joint", number)),
        ]
        if joint.type is JointType.SCREW:
            values.append(float(joint.lead))
        else:
            values += [DERIVED] * 6
        if joint.type is JointType.UNIVERSAL:
            values.append(UNSET)
        keyword = PAIRS[joint.type]
        if joint.type.freedoms == 1 and joint.lower < joint.upper:
            bounds = (joint.lower + joint.offset, joint.upper + joint.offset)
            if any(map(isfinite, bounds)):
                keyword += "_with_range"
                values += [float(one) if isfinite(one) else UNSET for one in bounds]
        self._building.add(("pair", number), keyword.upper(), *values)

    def _mechanism(self) -> Reference:
        building, name = self._building, self._robot.name
        self._units()
        for link, items in self._items.items():
            context = building.at(("context", link))
            represented = building.at(("link", link))
            listed = tuple(items)
            label = building.records["link", link][0].values[0]
            building.add(
                ("representation", link), "RIGID_LINK_REPRESENTATION", label, listed, context, represented
            )
        pairs = [(("pair", k), ("joint", k), joint.parent, k) for k, joint in enumerate(self._robot.joints)]
        for k in self._cuts:
            cut = self._robot.cuts[k]
            pairs.append((("cut pair", k), ("cut joint", k), cut.first, cut.second))
        joints, relations = [], []
        for pair, joint, first, second in pairs:
            label = building.records[pair][0].values[0]
            ends = building.at(("representation", first)), building.at(("representation", second))
            key = (*pair, "relation")
            values = (label, "", UNSET, *ends, building.at(pair))
            relations.append(building.add(key, "PAIR_REPRESENTATION_RELATIONSHIP", *values))
            joints.append(building.at(joint))
        context = building.at(("context", "topology"))
        topology = building.add(("topology",), "KINEMATIC_TOPOLOGY_STRUCTURE", name, tuple(joints), context)
        if self._cuts:
            loops = tuple(building.at(("loop", k)) for k in self._cuts)
            keyword = "KINEMATIC_TOPOLOGY_NETWORK_STRUCTURE"
            topology = building.add(("network",), keyword, name, loops, context, topology)
        own = building.at(("context", "mechanism"))
        made = building.add(("mechanism",), "MECHANISM_REPRESENTATION", name, tuple(relations), own, topology)
        for k in self._cuts:
            building.add(("cut", k), "LOOP_CUT", building.at(("loop", k)), building.at(("cut pair", k)))
        return made

    def _units(self) -> None:
        building = self._building
        metre = (Record("LENGTH_UNIT", ()), Record("NAMED_UNIT", (DERIVED,)), _si("METRE"))
        radian = (Record("NAMED_UNIT", (DERIVED,)), Record("PLANE_ANGLE_UNIT", ()), _si("RADIAN"))
        units = building.add_complex(("metre",), metre), building.add_complex(("radian",), radian)
        labels = {link: building.records["link", link][0].values[0] for link in self._items}
        named: list[tuple[int | str, Value]] = [*labels.items(), ("mechanism", "mechanism")]
        for place, label in named:
            records = (
                Record("GEOMETRIC_REPRESENTATION_CONTEXT", (3,)),
                Record("GLOBAL_UNIT_ASSIGNED_CONTEXT", (units,)),
                Record("REPRESENTATION_CONTEXT", (label, "")),
            )
            building.add_complex(("context", place), records)
        building.add(("context", "topology"), "REPRESENTATION_CONTEXT", "topology", "")


def _si(name: str) -> Record:
    return Record("SI_UNIT", (UNSET, Enumeration(name)))

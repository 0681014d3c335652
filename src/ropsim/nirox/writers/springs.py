"""Springs and dampers of a robot as instances."""

from ropsim.model import RobotModel
from ropsim.nirox.building import Building, reals


def write_springs(building: Building, robot: RobotModel) -> None:
    """Make the springs; links and pairs have been made."""
    for number, spring in enumerate(robot.springs):
        building.add(
            ("spring", number),
            "LINK_SPRING",
            spring.name,
            building.at(("link", spring.link_1)),
            reals(spring.point_1),
            building.at(("link", spring.link_2)),
            reals(spring.point_2),
            *map(float, (spring.stiffness, spring.free_length, spring.damping)),
        )
    places = [(k, one + 1) for k, joint in enumerate(robot.joints) for one in range(joint.type.freedoms)]
    for number, one in enumerate(robot.joint_springs):
        moved, coordinate = places[one.coordinate]
        numbers = map(float, (one.stiffness, one.rest, one.damping))
        pair = building.at(("pair", moved))
        building.add(("joint spring", number), "JOINT_SPRING", one.name, pair, coordinate, *numbers)

"""Whether a robot, its tool and the part in its gripper are in nothing else at a location."""

from ropsim.tasks.conditions.condition import Condition

COLLISION_FREE = Condition(
    "collision_free",
    ("Part",),
    lambda geometry, robot, things, location: geometry.obstruction(robot, things[0], location) or True,
    lambda things, place: f"`{things[0]}` is in something at {place}",
    beside=True,
)

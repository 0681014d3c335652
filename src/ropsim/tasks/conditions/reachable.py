"""Whether a robot can bring its tool to a location."""

from ropsim.tasks.conditions.condition import Condition

REACHABLE = Condition(
    "reachable",
    (),
    lambda geometry, robot, _, location: geometry.reachable(robot, location),
    lambda _, place: f"{place} cannot be reached",
)

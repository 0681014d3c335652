"""A rated payload that no arm of this mass has."""

from math import isfinite

from ropsim.core import Diagnostic
from ropsim.model import RobotModel
from ropsim.robotfile.diagnostics import UNLIKELY_PAYLOAD


def payload_doubts(robot: RobotModel) -> tuple[Diagnostic, ...]:
    """Return a finding where the rated payload of an arm is more than the mass of its moving links.

    Args:
        robot: an arm with masses; one without any is not doubted.
    """
    payload, own = robot.rated_payload, sum(link.mass for link in robot.links)
    if not (isfinite(payload) and payload > own > 0.0):
        return ()
    words = f"`{robot.name}` has a rated payload of {payload:.4g} kg and moves {own:.4g} kg of its own"
    hint = "payloads are in kg; what does the data sheet say?"
    data = {"payload_kg": payload, "mass_kg": own}
    return (UNLIKELY_PAYLOAD.at(None, words, hint=hint, data=data),)

"""How many parts reached their places, and how a robot is at the end of a run, each in one line."""

import math

from ropsim.core import plural
from ropsim.flow import Destinations, Recording
from ropsim.spatial import quaternion


def destinations_text(found: Destinations) -> str:
    """Return it as a line, such as `12 of 12 parts at their destination`."""
    whose = "its" if found.wanted == 1 else "their"
    return f"{found.reached} of {plural(found.wanted, 'part')} at {whose} destination"


def state_text(recording: Recording, took: float) -> str:
    """Return pose of the first station's TCP in its base frame, simulated time, and how long it took [s].

    Args:
        recording: of the run.
        took: time of the last command [s].
    """
    name = recording.facts.stations[0].name

    def last(quantity: str) -> list[float]:
        return [float(value) for value in recording.rows(recording.facts.channel(quantity, name))[-1]]

    x, y, z = (1e3 * value for value in last("attained_position"))
    w, i, j, k = last("attained_orientation")
    yaw, pitch, roll = (math.degrees(angle) for angle in quaternion.to_zyx((w, i, j, k)))
    x, y, z, roll, pitch, yaw = (round(value, 2) + 0.0 for value in (x, y, z, roll, pitch, yaw))
    pose = f"x {x:.2f} y {y:.2f} z {z:.2f} mm, roll {roll:.2f} pitch {pitch:.2f} yaw {yaw:.2f} deg"
    return f"{pose}; {recording.duration:.3f} s ({took:+.3f} s)"

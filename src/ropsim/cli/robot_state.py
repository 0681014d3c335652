"""How a robot is at the end of a run, in one line."""

import math
from typing import TYPE_CHECKING

from ropsim.spatial import quaternion
from ropsim.workbench import Project

if TYPE_CHECKING:
    from ropsim.flow import Recording


def state_text(recording: "Recording", project: Project, took: float) -> str:
    """Return pose of the TCP in the base frame, simulated time, and how long the last command took [s]."""
    assert project.cell is not None  # a run has a cell
    name = project.cell.first.name

    def last(quantity: str) -> list[float]:
        return [float(value) for value in recording.rows(recording.facts.channel(quantity, name))[-1]]

    x, y, z = (1e3 * value for value in last("attained_position"))
    w, i, j, k = last("attained_orientation")
    yaw, pitch, roll = (math.degrees(angle) for angle in quaternion.to_zyx((w, i, j, k)))
    x, y, z, roll, pitch, yaw = (round(value, 2) + 0.0 for value in (x, y, z, roll, pitch, yaw))
    pose = f"x {x:.2f} y {y:.2f} z {z:.2f} mm, roll {roll:.2f} pitch {pitch:.2f} yaw {yaw:.2f} deg"
    return f"{pose}; {recording.duration:.3f} s ({took:+.3f} s)"

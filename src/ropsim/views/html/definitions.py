"""Meanings of the figures of a report; short HTML texts by name."""

from collections.abc import Mapping
from types import MappingProxyType

DEFINITIONS: Mapping[str, str] = MappingProxyType(
    {
        "cycle time": "From the start to the end of the last motion or instruction, settling included.",
        "in motion": "Share of the cycle time in which moves were on their way, outside of zones and within "
        "them; of several stations, of their cycle times together.",
        "settling": "Time after a move until every joint is in position, summed over all moves. "
        "A stop looks at positions only, not at speeds. The program waits for it, unlike for the time "
        "to stay at a place.",
        "waiting": "Time in which the program stood at a `wait`, for a time, a signal or a condition, or "
        "looked at signals in a loop. The share is that of the cycle time of the station.",
        "parts of the cycle time": "Motion and zones are the way of the moves, outside of and within the "
        "zones around their ends; partners are waits for signals that the program of another station sets. "
        "Whole control ticks, so their sum is the cycle time exactly.",
        "at its limit for": "The limit of a joint, or of the tool on its path, that the planned moves of a "
        "line reach for longest, as a share of their way; from 98 % of the limit it counts as reached. "
        "Bend: the path is bent and no limit reached; the bend takes acceleration and jerk of tool or joint.",
        "torque": "Of the drive at the joint, behind the gear and before joint friction; the share is "
        "that of the limit of the model.",
        "energy": "Of the drives of a station together, which share a supply: what one gives back another "
        "draws, and only the rest counts as given back. Copper, friction and lifting are in it, of hydraulic "
        "drives what flows out of the supply; what amplifiers, pumps, controller and brakes take is not.",
        "use of the drives": "RMS is the root of the mean square over the whole run. The lasting current is "
        "what warms the winding to its greatest rise in the end; a model without such a limit has no share.",
        "following error": "Reference minus attained joint coordinate at the same instant; it contains "
        "the delay of the servo.",
        "path error": "Distance of the attained tool centre point from the part of the path that is "
        "commanded at that moment, so that an arm that comes late past a corner counts as off; contours "
        "have the distance from the path as a whole. That part is "
        "a line, an arc, a curve or the corner between two of them, its ends included. The largest one "
        "is no path accuracy AT<sub>p</sub> of ISO 9283:1998 (8.2), which is that of the barycentre of ten "
        "cycles.",
        "angle": "Largest angle between attained and commanded orientation at one place of the path.",
        "spread of the passes": "Of several passes of one path, the largest l̄ + 3 S over 50 "
        "points of it, with the distances l of the passes from their middle in the plane at right angles to "
        "the path: the formula of RT<sub>p</sub> (8.3). The simulation "
        "has no noise: passes differ by what was before them and by payload.",
        "given speed": "Path speed that the program, or the cell, gives for the move. Where the command "
        "speed stays below it, the way is too short for acceleration and jerk, or joints and corners do not "
        "allow it.",
        "speed error": "(mean attained speed − command speed) / command speed, over the "
        "middle half of the time in which the commanded speed of the move is within 1 % of "
        "its largest value; its fluctuation is the largest minus the least attained speed there (formulas "
        "of AV and FV, 8.6).",
        "rounded corners": "Attained is the least distance of the attained path from the corner "
        "point of a rounded corner; the overshoot is the largest one from the commanded path behind it, on "
        "the outer side (formulas of CR and CO, 8.5).",
        "overshoot at a stop": "Largest distance of the tool centre point from the place of the stop "
        "after it has first come there, within 0.1 mm or passing by; 0 where it stays within 0.1 mm. The "
        "place is where the arm, in position, rests for 0.1 s before it goes on, otherwise the commanded "
        "one. The time to stay at its place lasts from the first coming until the arm stays within 0.1 mm, "
        "whatever the program does meanwhile: it may be longer than settling, which joints in position end "
        "(formulas of stabilization time and OV, 7.4, 7.5, with a band of 0.1 mm).",
        "not reached": "Stops after which the program went on before all joints were in position, and how "
        "far the tool centre point was from its target then.",
        "near, beyond": "Near: from 90 % of the limit, and a joint with less than 1° or 1 mm of its range "
        "left. Beyond: above the limit, for speeds by more than 2 %, which the servo may overshoot.",
        "margin": "Smallest distance of the attained joint coordinate from the limit.",
        "charts": "Drawn from the smallest and the largest sample of each short interval, so peaks are "
        "kept; values at the time cursor are read off the drawn curves. "
        "Tables are computed from all samples.",
    }
)
"""Name of a figure to its meaning."""

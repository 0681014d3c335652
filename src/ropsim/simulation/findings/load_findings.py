"""Load of an arm compared with its rated payload."""

from math import isfinite

from ropsim.core import Diagnostic
from ropsim.model import RobotModel
from ropsim.simulation.diagnostics.limit_diagnostics import PAYLOAD_EXCEEDED
from ropsim.simulation.findings.finished_station import FinishedStation

SLACK = 1e-9
"""Share by which sums of masses may be beyond the rated payload: they are rounded."""


def load_findings(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return S749 at the line with the heaviest load, if it is above the rated payload."""
    robot, loads, hz = station.robot, station.loads, station.hz
    if not loads.values or max(loads.values) <= robot.rated_payload * (1.0 + SLACK):
        return ()
    load = max(loads.values)
    tick = loads.ticks[loads.values.index(load)]
    finding = PAYLOAD_EXCEEDED.at(
        station.span_at(tick) or station.span_at(tick + 1),
        f"tool and parts have {load:.4g} kg, `{robot.name}` may carry {robot.rated_payload:.4g} kg",
        label=f"at t = {tick / hz:.2f} s",
        hint="take a lighter tool, fewer parts at a time, or an arm with a greater payload",
        data={"value": load, "limit": robot.rated_payload, "time_s": tick / hz},
    )
    return (finding,)


def has_rated_payloads(robots: list[RobotModel]) -> bool:
    """Return whether the loads of all arms can be checked, and there is one."""
    arms = [robot for robot in robots if robot.has_arm]
    return bool(arms) and all(isfinite(robot.rated_payload) for robot in arms)

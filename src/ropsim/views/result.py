"""The result of a run as a strip shows it: verdict, what it leaves open, the worst figure of each kind."""

from dataclasses import asdict

from ropsim.flow import AxisType, Settling
from ropsim.views.channels import Peak
from ropsim.views.joint_summary import (
    Closeness,
    JointSummary,
    closest_to_position_limit,
    closest_to_speed_limit,
    closest_to_torque_limit,
)
from ropsim.views.path_summary import PathMove
from ropsim.views.summary import Summary
from ropsim.views.verdict import verdict


def result_figures(summary: Summary) -> dict[str, object]:
    """Return the result as plain values in SI units; docs/reference/pack.md describes it."""
    state = verdict(summary)
    torque, speed = closest_to_torque_limit(summary.joints), closest_to_speed_limit(summary.joints)
    closest, worst = closest_to_position_limit(summary.joints), summary.path.worst
    return {
        "verdict": {"kind": state.kind.value, "text": state.text},
        "given": summary.unchecked.given,
        "unchecked": summary.unchecked.text,
        "cycle_time": summary.cycle_time,
        "cycle_time_valid": summary.cycle_time_valid,
        "settling": _settling(summary.settling),
        "peak_torque": torque and _peak(torque, torque.effort_share, torque.effort, torque.effort_closeness),
        "peak_speed": speed and _peak(speed, speed.speed_share, speed.speed, speed.speed_closeness),
        "closest_limit": closest and _margin(closest),
        "path_error": worst and _path_error(worst),
        "errors": summary.error_count,
        "warnings": summary.warning_count,
        "hints": summary.hint_count,
        "moves": sum(summary.moves.values()),
        "destinations": summary.destinations and asdict(summary.destinations),
    }


def _settling(settling: Settling) -> dict[str, object]:
    waited = settling.longest > 0.0
    return {
        "total": settling.total,
        "share": settling.share,
        "time": settling.time if waited else None,
        "station": settling.station if waited else "",
        "line": settling.line if waited else 0,
    }


def _peak(joint: JointSummary, share: float, peak: Peak, closeness: Closeness) -> dict[str, object]:
    return {
        "share": share,
        "closeness": closeness.value,
        "station": joint.station,
        "joint": joint.facts.name,
        "line": peak.line,
        "time": peak.time,
    }


def _margin(joint: JointSummary) -> dict[str, object]:
    near = joint.nearest
    return {
        "margin": near.margin,
        "unit": "rad" if joint.facts.type is AxisType.REVOLUTE else "m",
        "station": joint.station,
        "joint": joint.facts.name,
        "side": near.side,
        "line": near.line,
        "time": near.time,
    }


def _path_error(move: PathMove) -> dict[str, object]:
    return {"max": move.max_error, "station": move.station, "line": move.line, "time": move.time}

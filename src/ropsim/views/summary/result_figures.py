"""The figures of a result, from the summary of a run."""

from ropsim.flow import AxisType, Settling
from ropsim.views.channels import Peak
from ropsim.views.summary.joint_summary import (
    Closeness,
    JointSummary,
    closest_to_position_limit,
    closest_to_speed_limit,
    closest_to_torque_limit,
)
from ropsim.views.summary.path_summary import PathMove
from ropsim.views.summary.result import (
    ForceFigure,
    MarginFigure,
    PathFigure,
    PeakFigure,
    ResultFigures,
    SettlingFigure,
)
from ropsim.views.summary.summary import Summary
from ropsim.views.summary.verdict import verdict


def result_figures(summary: Summary) -> ResultFigures:
    """Return the result in SI units; docs/reference/pack.md describes it."""
    torque, speed = closest_to_torque_limit(summary.joints), closest_to_speed_limit(summary.joints)
    closest, worst = closest_to_position_limit(summary.joints), summary.path.worst
    return ResultFigures(
        verdict=verdict(summary),
        given=summary.unchecked.given,
        unchecked=summary.unchecked.text,
        cycle_time=summary.cycle_time,
        cycle_time_valid=summary.cycle_time_valid,
        cycle_time_by_hand=summary.by_hand.mark,
        settling=_settling(summary.settling) if summary.is_driven else None,
        peak_torque=_peak_torque(torque) if torque else None,
        peak_speed=_peak_speed(speed) if speed else None,
        closest_limit=_margin(closest) if closest else None,
        path_error=_path_error(worst) if worst else None,
        errors=summary.error_count,
        warnings=summary.warning_count,
        hints=summary.hint_count,
        moves=sum(summary.moves.values()),
        destinations=summary.destinations,
        contact_force=_contact_force(summary),
    )


def _contact_force(summary: Summary) -> ForceFigure | None:
    found = [
        ForceFigure(one.contact.value, one.facts.name, one.contact.line, one.contact.time)
        for one in summary.stations
        if one.contact
    ]
    return max(found, key=lambda one: one.max, default=None)


def _settling(settling: Settling) -> SettlingFigure:
    if settling.longest > 0.0:
        return SettlingFigure(settling.total, settling.share, settling.time, settling.station, settling.line)
    return SettlingFigure(settling.total, settling.share, None, "", 0)


def _peak_torque(joint: JointSummary) -> PeakFigure:
    return _peak(joint, joint.effort_share, joint.effort, joint.effort_closeness)


def _peak_speed(joint: JointSummary) -> PeakFigure:
    return _peak(joint, joint.speed_share, joint.speed, joint.speed_closeness)


def _peak(joint: JointSummary, share: float, peak: Peak, closeness: Closeness) -> PeakFigure:
    return PeakFigure(share, closeness, joint.station, joint.facts.name, peak.line, peak.time)


def _margin(joint: JointSummary) -> MarginFigure:
    near = joint.nearest
    return MarginFigure(
        near.margin,
        joint.margin_closeness,
        "rad" if joint.facts.type is AxisType.REVOLUTE else "m",
        joint.station,
        joint.facts.name,
        near.side,
        near.line,
        near.time,
    )


def _path_error(move: PathMove) -> PathFigure:
    return PathFigure(move.max_error, move.station, move.line, move.time)

"""The cards with the key figures in the HTML report."""

from ropsim.flow import SLOW
from ropsim.views.figures import MILLIMETRES, PERCENT, coordinate_scale, percent, seconds, with_unit
from ropsim.views.findings import place_text, plural
from ropsim.views.joint_summary import (
    JointSummary,
    closest_to_position_limit,
    closest_to_speed_limit,
    closest_to_torque_limit,
)
from ropsim.views.markup import text
from ropsim.views.summary import Summary


def key_figures(summary: Summary) -> str:
    """Return the cards with the key figures of a run."""
    moves = ", ".join(f"{count} {text(kind)}" for kind, count in summary.moves.items()) or "none"
    figures_ = [
        (
            "cycle time",
            f"{seconds(summary.cycle_time)} s",
            "settling included" if summary.cycle_time_valid else "not valid: see above",
        ),
        *_settling_figure(summary),
        ("in motion", percent(summary.share_in_motion), "of the cycle time"),
        ("moves", str(sum(summary.moves.values())), moves),
        ("gripper", str(summary.grips), f"grips, {summary.releases} releases"),
        *_destinations_figure(summary),
        *_path_figure(summary),
        *_joint_figures(summary.joints),
    ]
    cells = "".join(
        f"<div><dl><dt>{name}</dt><dd>{value}<small>{detail}</small></dd></dl></div>\n"
        for name, value, detail in figures_
    )
    return f'<section class="figures" aria-label="key figures">\n{cells}</section>\n'


def _settling_figure(summary: Summary) -> list[tuple[str, str, str]]:
    settling = summary.settling
    if summary.facts.is_kinematic:
        return []
    share = f"{with_unit(settling.share, PERCENT, 1)} of the cycle time"
    place = place_text(settling.line, settling.visit)
    longest = f"; longest {settling.longest:.3f} s{place}" if settling.longest > 0.0 else ""
    slow = f"; {plural(settling.slow, 'move')} longer than {SLOW * 1e3:g} ms" if settling.slow else ""
    return [("settling", f"{seconds(settling.total)} s", share + longest + slow)]


def _destinations_figure(summary: Summary) -> list[tuple[str, str, str]]:
    if summary.destinations is None:
        return []
    count = f"{summary.destinations.reached} of {summary.destinations.wanted}"
    return [("parts", count, "at their destination")]


def _path_figure(summary: Summary) -> list[tuple[str, str, str]]:
    if not summary.path.moves:
        return []
    mean = with_unit(summary.path.mean_error, MILLIMETRES, 3)
    return [("LIN path error, max", with_unit(summary.path.max_error, MILLIMETRES, 3), f"mean {mean}")]


def _joint_figures(joints: tuple[JointSummary, ...]) -> list[tuple[str, str, str]]:
    result = []
    torque, speed = closest_to_torque_limit(joints), closest_to_speed_limit(joints)
    if torque is not None:
        result.append(("peak torque", percent(torque.effort_share), _of_the_limit(torque)))
    if speed is not None:
        result.append(("peak speed", percent(speed.speed_share), _of_the_limit(speed)))
    closest = closest_to_position_limit(joints)
    if closest is not None:
        margin = with_unit(closest.nearest.margin, coordinate_scale(closest.facts.type), 1)
        result.append(("closest to a limit", margin, f"joint {text(closest.name)}, {closest.nearest.side}"))
    return result


def _of_the_limit(joint: JointSummary) -> str:
    return f"of the limit, joint {text(joint.name)}"

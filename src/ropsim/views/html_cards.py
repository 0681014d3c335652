"""The cards with the key figures in the HTML report."""

import math

from ropsim.views.figures import MILLIMETRES, coordinate_scale, percent, seconds, with_unit
from ropsim.views.joint_summary import JointSummary
from ropsim.views.markup import text
from ropsim.views.summary import Summary


def key_figures(summary: Summary) -> str:
    """Return the cards with the key figures of a run."""
    moves = ", ".join(f"{count} {text(kind)}" for kind, count in summary.moves.items()) or "none"
    figures_ = [
        (
            "cycle time",
            f"{seconds(summary.cycle_time)} s",
            f"settling {seconds(summary.settle_total)} s"
            if summary.cycle_time_valid
            else "not valid: see above",
        ),
        ("in motion", percent(summary.share_in_motion), "of the cycle time"),
        ("moves", str(sum(summary.moves.values())), moves),
        ("gripper", str(summary.grips), f"grips, {summary.releases} releases"),
        *_path_figure(summary),
        *_joint_figures(summary.joints),
    ]
    cells = "".join(
        f"<div><dl><dt>{name}</dt><dd>{value}<small>{detail}</small></dd></dl></div>\n"
        for name, value, detail in figures_
    )
    return f'<section class="figures" aria-label="key figures">\n{cells}</section>\n'


def _path_figure(summary: Summary) -> list[tuple[str, str, str]]:
    if not summary.path.moves:
        return []
    mean = with_unit(summary.path.mean_error, MILLIMETRES, 3)
    return [("LIN path error, max", with_unit(summary.path.max_error, MILLIMETRES, 3), f"mean {mean}")]


def _joint_figures(joints: tuple[JointSummary, ...]) -> list[tuple[str, str, str]]:
    result = []
    shares = (
        ("peak torque", [joint.effort_share for joint in joints]),
        ("peak speed", [joint.speed_share for joint in joints]),
    )
    for name, values in shares:
        worst = max(((value, k) for k, value in enumerate(values) if math.isfinite(value)), default=None)
        if worst is not None:
            detail = f"of the limit, joint {text(joints[worst[1]].facts.name)}"
            result.append((name, percent(worst[0]), detail))
    near = [joint for joint in joints if math.isfinite(joint.nearest.margin)]
    closest = min(near, key=lambda joint: joint.nearest.margin, default=None)
    if closest is not None:
        margin = with_unit(closest.nearest.margin, coordinate_scale(closest.facts.type), 1)
        result.append(
            ("closest to a limit", margin, f"joint {text(closest.facts.name)}, {closest.nearest.side}")
        )
    return result

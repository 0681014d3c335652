"""Workspaces and points of a task as text for a terminal."""

from ropsim.views.reach.words import dexterity_texts, extent_texts, left_text, volume_text, way_text
from ropsim.views.terminal.columns import Style, TableCell, Tone, columns_text, paint
from ropsim.views.words.characters import clean, fit
from ropsim.workspace import ArmStudy, Standing, Study, SweepKind

NAME = 20
WAY = 48
SHOWN = 12
"""Candidates in the ranking."""


def workspace_text(study: Study, style: Style) -> str:
    """Return the results for arms and the points of a task."""
    parts = [_arm(one, study, style) for one in study.arms]
    if len(study.standings) > 1:
        parts.append(_ranking(study.standings, style))
    if study.standings:
        parts.append(_points(study.standings[0], style))
    return "\n\n".join("\n".join(lines) for lines in parts)


def _arm(arm: ArmStudy, study: Study, style: Style) -> list[str]:
    robot = arm.robot
    lines = [paint(f"{clean(robot.name)}: {clean(robot.title)}, {study.kind.value}", Tone.STRONG, style)]
    if arm.workspace is None:
        return [*lines, "  no workspace, see above"]
    flat = arm.workspace.sweep.kind is SweepKind.FLAT
    volume = volume_text(arm.workspace.volume, arm.workspace.error, arm.workspace.sweep.measure)
    rows = [("reachable area" if flat else "reachable volume", volume)]
    rows += [*extent_texts(arm.workspace), *dexterity_texts(arm)]
    return [*lines, *(f"  {name:32} {value}" for name, value in rows)]


def _ranking(standings: tuple[Standing, ...], style: Style) -> list[str]:
    header = ("place", "points", "least margin", "manipulability", "missed by")
    rows = [
        (
            TableCell(f"{k}. {fit(clean(one.candidate.name), 40)}"),
            TableCell(
                f"{one.reached} of {len(one.checks)}", None if one.reached == len(one.checks) else Tone.ERROR
            ),
            TableCell(f"{100.0 * one.margin:.1f} %"),
            TableCell(f"{one.manipulability:.4f}"),
            TableCell(f"{1e3 * one.farthest:.1f} mm" if one.farthest else "–"),
        )
        for k, one in enumerate(standings[:SHOWN], start=1)
    ]
    rest = f" ({SHOWN} of {len(standings)})" if len(standings) > SHOWN else ""
    return [f"robots and places of their bases, the best one first{rest}", *columns_text(header, rows, style)]


def _points(standing: Standing, style: Style) -> list[str]:
    robot = standing.candidate.robot
    rows = [
        (
            TableCell(fit(clean(one.point.name), NAME)),
            TableCell("yes") if one.reach else TableCell("no", Tone.ERROR),
            TableCell(left_text(robot, one)),
            TableCell(fit(way_text(one), WAY)),
        )
        for one in standing.checks
    ]
    header = ("point", "reached", "left to a limit", "how, or what is missing")
    return [f"points, {clean(standing.candidate.name)}", *columns_text(header, rows, style)]

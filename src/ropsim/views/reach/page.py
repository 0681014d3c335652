"""Workspaces and points of a task as one HTML page that needs nothing else."""

from ropsim.version import __version__
from ropsim.views.markup.markup import table, text
from ropsim.views.markup.theme import stylesheet
from ropsim.views.reach.drawings import section_drawing, top_drawing
from ropsim.views.reach.words import dexterity_texts, extent_texts, left_text, volume_text, way_text
from ropsim.workspace import ArmStudy, Standing, Study, size_of

STYLE = """
svg .reached { fill: var(--c1); fill-opacity: .08; stroke: var(--c1); stroke-width: 1.5; }
svg .cell { fill: var(--c1); stroke: none; }
svg .arm polyline { stroke: var(--c2); stroke-width: 2.5; stroke-linecap: round; }
svg .missed { stroke: var(--bad); stroke-width: 2; fill: none; }
svg .around { fill: none; stroke: var(--c1); stroke-width: 1.4; stroke-dasharray: 6 4; }
svg .base { fill: var(--c2); }
.key i.area { height: 12px; border: 1.5px solid var(--c1); vertical-align: -1px; }
.key i.cells { height: 12px; border: 0; background: var(--c1); opacity: .5; vertical-align: -1px; }
.key i.cross { width: auto; height: auto; border: 0; color: var(--bad); font-style: normal; font-weight: 700;
  vertical-align: 0; }
.bar { display: inline-block; height: 9px; margin-left: 8px; background: var(--bar); border-radius: 2px; }
.bar, .rest { vertical-align: middle; } .rest { display: inline-block; height: 9px; }
"""
SHOWN = 20
"""Places of bases in the ranking."""
BAR = 90.0
"""Length of the bar of the whole share [px]."""
KEYS = (
    '<span class="key"><i class="area"></i>reached</span>',
    '<span class="key"><i class="c2"></i>arm at home</span>',
    '<span class="key"><i class="dot"></i>point reached</span>',
    '<span class="key"><i class="cross">✕</i>point missed</span>',
)
BASES = '<span class="key"><i class="cells"></i>share of points that other bases reach</span>'
CELLS = '<span class="key"><i class="cells"></i>share of tool directions</span>'


def workspace_page(study: Study) -> str:
    """Return the page: verdict on the points, figures and section of each arm, ranking, points, words."""
    names = ", ".join(one.robot.name for one in study.arms)
    body = [_header(study, names), *(_arm(one, study, k) for k, one in enumerate(study.arms))]
    if len(study.standings) > 1:
        body.append(_ranking(study.standings))
    if study.standings:
        body.append(_task(study))
    body += [_words(study), f"<footer>ropsim {text(__version__)}</footer>\n"]
    policy = "default-src &#39;none&#39;; style-src &#39;unsafe-inline&#39;"
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">\n'
        f"<title>{text(names)} – workspace</title>\n"
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f"<style>\n{stylesheet()}{STYLE}</style>\n</head>\n<body>\n<main>\n{''.join(body)}</main>\n"
        "</body>\n</html>\n"
    )


def _header(study: Study, names: str) -> str:
    verdict = ""
    if study.standings:
        best = study.standings[0]
        count, reached = len(best.checks), best.reached
        kind, sign = ("good", "✓") if reached == count else ("failed", "✕")
        sentence = f"{text(best.candidate.name)} reaches {reached} of {count} points"
        verdict = f'<p class="verdict {kind}"><span aria-hidden="true">{sign} </span>{sentence}</p>\n'
    quiet = (
        f"Workspace of the {text(study.kind.value)}, within the limits of the joints. "
        "Bodies that may be in the way are not looked at."
    )
    return f'<header>\n<h1>{text(names)}</h1>\n<p class="quiet">{quiet}</p>\n{verdict}</header>\n'


def _arm(arm: ArmStudy, study: Study, number: int) -> str:
    robot, space = arm.robot, arm.workspace
    notes = "".join(f'<p class="quiet">{text(one.message)}</p>\n' for one in arm.findings)
    head = f"<h2>{text(robot.title or robot.name)}</h2>\n"
    if space is None:
        return f"<section>{head}{notes}</section>\n"
    unit = "area" if space.sweep.measure == "m²" else "volume"
    figures = [(f"reachable {unit}", volume_text(space.volume, space.error, space.sweep.measure))]
    figures += [*extent_texts(space), *dexterity_texts(arm)]
    rows = [(text(name), text(value)) for name, value in figures]
    turned = arm.dexterity is not None and arm.dexterity.directions.count > 1
    keys = [*KEYS[:2], *([CELLS] if turned else []), *(KEYS[2:] if study.standings else ())]
    drawing = section_drawing(arm, study, f"section{number}")
    return (
        f'<section>{head}{notes}<div class="pair"><figure><figcaption>{"".join(keys)}</figcaption>\n'
        f"{drawing}</figure>\n<div>{table('workspace', ('', ''), rows)}</div></div></section>\n"
    )


def _ranking(standings: tuple[Standing, ...]) -> str:
    most = max((one.manipulability for one in standings), default=0.0) or 1.0
    rows = [
        (
            f"{k}. {text(one.candidate.name)}",
            f"{one.reached} of {len(one.checks)}{_bar(one.reached / len(one.checks))}",
            f"{100.0 * one.margin:.1f} %{_bar(one.margin)}",
            f"{one.manipulability:.4f}{_bar(one.manipulability / most)}",
            f"{1e3 * one.farthest:.1f} mm" if one.farthest else "–",
        )
        for k, one in enumerate(standings[:SHOWN], start=1)
    ]
    header = ("robot and place of its base", "points reached", "least margin", "manipulability", "missed by")
    rest = f", {SHOWN} of {len(standings)}" if len(standings) > SHOWN else ""
    return f"<section><h2>Ranking</h2>\n{table(f'the best one first{rest}', header, rows)}</section>\n"


def _bar(share: float) -> str:
    length = BAR * min(max(share, 0.0), 1.0)
    return (
        f'<span class="bar" style="width: {length:.0f}px"></span>'
        f'<span class="rest" style="width: {BAR - length:.0f}px"></span>'
    )


def _task(study: Study) -> str:
    best = study.standings[0]
    robot = best.candidate.robot
    rows = [
        (
            text(one.point.name),
            " ".join(f"{1e3 * float(value) + 0.0:.1f}" for value in one.point.position),
            '<span class="good">yes</span>' if one.reach else '<span class="mark">no</span>',
            text(left_text(robot, one)),
            f"{one.reach.manipulability:.4f}" if one.reach else "–",
            text(way_text(one)),
        )
        for one in best.checks
    ]
    header = (
        "point",
        "x y z [mm]",
        "reached",
        "left to a limit",
        "manipulability",
        "how, or what is missing",
    )
    drawing = top_drawing(study.standings, size_of(robot, study.X_MT), "top")
    others = sum(one.candidate.robot == robot for one in study.standings) > 2
    keys = "".join((*KEYS[2:], *((BASES,) if others else ())))
    return (
        f"<section><h2>Points, {text(best.candidate.name)}</h2>\n"
        f'<div class="pair"><figure><figcaption>from above; the dashed circle is the largest radius {keys}'
        f"</figcaption>\n{drawing}</figure><div></div></div>\n"
        f"{table('points of the task', header, rows)}</section>\n"
    )


def _words(study: Study) -> str:
    words = [
        ("reachable", "places that the point comes to in some orientation, within the limits of the joints"),
        ("error", "the difference to half of the steps, and what the lattice leaves open along the border"),
        ("section", "the workspace before the first axis turns or shifts it"),
    ]
    if any(one.dexterity is not None for one in study.arms):
        words.append(
            (
                "tool directions",
                "spread evenly over the sphere; one is reached where some turn about it is within limits",
            )
        )
    if study.standings:
        words += [
            ("margin", "distance to the nearest limit as a share of half of that joint's range"),
            (
                "manipulability",
                "√det(J·Jᵀ) of Yoshikawa (1985), lengths in units of the arm's reach; 0 where singular",
            ),
        ]
    rows = "".join(f"<dt>{text(word)}</dt><dd>{text(meaning)}</dd>\n" for word, meaning in words)
    return f'<section><h2>How the figures are defined</h2>\n<dl class="words">{rows}</dl></section>\n'

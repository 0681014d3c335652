"""Energy and use of the drives, as tables of the HTML report."""

from ropsim.core import SourceText
from ropsim.views.html.tables import source_cell
from ropsim.views.markup.markup import table, text
from ropsim.views.summary.drive_use import DriveUse
from ropsim.views.summary.energy_summary import EnergySummary
from ropsim.views.words.figures import (
    UNKNOWN,
    WATT_HOURS,
    digits,
    effort_scale,
    energy,
    fixed,
    joined_units,
    percent,
    power,
    seconds,
    speed_scale,
)

WITHOUT = "What amplifiers, controller and brakes take is no part of it."


def energy_section(found: EnergySummary | None, source: SourceText | None, of: str) -> str:
    """Return the section on the energy of a station; nothing where it is not known.

    Args:
        found: energy of the station.
        source: text of its program, None where it is not known.
        of: suffix of the heading, where there are several stations; HTML.
    """
    if found is None:
        return ""
    bound = f" <strong>({text(found.bound)})</strong>" if found.bound else ""
    whole = (
        f"<p>{energy(found.drawn)} drawn, {energy(found.given_back)} given back, {energy(found.net)} net; "
        f"{power(found.mean)} on average, at most {power(found.peak.value)} at {seconds(found.peak.time)} s "
        f"and at least {power(found.least.value)} at {seconds(found.least.time)} s."
        f"{bound}</p>\n"
    )
    rows = [
        (
            str(line.line) if line.line else UNKNOWN,
            str(line.passes) if line.passes else UNKNOWN,
            seconds(line.time),
            digits(line.drawn * WATT_HOURS.factor),
            percent(found.share(line)),
            digits(line.given_back * WATT_HOURS.factor),
            digits(line.drawn * WATT_HOURS.factor / line.passes) if line.passes else UNKNOWN,
            digits(line.peak),
            source_cell(source, line.line),
        )
        for line in found.lines
    ]
    header = (
        "line",
        "times",
        "time<br>[s]",
        "drawn<br>[Wh]",
        "share",
        "given back<br>[Wh]",
        "drawn each<br>time [Wh]",
        "most<br>[W]",
        "source",
    )
    lines = table(f"By the source line that is active; the lines sum to the whole. {WITHOUT}", header, rows)
    return f"<section><h2>Energy{of}</h2>\n{whole}{lines}</section>\n"


def drive_section(drives: tuple[DriveUse, ...], of: str) -> str:
    """Return the section on the use of the drives of a station; nothing without drives."""
    if not drives:
        return ""
    effort = joined_units(effort_scale(one.facts.type) for one in drives)
    speed = joined_units(speed_scale(one.facts.type) for one in drives).replace(" or ", "<br>or ")
    header = (
        "joint",
        f"torque<br>RMS [{effort}]",
        f"torque<br>max [{effort}]",
        "of<br>limit",
        "current<br>RMS [A]",
        "of<br>lasting",
        "current<br>max [A]",
        "of<br>limit",
        f"speed<br>max [{speed}]",
        "of<br>limit",
        "winding<br>max [K]",
        "of<br>limit",
        "power<br>max [W]",
        "drawn<br>[Wh]",
    )
    rows = [tuple(_cells(one)) for one in drives]
    shown = [k for k in range(len(header)) if k == 0 or any(row[k] != UNKNOWN for row in rows)]
    what = table(
        "RMS over the whole run; shares are those of limits of the model.",
        tuple(header[k] for k in shown),
        [tuple(row[k] for k in shown) for row in rows],
    )
    return f"<section><h2>Use of the drives{of}</h2>\n{what}</section>\n"


def _cells(one: DriveUse) -> tuple[str, ...]:
    effort, speed = effort_scale(one.facts.type), speed_scale(one.facts.type)
    return (
        text(one.name),
        digits(one.effort_rms * effort.factor),
        digits(one.effort.size * effort.factor),
        _share(one.effort_share),
        digits(one.current_rms),
        _share(one.lasting_current_share),
        digits(one.current.size),
        _share(one.current_share),
        fixed(one.speed.size, speed, 1),
        percent(one.speed_share),
        digits(one.rise.size),
        _share(one.rise_share),
        digits(one.power.value),
        digits(one.drawn * WATT_HOURS.factor),
    )


def _share(value: float) -> str:
    """Return a share of a limit, marked where it is beyond it; HTML."""
    return f'<span class="mark">beyond {percent(value)}</span>' if value > 1.0 else percent(value)

"""Energy and use of the drives, and contact forces, as text for a terminal."""

from ropsim.views.summary.drive_use import DriveUse
from ropsim.views.summary.energy_summary import EnergySummary
from ropsim.views.summary.findings import place_text
from ropsim.views.summary.station_summary import StationSummary
from ropsim.views.terminal.columns import Style, TableCell, Tone, columns_text
from ropsim.views.terminal.figures import COLUMNS, NAMES
from ropsim.views.words.characters import clean, fit, width
from ropsim.views.words.figures import (
    UNKNOWN,
    WATT_HOURS,
    WITHOUT_DRIVES,
    digits,
    effort_scale,
    energy,
    joined_units,
    percent,
    power,
    seconds,
)

SHOWN_LINES = 4


def energy_lines(station: StationSummary) -> list[str]:
    """Return the energy of a station, its peak, and the lines that take most of it."""
    found = station.energy
    if found is None:
        return [] if station.is_driven else [f"energy       {WITHOUT_DRIVES}"]
    lines = [f"energy       {_sum(found)}"]
    if digits(found.peak.value) != "0":
        lines.append(f"             {_peak(found)}")
    if found.bound:
        lines.append(fit(f"             {clean(found.bound)}", COLUMNS))
    if (most := [line for line in found.lines if line.line][:SHOWN_LINES]) and found.has_shares:
        shares = ", ".join(f"line {line.line} {percent(found.share(line))}" for line in most)
        lines.append(f"             most: {shares}")
    return lines


def contact_lines(station: StationSummary) -> list[str]:
    """Return the greatest contact force of a station; nothing where it touched nothing."""
    peak = station.contact
    if peak is None:
        return []
    return [
        f"contact      at most {digits(peak.value)} N at {seconds(peak.time)} s{place_text(peak.line, 0)}"
    ]


def drive_lines(drives: tuple[DriveUse, ...], style: Style) -> list[str]:
    """Return the use of the drives as a table, without columns of which nothing is known.

    Of many columns the last ones are left to the report, where they would not fit.
    """
    if not drives:
        return []
    units = joined_units(effort_scale(one.facts.type) for one in drives)
    titles = (
        "drive",
        f"torque\nRMS {units}",
        "current\nRMS A",
        "of\nlasting",
        "current\nmax A",
        "of\nlimit",
        "winding\nmax K",
        "of\nlimit",
        "power\nmax W",
        "drawn\nWh",
    )
    rows = [_row(one) for one in drives]
    shown = [k for k in range(len(titles)) if k == 0 or any(row[k].text != UNKNOWN for row in rows)]
    while len(shown) > 1 and max(map(width, _table(titles, rows, shown, Style.PLAIN))) > COLUMNS:
        shown.pop()
    return _table(titles, rows, shown, style) if len(shown) > 1 else []


def _table(
    titles: tuple[str, ...], rows: list[tuple[TableCell, ...]], shown: list[int], style: Style
) -> list[str]:
    cells = [tuple(row[k] for k in shown) for row in rows]
    return columns_text(tuple(titles[k] for k in shown), cells, style)


def _sum(found: EnergySummary) -> str:
    back = energy(found.given_back)
    back = f", {back} given back" if back != energy(0.0) else ""
    return f"{energy(found.drawn)} drawn{back}; {power(found.mean)} on average"


def _peak(found: EnergySummary) -> str:
    peak = found.peak
    return f"at most {power(peak.value)} at {seconds(peak.time)} s{place_text(peak.line, 0)}"


def _row(one: DriveUse) -> tuple[TableCell, ...]:
    return (
        TableCell(fit(clean(one.name), NAMES)),
        TableCell(digits(one.effort_rms * effort_scale(one.facts.type).factor)),
        TableCell(digits(one.current_rms)),
        _share(one.lasting_current_share),
        TableCell(digits(one.current.size)),
        _share(one.current_share),
        TableCell(digits(one.rise.size)),
        _share(one.rise_share),
        TableCell(digits(one.power.value)),
        TableCell(digits(one.drawn * WATT_HOURS.factor)),
    )


def _share(value: float) -> TableCell:
    return TableCell(percent(value), Tone.ERROR if value > 1.0 else None)

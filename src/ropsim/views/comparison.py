"""A run compared with runs with changes: table for a terminal and for the HTML report."""

import math

from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.views.markup.markup import table, text
from ropsim.views.terminal.columns import Style, TableCell, Tone, columns_text
from ropsim.views.words.characters import clean, fit
from ropsim.views.words.figures import UNKNOWN, seconds

_NAMES = 28
_SHOWN_CODES = 3


@frozen_dataclass
class Alternative:
    """Result of a run with one change.

    Attributes:
        change: as people write it.
        cycle_time: with it [s].
        valid: whether the whole program was carried out, so that the cycle time is that of the program.
        findings: not in the unchanged run, each once.
        energy: that all drives draw with it [J]; NaN where it is not known.
    """

    change: str
    cycle_time: float
    valid: bool
    findings: tuple[Diagnostic, ...]
    energy: float = math.nan


@frozen_dataclass
class Comparison:
    """A run compared with others with one change each.

    Attributes:
        cycle_time: of the unchanged run [s].
        alternatives: in the order of the requests.
        notes: why others were not tried.
        energy: that all drives of the unchanged run draw [J]; NaN where it is not known.
    """

    cycle_time: float
    alternatives: tuple[Alternative, ...]
    notes: tuple[Diagnostic, ...] = ()
    energy: float = math.nan

    def difference(self, alternative: Alternative) -> float:
        """Return by how much longer the program takes with a change [s]; NaN where that says nothing."""
        return alternative.cycle_time - self.cycle_time if alternative.valid else math.nan

    def energy_difference(self, alternative: Alternative) -> float:
        """Return by how much more energy the drives draw with a change [J]; NaN where that says nothing."""
        return alternative.energy - self.energy if alternative.valid else math.nan


def comparison_text(comparison: Comparison, style: Style) -> str:
    """Return the table for a terminal of 80 columns, ending in a line feed; nothing for no alternatives."""
    if not comparison.alternatives:
        return ""
    rows = [
        (
            TableCell("as it is"),
            TableCell(seconds(comparison.cycle_time)),
            TableCell(""),
            TableCell(""),
            *([TableCell("")] if math.isfinite(comparison.energy) else []),
            TableCell(""),
        )
    ]
    for one in comparison.alternatives:
        tone = Tone.WARNING if one.findings else None
        time, difference, share = _figures(comparison, one)
        change = TableCell(fit(clean(one.change), _NAMES))
        rows.append(
            (
                change,
                TableCell(time),
                TableCell(difference),
                TableCell(share),
                *(TableCell(text) for text in _energy(comparison, one)),
                TableCell(_findings(one), tone),
            )
        )
    drawn = ["energy %"] if math.isfinite(comparison.energy) else []
    title = ("what if", "cycle time s", "difference s", "%", *drawn, "new findings")
    return "\n".join(line.replace("\u00a0", " ") for line in columns_text(title, rows, style)) + "\n"


def comparison_section(comparison: Comparison | None) -> str:
    """Return the section of the HTML report; nothing where nothing was compared."""
    if comparison is None:
        return ""
    known = ("",) if math.isfinite(comparison.energy) else ()
    rows = [
        ("as it is", seconds(comparison.cycle_time), "", "", *known, ""),
        *(
            (text(one.change), *_figures(comparison, one), *_energy(comparison, one), text(_findings(one)))
            for one in comparison.alternatives
        ),
    ]
    drawn = ("energy<br>[%]",) * len(known)
    header = ("change", "cycle time<br>[s]", "difference<br>[s]", "[%]", *drawn, "new findings")
    what = "The same program with one change each: what it would take, and what would be found."
    shown = table(what, header, rows) if comparison.alternatives else ""
    notes = "".join(f"<p>{text(note.message)}</p>\n" for note in comparison.notes)
    return f"<section><h2>What if</h2>\n{shown}{notes}</section>\n"


def _figures(comparison: Comparison, one: Alternative) -> tuple[str, str, str]:
    """Return time, difference and its share of the unchanged time."""
    difference = comparison.difference(one)
    if not math.isfinite(difference):
        return seconds(one.cycle_time), "not valid", UNKNOWN
    share = difference / comparison.cycle_time * 100.0 if comparison.cycle_time > 0.0 else math.nan
    return (
        seconds(one.cycle_time),
        f"{difference:+.2f}",
        f"{share:+.1f}" if math.isfinite(share) else UNKNOWN,
    )


def _energy(comparison: Comparison, one: Alternative) -> tuple[str, ...]:
    """Return the share by which more energy is drawn; nothing where that of the unchanged run is unknown."""
    if not math.isfinite(comparison.energy):
        return ()
    difference = comparison.energy_difference(one)
    if not (math.isfinite(difference) and comparison.energy > 0.0):
        return (UNKNOWN,)
    return (f"{difference / comparison.energy * 100.0:+.1f}",)


def _findings(one: Alternative) -> str:
    """Return which findings are new: codes and their names, with the lines that they stand on."""
    names = ((f"{found.code} {found.slug}", found.span) for found in one.findings)
    place_words = (f"{name} line {span.line}" if span else name for name, span in names)
    places = list(dict.fromkeys(place_words))
    more = len(places) - _SHOWN_CODES
    return ", ".join(places[:_SHOWN_CODES]) + (f" and {more} more" if more > 0 else "")

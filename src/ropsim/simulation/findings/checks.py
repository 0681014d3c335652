"""Checks of a run that has ended, one function each: a new one is a file and an entry here."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import replace

from ropsim.core import Diagnostic
from ropsim.icr import Program
from ropsim.simulation.findings.finished_station import FinishedStation
from ropsim.simulation.findings.load_findings import load_findings
from ropsim.simulation.findings.settling import settling_findings
from ropsim.simulation.findings.slow_lines import slow_lines
from ropsim.simulation.findings.torn_oil import drained_supplies, torn_oil
from ropsim.simulation.findings.verdicts import verdicts

CHECKS: tuple[Callable[[FinishedStation], tuple[Diagnostic, ...]], ...] = (
    verdicts,
    torn_oil,
    drained_supplies,
    load_findings,
    settling_findings,
    slow_lines,
)
"""In the order of their findings."""


def station_findings(station: FinishedStation) -> list[Diagnostic]:
    """Return the findings of all checks of a station."""
    return [found for check in CHECKS for found in check(station)]


def findings_at(
    station: str, programs: Mapping[str, Program], found: Iterable[Diagnostic]
) -> list[Diagnostic]:
    """Return findings of a station; they name it where others run the same program.

    Args:
        station: its name.
        programs: verified ICR by station.
        found: findings of the station.
    """
    sources = [program.source for program in programs.values()]
    if station not in programs or sources.count(programs[station].source) == 1:
        return list(found)
    return [one if "station" in one.data else _named(one, station) for one in found]


def _named(found: Diagnostic, station: str) -> Diagnostic:
    notes = (*found.notes, f"at station `{station}`")
    return replace(found, notes=notes, data={**found.data, "station": station})

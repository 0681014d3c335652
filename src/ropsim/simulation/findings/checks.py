"""Checks of a run that has ended, one function each: a new one is a file and an entry here."""

from collections.abc import Callable

from ropsim.core import Diagnostic
from ropsim.simulation.findings.finished_station import FinishedStation
from ropsim.simulation.findings.load_findings import load_findings
from ropsim.simulation.findings.settling import settling_findings
from ropsim.simulation.findings.torn_oil import torn_oil
from ropsim.simulation.findings.verdicts import verdicts

CHECKS: tuple[Callable[[FinishedStation], tuple[Diagnostic, ...]], ...] = (
    verdicts,
    torn_oil,
    load_findings,
    settling_findings,
)
"""In the order of their findings."""


def station_findings(station: FinishedStation) -> list[Diagnostic]:
    """Return the findings of all checks of a station."""
    return [found for check in CHECKS for found in check(station)]

"""Programs that several stations run: findings in one name the stations."""

from collections.abc import Iterable, Mapping
from dataclasses import replace

from ropsim.core import Diagnostic
from ropsim.icr import Program


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

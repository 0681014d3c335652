"""Endless holds: found at once, without waiting."""

from ropsim.core import Diagnostic
from ropsim.flow import SLOWEST
from ropsim.simulation.diagnostics.input_diagnostics import HELD_FOR_EVER
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun


def is_endless_hold(run: CellRun, at: StationRun) -> bool:
    """Return whether a station stands because the override is 0, and no change of it is to come.

    An observer may still change it.
    """
    if at.in_vain or not (at.is_held and run.overrides):
        return False
    tick, value = run.overrides[-1]
    return value == 0.0 and tick <= at.due


def hold_finding(run: CellRun, at: StationRun) -> Diagnostic:
    """Return that a station is held for ever (S762).

    Args:
        run: the cell.
        at: a station in an endless hold.
    """
    since = run.overrides[-1][0] / run.hz
    return HELD_FOR_EVER.at(
        at.origin.span,
        f"`{at.station.name}` is held for ever: the override is 0 from t = {since:.2f} s on, "
        f"and no change of it comes after that",
        label=f"pass {at.origin.visit}",
        hint=f"add a change of the override after that, such as 1 (less than {SLOWEST:g} counts as 0), "
        "or end the inputs before the hold",
        data={"station": at.station.name, "time_s": since, **at.origin.data},
    )

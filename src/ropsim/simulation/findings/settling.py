"""The hint that settling after moves takes a good part of the cycle."""

from ropsim.core import Diagnostic
from ropsim.flow import SLOW, settling_of
from ropsim.simulation.diagnostics.run_diagnostics import LONG_SETTLING
from ropsim.simulation.findings.finished_station import FinishedStation

SHARE = 0.02
"""Share of the cycle time above which settling is worth a hint."""


def settling_findings(station: FinishedStation) -> tuple[Diagnostic, ...]:
    """Return S725 where settling takes more than `SHARE` and a move more than `SLOW`, at the longest one."""
    settling = settling_of(station.events, station.duration)
    if settling.share <= SHARE or not settling.slow:
        return ()
    finding = LONG_SETTLING.at(
        station.span_of(settling.line),
        f"settling after moves takes {settling.total:.2f} s, {settling.share * 100.0:.1f} % of the cycle "
        f"time; moves that settle longer than {SLOW * 1e3:g} ms: {settling.slow}",
        label=f"longest here: {settling.longest:.3f} s, pass {settling.visit}",
        hint=station.circumstances(round(settling.time * station.hz)).hint(
            "raise the gains or widen `in_position` in `[controller]` of the cell file"
        ),
        data={
            "settling_s": settling.total,
            "share": settling.share,
            "slow_moves": settling.slow,
            "longest_s": settling.longest,
            "time_s": settling.time,
        },
    )
    return (finding,)

"""Processor time of a process and all that it has started, from /proc."""

import os
import sys
from pathlib import Path

PROC = Path("/proc")
HAS_PROC = sys.platform == "linux"


def processor_time(pid: int) -> float:
    """Return the processor time that a process and its living descendants have used so far [s]."""
    parents: dict[int, int] = {}
    ticks: dict[int, int] = {}
    for place in PROC.iterdir():
        if not place.name.isdigit():
            continue
        try:
            # behind the name, which may hold spaces: state, parent, …, user and system time
            fields = (place / "stat").read_text("utf-8").rsplit(")", 1)[1].split()
        except (FileNotFoundError, ProcessLookupError):
            continue
        parents[int(place.name)] = int(fields[1])
        ticks[int(place.name)] = int(fields[11]) + int(fields[12])
    family = {pid}
    while grown := {child for child, parent in parents.items() if parent in family} - family:
        family |= grown
    return sum(ticks.get(one, 0) for one in family) / os.sysconf("SC_CLK_TCK")

"""Laws of cells at random: whatever stations, devices and programs do, time and parts stay in order.

`ROPSIM_RANDOM_CELLS=1000 python -m pytest tests/property/test_random_cells.py` tries more of them.
"""

import os
from dataclasses import replace
from functools import cache
from itertools import pairwise

import numpy as np
import pytest

from ropsim.flow import Fidelity, Recording, TaskEvent
from ropsim.icr import Program
from ropsim.model import WORLD, Cell
from ropsim.simulation import RunOptions, RunView, run
from ropsim.simulation.testing import CellRun, Placements
from support.examples import examples
from support.random_cells import random_cell

COUNT = int(os.environ.get("ROPSIM_RANDOM_CELLS", examples(30)))
OPTIONS = RunOptions(Fidelity.KINEMATIC, record_hz=50, longest=15.0, longest_wait=5.0)
ROUNDING = 1e-9  # [s]


class Inspector:
    """Looks at the parts of a run whenever something has been done."""

    may_press = False

    def __init__(self, cell: Cell) -> None:
        self.all = {part.name for part in cell.parts}
        self.tick = 0
        self.looks = 0
        self.seen: Placements | None = None

    def advanced(self, run: RunView) -> None:
        assert isinstance(run, CellRun)
        assert run.tick >= self.tick
        self.tick = run.tick
        self.looks += 1
        if run.parts is self.seen:  # nothing can change them: what held of them holds
            return
        self.seen = run.parts
        self.sum_is_constant(run)
        self.every_part_has_its_seat(run)
        for at in run.stations.values():
            assert sum(seat.parent in at.hands for seat in run.parts.seats.values()) <= 1

    def sum_is_constant(self, run: CellRun) -> None:
        groups = (set(run.parts.seats), set(run.parts.queued), set(run.parts.left))
        assert set.union(*groups) == self.all
        assert sum(map(len, groups)) == len(self.all)

    def every_part_has_its_seat(self, run: CellRun) -> None:
        hands = {hand for at in run.stations.values() for hand in at.hands}
        bodies = {body for device in run.devices.values() for body in device.bodies}
        for name, seat in run.parts.seats.items():
            assert seat.rides in {WORLD, *hands, *bodies}
            assert np.isfinite(seat.pose.position).all()
            assert seat.parent in {WORLD, *hands, *run.scenery.objects, *bodies, *run.parts.seats}
            family = run.parts.family(name)
            assert len(set(family)) == len(family)  # nothing hangs on itself
            if seat.parent in hands:
                assert seat.rides == seat.parent
            if seat.parent in run.parts.seats:
                assert seat.rides == run.parts.seats[seat.parent].rides

    def reading(self, run: RunView) -> None:
        pass

    def ended(self, run: RunView) -> None:
        coarsest = max(at.cell_ticks for at in run.stations.values())
        assert all(run.tick - at.due < coarsest for at in run.stations.values())  # they came together


def in_order_of_time(recording: Recording) -> None:
    assert (np.diff([one.time for one in recording.events]) >= 0.0).all()
    assert (np.diff([one.time for one in recording.placements]) >= 0.0).all()
    for name in {one.station for one in recording.events if one.station}:
        own = [one for one in recording.events if one.station == name and not isinstance(one, TaskEvent)]
        for before, after in pairwise(sorted(own, key=lambda one: (one.time, one.end))):
            assert after.time >= before.end - ROUNDING
    for channel in recording.channels.values():
        if channel.times is not None:
            assert (np.diff(channel.times) > 0.0).all()
    assert all(one.end <= recording.duration + ROUNDING for one in recording.events)


def the_same(one: Recording, other: Recording) -> None:
    assert one.events == other.events
    assert one.findings == other.findings
    assert one.placements == other.placements
    assert set(one.channels) == set(other.channels)
    assert all(one.channels[name] == other.channels[name] for name in one.channels)


@cache
def ran(seed: int) -> tuple[Cell, dict[str, Program], Recording]:
    """Return a cell at random, its programs and what comes of them where nobody looks on."""
    cell, codes = random_cell(np.random.default_rng(seed))
    return cell, codes, run(cell, codes, OPTIONS)


@pytest.mark.parametrize("seed", range(COUNT))
def test_time_and_parts_stay_in_order_in_cells_at_random(seed: int) -> None:
    cell, codes, unseen = ran(seed)
    inspector = Inspector(cell)
    recording = run(cell, codes, replace(OPTIONS, watch=inspector))
    assert inspector.looks > 0
    in_order_of_time(recording)
    the_same(recording, unseen)
    if seed % 3:
        return
    assert recording.placements == run(cell, codes, replace(OPTIONS, record_hz=7)).placements
    back = replace(cell, stations=dict(reversed(list(cell.stations.items()))))
    turned = run(back, codes, OPTIONS)
    assert all(recording.channels[name] == turned.channels[name] for name in recording.channels)
    assert {str(one) for one in recording.findings} == {str(one) for one in turned.findings}


def test_cells_at_random_are_not_idle() -> None:
    """Parts are taken over, pulled and lost, and waits are in vain: the laws above look at all of this."""
    codes: set[str] = set()
    grips = taken = left = 0
    for seed in range(15):
        cell, _, recording = ran(seed)
        codes |= {found.code for found in recording.findings}
        for part in cell.parts:
            parents = [one.parent for one in recording.placements if one.body == part.name]
            grips += any("tool:" in one for one in parents)
            taken += sum("tool:" in one and "tool:" in other for one, other in pairwise(parents))
        left += len(recording.facts.parts_left)
    assert grips > 10
    assert taken > 0
    assert left > 0
    assert {"S721", "S736", "S742", "S743"} <= codes

"""Compression of short moves: time for each point, which does not grow with their number."""

from functools import partial
from typing import Any

import pytest
from measuring import Measure, processor_seconds

from ropsim.motion import compressed
from support.straight_chains import contour, wave

MOST_PER_POINT = 50e-6  # [s]


@pytest.mark.parametrize("kind", ["wave", "contour"])
def test_a_chain_takes_the_same_time_for_each_point(kind: str, benchmark: Any) -> None:
    chains = [
        wave(count, 2.5e-3, 1e-3) if kind == "wave" else contour(count) for count in (500, 1000, 10_000)
    ]
    measure = Measure(benchmark)
    measure(lambda: compressed(*chains[0]))
    times = processor_seconds(*[partial(compressed, *given) for given in chains])
    for given, time in zip(chains, times, strict=True):
        count = len(given.points)
        measure.figure(f"us for each of {count} points", 1e6 * time / count, most=1e6 * MOST_PER_POINT)
    measure.figure("10,000 points by 1,000", times[2] / times[1], most=13.0)

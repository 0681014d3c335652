"""Measuring: pytest-benchmark with types, and with the best and median time at hand."""

from collections.abc import Callable
from dataclasses import dataclass
from time import process_time
from typing import Any, TypeVar

T = TypeVar("T")


@dataclass(frozen=True)
class Timing:
    """Seconds of one call."""

    best: float
    median: float


class Measure:
    """Times calls; figures derived from them go into the benchmark's extra info."""

    def __init__(self, benchmark: Any) -> None:
        self._benchmark = benchmark

    def __call__(self, function: Callable[[], T], rounds: int = 5, warmup: int = 1) -> tuple[T, Timing]:
        """Return the result of the last call and the times."""
        result: T = self._benchmark.pedantic(function, rounds=rounds, warmup_rounds=warmup)
        stats = self._benchmark.stats.stats
        return result, Timing(stats.min, stats.median)

    def figure(
        self, name: str, value: float, *, least: float = float("-inf"), most: float = float("inf")
    ) -> None:
        """Enter a derived figure; one outside of its budget fails the benchmark."""
        self._benchmark.extra_info[name] = value
        print(f"\n    {name}: {value:.6g}", end="")
        assert least <= value <= most, f"{name}: {value:.6g} is not within [{least:g}, {most:g}]"


def processor_seconds(*functions: Callable[[], object], rounds: int = 5) -> tuple[float, ...]:
    """Return the least processor time of each function; they are called in turn, so that ratios hold."""
    best = [float("inf")] * len(functions)
    for _ in range(rounds):
        for k, function in enumerate(functions):
            start = process_time()
            function()
            best[k] = min(best[k], process_time() - start)
    return tuple(best)

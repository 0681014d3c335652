"""Time as Prolog sees it: only reading the clock moves it, so that equal programs find equal times."""

import struct
from collections.abc import Callable
from time import gmtime

from ropsim.prolog.wasm.memory import LinearMemory

BEGIN_NS = 1_600_000_000_000_000_000
"""The time at which every engine starts, in nanoseconds since 1970; an arbitrary one."""
STEP_NS = 1000
"""Step of the clock for each reading."""


class ClockCalls:
    """Answers the calls about time of one program; the time zone is UTC.

    Attributes:
        elapsed_ns: time since the start, at the last reading [ns].
    """

    memory: LinearMemory

    def __init__(self) -> None:
        self.elapsed_ns = 0

    def table(self) -> dict[str, Callable[..., float | int | None]]:
        """Return the function of each call by the name of its import."""
        return {
            "clock_time_get": self._time,
            "emscripten_get_now": lambda: self._look() / 1e6,
            "emscripten_date_now": lambda: (BEGIN_NS + self._look()) / 1e6,
            "_tzset_js": self._zone,
            "_localtime_js": self._local,
            "_mktime_js": lambda _record: 0,
        }

    def _look(self) -> int:
        self.elapsed_ns += STEP_NS
        return self.elapsed_ns

    def _time(self, clock: int, _precision: int, result: int) -> int:
        self.memory.pack(result, "<Q", self._look() + (BEGIN_NS if clock == 0 else 0))
        return 0

    def _zone(self, seconds: int, daylight: int, name: int, other_name: int) -> None:
        for address in (seconds, daylight):
            self.memory.pack(address, "<I", 0)
        for address in (name, other_name):
            self.memory.write(address, b"UTC\0")

    def _local(self, seconds: int, record: int) -> int:
        at = gmtime(max(min(seconds, 1 << 40), 0))
        fields = (at.tm_sec, at.tm_min, at.tm_hour, at.tm_mday, at.tm_mon - 1, at.tm_year - 1900)
        self.memory.write(record, struct.pack("<9ii", *fields, (at.tm_wday + 1) % 7, at.tm_yday - 1, 0, 0))
        return 0

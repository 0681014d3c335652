"""How long each activation of a task lasts."""

from dataclasses import dataclass, field

from ropsim.flow import Origin, TaskEvent


@dataclass(slots=True)
class Activation:
    """One run of one task: from its first to its last robot instruction."""

    name: str
    depth: int
    start: int
    end: int


@dataclass(slots=True)
class Activations:
    """All activations of a run by their serial number (0 is `main`)."""

    by_serial: dict[int, Activation] = field(default_factory=dict)

    def add(self, origin: Origin, start: int, end: int) -> None:
        """Count an instruction that lasted from tick `start` to tick `end` for all tasks around it."""
        for depth, (name, serial) in enumerate(zip(origin.calls, origin.call_serials, strict=True)):
            known = self.by_serial.get(serial)
            if known is None:
                self.by_serial[serial] = Activation(name, depth, start, end)
            else:
                known.end = max(known.end, end)

    def begin(self, origin: Origin, tick: int) -> None:
        """Take notice that an instruction begins at a tick: the tasks around it are active from then on."""
        for depth, (name, serial) in enumerate(zip(origin.calls, origin.call_serials, strict=True)):
            if serial not in self.by_serial:
                self.by_serial[serial] = Activation(name, depth, tick, tick)

    def events(self, station: str, control_hz: int) -> list[TaskEvent]:
        """Return one event per activation below `main` of the program of a station."""
        below = [serial for serial in sorted(self.by_serial) if self._is_below_main(serial)]
        return [self.event(serial, station, control_hz) for serial in below]

    def around(self, origin: Origin, station: str, control_hz: int) -> list[TaskEvent]:
        """Return the activations below `main` around an instruction, each with its duration so far."""
        return [
            self.event(serial, station, control_hz)
            for serial in origin.call_serials
            if serial in self.by_serial and self._is_below_main(serial)
        ]

    def event(self, serial: int, station: str, control_hz: int) -> TaskEvent:
        """Return an activation as the event that it is in the recording of a station."""
        one = self.by_serial[serial]
        time, duration = one.start / control_hz, (one.end - one.start) / control_hz
        return TaskEvent(time, duration, station, name=one.name, serial=serial, depth=one.depth)

    def _is_below_main(self, serial: int) -> bool:
        return self.by_serial[serial].depth > 0

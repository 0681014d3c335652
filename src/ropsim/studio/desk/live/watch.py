"""A run at the pace of a clock: it waits where the clock has not come yet, and is shown meanwhile."""

from collections import deque
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, field, replace

from msgspec import convert

from ropsim.flow import Event, MoveEvent
from ropsim.icr import Program
from ropsim.simulation import RunView
from ropsim.studio.desk.clock import PacedClock
from ropsim.studio.desk.line import Line
from ropsim.studio.desk.live.frame import Frames
from ropsim.studio.desk.live.hand import Hand
from ropsim.studio.desk.live.keys import Keys, Stamp
from ropsim.studio.wire.live_messages import Happened, LiveStatus, Placed, SignalStamped
from ropsim.studio.wire.messages import Notice, notice, plain
from ropsim.studio.wire.orders import LiveControl, LiveOverride, LiveSpeed, Order, SetSignal
from ropsim.studio.wire.replies import LiveMessage
from ropsim.views import ShownPlacements, packed_event

FRAME = 1.0 / 60.0
"""Time between two frames [s of the wall clock]."""

GROW = 0.25
"""Interval of updates on the duration of running tasks [s of the wall clock]."""

LONGEST_NAP, SHORTEST_NAP = 0.25, 1e-4
"""How long the run waits at a time for orders [s of the wall clock]."""

ROUNDING = 1e-9
"""Ends of events are sums of two times, the clock's are not [s]."""


@dataclass(slots=True)
class LivePace:
    """Lets a run keep pace, shows it and applies orders (`ropsim.simulation.Watch`).

    A watched run goes on in slices of an interpolation tick. Each is computed when the one before it has been
    shown, so that interventions act within a slice of the shown state.

    Attributes:
        program: name of the requested program, for messages.
        programs: programs of the stations.
        clock: the simulated time that is shown.
        line: orders in, messages out.
        wall: returns the time of the wall clock [s].
        day: returns the time of day [s], for the frames.
        frames: made when the run starts.
        keys: stamps key presses.
        placed: converts placements to messages for the page; made when the run starts.
        told: number of placements already processed.
        news: messages on parts and events whose time has not come yet.
        heard: number of events already processed.
        shown: when the last frame was due [s of the wall clock].
        grown: time of the last update on the duration of running tasks [s of the wall clock].
        newest_sent: serial of the newest task already sent, by station.
        hand: holds, slows and ends the run.
    """

    program: str
    programs: Mapping[str, Program]
    clock: PacedClock
    line: Line
    wall: Callable[[], float]
    day: Callable[[], float]
    frames: Frames | None = None
    keys: Keys | None = None
    placed: ShownPlacements | None = None
    told: int = 0
    news: deque[tuple[float, LiveMessage]] = field(default_factory=deque)
    heard: int = 0
    shown: float = float("-inf")
    grown: float = float("-inf")
    newest_sent: dict[str, int] = field(default_factory=dict)
    hand: Hand = field(default_factory=Hand)

    @property
    def may_press(self) -> bool:
        """Return True: the user may press a key at any time."""
        return True

    def advanced(self, run: RunView) -> None:
        """Wait until the computed part is shown.

        Raises:
            Cancelled: the run was given up.
        """
        self._hear(run)
        if (ended := self.hand.look(run)) is not None:
            self._tell_state()
            self._tell_behind(ended)
        self.clock.extend(run.time)
        self._show_until(run, run.time)

    def reading(self, run: RunView) -> None:
        """Let the program look; keys that are pressed from now on come later."""
        self._begin(run)
        if self.keys is not None:
            self.keys.looked = run.tick

    def ended(self, run: RunView) -> None:
        """Wait until all of the run has been shown.

        Raises:
            Cancelled: the run was given up.
        """
        self._hear(run)
        self.clock.extend(run.time)
        self._show_until(run, run.time)

    def _begin(self, run: RunView) -> None:
        if self.frames is None:
            self.keys = Keys(run.cell)
            self.frames = Frames(run, self.programs)
            self.placed = ShownPlacements(run.scenery.tree)
            self.line.report(self.frames.layout())
            self._tell_state()

    def _hear(self, run: RunView) -> None:
        """Take in events since the last call."""
        self._begin(run)
        self.news += [(run.time, message) for message in self._moved(run)]
        self.news += [(one.end, happened(one)) for one in self._events(run)]
        self.news += [(run.time, happened(one)) for one in self._going_on(run)]

    def _moved(self, run: RunView) -> list[LiveMessage]:
        """Return a message for each body that has another place since the last look."""
        if self.placed is None:
            return []
        known, placed = len(self.placed.places), self.placed
        news = [
            LiveMessage(plain(convert({"type": "placed", "body": placed.places[name], **told}, Placed)))
            for number, placement in enumerate(run.placements[self.told :], start=self.told)
            for name, told in placed.take(placement)
            if number >= known  # the first ones, one for each body, are already in the scene
        ]
        self.told = len(run.placements)
        return news

    def _events(self, run: RunView) -> list[Event]:
        """Return the events since the last call, and the tasks extended by them."""
        news = [*run.events[self.heard :]]
        self.heard = len(run.events)
        tasks: dict[tuple[str, int], Event] = {}
        for one in news:
            if one.origin and one.station in run.stations:
                at = run.stations[one.station]
                around = at.activations.around(one.origin, one.station, at.hz)
                tasks |= {(task.station, task.serial): task for task in around}
        return [*news, *tasks.values()]

    def _going_on(self, run: RunView) -> Iterator[Event]:
        """Yield tasks that have begun since the last look, and now and then how long all are that go on."""
        if grown := self.wall() >= self.grown + GROW:
            self.grown = self.wall()
        for name, at in run.stations.items():
            if not at.is_busy:
                continue
            for task in at.activations.around(at.origin, name, at.hz):
                if grown or self.newest_sent.get(name, 0) < task.serial:
                    self.newest_sent[name] = max(self.newest_sent.get(name, 0), task.serial)
                    yield replace(task, duration=max(task.duration, at.time - task.time))

    def _show_until(self, run: RunView, until: float) -> None:
        nap = 0.0
        while not self.hand.is_over:
            for order in self.line.orders(nap):
                self._obey(run, order)
            now = self.clock.now()
            self._show(run, now)
            if now >= until:
                return
            nap = self._nap(until)

    def _nap(self, until: float) -> float:
        due = self.shown + FRAME - self.wall()
        return min(max(min(due, self.clock.wait_for(until)), SHORTEST_NAP), LONGEST_NAP)

    def _show(self, run: RunView, now: float) -> None:
        while self.news and self.news[0][0] <= now + ROUNDING:
            self.line.report(self.news.popleft()[1])
        wall = self.wall()
        if self.frames is not None and wall >= self.shown + FRAME - SHORTEST_NAP:
            self.line.report(self.frames.frame(run, now, self.day()))
            # frames keep their rhythm, unless the run has been held up
            self.shown = self.shown + FRAME if wall < self.shown + 2.0 * FRAME else wall

    def _obey(self, run: RunView, order: Order) -> None:
        match order:
            case LiveControl() | LiveOverride():
                self.hand.obey(run, order)
                self._tell_state()
            case LiveSpeed(speed):
                self.clock.set_speed(speed)
                self._tell_state()
            case SetSignal(name, value) if self.keys is not None:
                self._press(run, self.keys, SetSignal(name, value))
            case _:
                pass

    def _press(self, run: RunView, keys: Keys, order: SetSignal) -> None:
        stamp = keys.stamp(order.name, order.value, run.farthest + 1)
        if isinstance(stamp, Stamp):
            run.press(stamp.signal, stamp.tick, stamp.value)
            time = stamp.tick / run.hz
            news = plain(SignalStamped(stamp.signal, stamp.value, time))
        else:
            news = plain(notice(stamp))
        self.line.report(LiveMessage(news))

    def _tell_state(self) -> None:
        status = LiveStatus(self.hand.state, self.clock.speed, self.program, self.hand.override)
        self.line.report(LiveMessage(plain(status)))

    def _tell_behind(self, ended: Event) -> None:
        """Report the position of the arm after a step whose move has passed its target by."""
        if isinstance(ended, MoveEvent) and ended.flown > 0.0:
            self.line.report(LiveMessage(plain(behind_target(ended))))


def behind_target(move: MoveEvent) -> Notice:
    """Return the notice for the page on a step that ends in a blend."""
    line = f" of line {move.origin.span.line}" if move.origin and move.origin.span else ""
    zone = f"{1e3 * move.flown:.3g} mm"
    words = f"the step ended behind the target{line}, which the path passes by (zone {zone})"
    return Notice("info", "", words, "`fine` on that move lets the arm stop at its target")


def happened(event: Event) -> LiveMessage:
    """Return the message for the page on an event."""
    return LiveMessage(plain(Happened(packed_event(event))))

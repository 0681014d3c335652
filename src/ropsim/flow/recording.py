"""The recording of a run: named channels over time, events and findings."""

from collections.abc import Mapping
from dataclasses import field
from typing import TYPE_CHECKING, TypeVar

import numpy as np

from ropsim.core import Diagnostic, Severity, frozen_dataclass
from ropsim.flow.channel import Channel
from ropsim.flow.events import Event, MoveEvent, SkipEvent
from ropsim.flow.facts import RunFacts
from ropsim.spatial import Array, Pose, record

if TYPE_CHECKING:
    import pandas as pd

E = TypeVar("E", bound=Event)


@record
class Placement:
    """From one time on, until the next placement of the same body.

    Attributes:
        time: [s], a whole control tick; 0 for where it is at the start.
        body: its name.
        parent: name of the body that it hangs on, empty for the world.
        X_PB: its frame in that of the parent; of a body that a joint moves, at joint coordinate 0.
        visible: False while it is absent: a tool not mounted, a part in its supply or removed by a sink.
    """

    time: float
    body: str
    parent: str
    X_PB: Pose
    visible: bool = True


@frozen_dataclass
class RunContent:
    """Content from which a run was made, in addition to the identities of its programs.

    Attributes:
        cell: `content` of the work cell; empty where unknown.
        lines: by station, the source line of each instruction of its program, in the order of
            `ropsim.icr.code_lines`; 0 where unknown.
        results: by station, the content on which each line of its program depends, by the number of the line
            in the order of `ropsim.icr.line_contents`.
    """

    cell: str = ""
    lines: Mapping[str, tuple[int, ...]] = field(default_factory=dict)
    results: Mapping[str, Mapping[int, str]] = field(default_factory=dict)


@record
class Recording:
    """Result of a run.

    Check `ok` first: a move that could not be made was skipped, and the run went on.

    Attributes:
        time: [s], shape (n,), equally spaced.
        channels: by name; see docs/reference/recording.md.
        events: in order of time.
        findings: diagnostics of the run.
        duration: simulated time [s].
        facts: stations and programs, arms, limits.
        placements: where each body hung at the start, and every change since, in order of time.
        content: content from which the run was made.
    """

    time: Array
    channels: Mapping[str, Channel]
    events: tuple[Event, ...]
    findings: tuple[Diagnostic, ...]
    duration: float
    facts: RunFacts = RunFacts()
    placements: tuple[Placement, ...] = ()
    content: RunContent = RunContent()

    @property
    def ok(self) -> bool:
        """Return whether no finding is an error and no move was skipped."""
        return self.first_error is None and not self._skipped

    @property
    def first_error(self) -> Diagnostic | None:
        """Return the first finding that is an error, None where there is none."""
        return next((finding for finding in self.findings if finding.is_error), None)

    @property
    def _skipped(self) -> int:
        return sum(isinstance(event, SkipEvent) for event in self.events)

    def __repr__(self) -> str:
        """Return one line: whether the run failed and why, its moves and length; no arrays."""
        moves = sum(isinstance(event, MoveEvent) for event in self.events)
        state = "ok" if self.ok else "FAILED"
        skipped = f", {self._skipped} SKIPPED" if self._skipped else ""
        text = f"<Recording {state}: {moves} moves{skipped}, {self.duration:.2f} s, {self._counts()}"
        error = self.first_error
        return f"{text}; first error: {_one_line(str(error))}>" if error else f"{text}>"

    def _counts(self) -> str:
        severities = [finding.severity for finding in self.findings]
        counts = [(severities.count(one), one.value) for one in Severity]
        found = [f"{count} {name}{'s' * (count > 1)}" for count, name in counts if count]
        return ", ".join(found) or "no findings"

    def events_of(self, kind: type[E]) -> tuple[E, ...]:
        """Return the events of one kind, in order of time.

        Args:
            kind: its class, such as `MoveEvent`.
        """
        return tuple(event for event in self.events if isinstance(event, kind))

    def rows(self, name: str) -> Array:
        """Return a channel at the recorded rows, shape (n,) or (n, k).

        Args:
            name: of the channel; held values are expanded to each row.

        Raises:
            KeyError: the channel is unknown.
        """
        return self.channels[name].rows(self.time)

    def at(self, name: str, time: float) -> Array:
        """Return a channel at one time, shape () or (k,): the value in force, or linear between two rows.

        Args:
            name: of the channel.
            time: [s]; outside the recording its nearest end counts.

        Raises:
            KeyError: the channel is unknown.
        """
        channel = self.channels[name]
        if channel.held:
            return np.asarray(channel.rows(np.array([time]))[0])
        columns = channel.values.reshape(len(self.time), -1).T
        found = np.array([np.interp(time, self.time, column) for column in columns])
        return found.reshape(channel.values.shape[1:])

    def to_pandas(self) -> "pd.DataFrame":
        """Return all channels at the recorded rows as one table indexed by time [s].

        Columns are `q[1]`, `tau[E1]`, `left/attained_position[x]` and so on: the channel, and in brackets
        which of its columns; of a channel of one column the bare name.

        Raises:
            ImportError: pandas is not installed; the message names the extra that brings it.
        """
        try:
            import pandas as pd
        except ImportError as error:
            message = "a table needs pandas, which is not installed: pip install 'ropsim[pandas]'"
            raise ImportError(message, name="pandas") from error

        columns: dict[str, Array] = {}
        for name, channel in self.channels.items():
            values = channel.rows(self.time)
            if values.ndim == 1:
                columns[name] = values
            else:
                labels = channel.columns or tuple(str(k) for k in range(values.shape[1]))
                columns.update({f"{name}[{label}]": values[:, k] for k, label in enumerate(labels)})
        return pd.DataFrame(columns, index=pd.Index(self.time, name="time"))


def _one_line(text: str) -> str:
    return "".join(character if character.isprintable() else " " for character in text)

"""The recording of a run: named channels over time, events and findings."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, Severity, Span
from ropsim.flow.placement import Placement
from ropsim.spatial import Array, record

if TYPE_CHECKING:
    import pandas as pd


@record
class Channel:
    """One recorded quantity.

    Attributes:
        values: shape (n,) or (n, k), one row per recorded tick.
        unit: SI unit as text, empty for counts and codes.
        columns: names of the k columns; empty for a single column.
        description: what it is, in which frame.
    """

    values: Array
    unit: str
    columns: tuple[str, ...] = ()
    description: str = ""


@dataclass(frozen=True, slots=True)
class Event:
    """Something that happened at one time.

    Attributes:
        time: [s].
        kind: `move`, `grip`, `release`, `output`, `wait`, `message`, `task`, `skip` …
        text: what happened, for people.
        span: source line, where it is known.
        duration: [s], 0 for an instant.
        data: figures and names.
    """

    time: float
    kind: str
    text: str
    span: Span | None = None
    duration: float = 0.0
    data: Mapping[str, object] = field(default_factory=dict)


@dataclass(frozen=True, slots=True, repr=False)
class Recording:
    """What a run leaves behind.

    Look at `ok` first: a move that could not be made was skipped, and the run went on.

    Attributes:
        time: [s], shape (n,), equally spaced.
        channels: by name; see docs/reference/recording.md.
        events: in order of time.
        findings: diagnostics of the run.
        duration: simulated time [s].
        header: program, robot, options and versions; plain values.
        placements: where each body hung at the start, and every change since, in order of time; none in
            recordings of older versions.
    """

    time: Array
    channels: Mapping[str, Channel]
    events: tuple[Event, ...]
    findings: tuple[Diagnostic, ...]
    duration: float
    header: Mapping[str, object] = field(default_factory=dict)
    placements: tuple[Placement, ...] = ()

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
        return sum(event.kind == "skip" for event in self.events)

    def __repr__(self) -> str:
        """Return one line: whether the run failed and why, its moves and length; no arrays."""
        moves = sum(event.kind == "move" for event in self.events)
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

    def to_pandas(self) -> "pd.DataFrame":
        """Return all channels as one table indexed by time [s]; columns are `q[0]`, `tau[2]` and so on.

        Raises:
            ImportError: pandas is not installed.
        """
        import pandas as pd

        columns: dict[str, Array] = {}
        for name, channel in self.channels.items():
            if channel.values.ndim == 1:
                columns[name] = channel.values
            else:
                labels = channel.columns or tuple(str(k) for k in range(channel.values.shape[1]))
                columns.update({f"{name}[{label}]": channel.values[:, k] for k, label in enumerate(labels)})
        return pd.DataFrame(columns, index=pd.Index(self.time, name="time"))


def _one_line(text: str) -> str:
    return "".join(character if character.isprintable() else " " for character in text)

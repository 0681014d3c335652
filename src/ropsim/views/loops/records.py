"""The content of a page of responses, as plain numbers and texts."""

from ropsim.core import frozen_dataclass
from ropsim.spatial import Array, record


@frozen_dataclass
class LoopTable:
    """A table.

    Attributes:
        caption: its content, a sentence.
        header: titles of the columns, each of one line or more.
        rows: texts, as many each as there are titles.
    """

    caption: str
    header: tuple[str, ...]
    rows: tuple[tuple[str, ...], ...]


@record
class TimeCurves:
    """The answer of an axis to a step or a ramp.

    Attributes:
        name: of the axis.
        unit: of its coordinate.
        time: [s], shape (n,).
        reference: in that unit, shape (n,).
        moved: in that unit, shape (n,).
        effort_unit: of its drive.
        effort: in that unit, shape (n,).
    """

    name: str
    unit: str
    time: Array
    reference: Array
    moved: Array
    effort_unit: str
    effort: Array


@record
class SineCurves:
    """How an axis follows sines.

    Attributes:
        name: of the axis.
        hz: frequencies [Hz], shape (n,).
        gain: amplitude over that of the reference [dB], shape (n,).
        phase: lead over the reference [°], shape (n,).
    """

    name: str
    hz: Array
    gain: Array
    phase: Array


@frozen_dataclass
class LoopPage:
    """A page of responses.

    Attributes:
        title: of the page.
        subtitle: law, rate, place and load, in words.
        tables: of figures.
        times: answers in time; none where all have diverged.
        sines: answers to sines.
        notes: sentences below.
    """

    title: str
    subtitle: str
    tables: tuple[LoopTable, ...]
    times: tuple[TimeCurves, ...]
    sines: tuple[SineCurves, ...]
    notes: tuple[str, ...]

"""The station of a program, and the names in the program that this station must have."""

from ropsim import icr, language
from ropsim.core import Diagnostic, SourceText, did_you_mean, frozen_dataclass
from ropsim.model import Cell, Station
from ropsim.workbench.project_diagnostics import UNBOUND


@frozen_dataclass
class AtStation:
    """A station, by names.

    Attributes:
        cell: name of the text of the cell file; empty for a program without a cell.
        folder: name of the project's folder, from which a cell has its own if its file has no name.
        station: name; empty for the first one of the cell.
    """

    cell: str = ""
    folder: str = ""
    station: str = ""


NOWHERE = AtStation()
"""Of a program without a cell."""


def unbound(
    code: icr.Program, text: SourceText, cell: Cell | None, station: Station | None
) -> tuple[Diagnostic, ...]:
    """Return the channels and tools that a program names and its station does not have (rule V11).

    Args:
        code: the program.
        text: where it comes from, for places.
        cell: None for a program without one.
        station: that runs it; None for the first one of the cell.
    """
    if cell is None:
        return ()
    station = station or cell.first
    signals = [("signals", "IO", channel.name, tuple(cell.signals)) for channel in code.channels]
    tools = [
        ("tools", "TOOLDEF", tool.name, tuple(station.tools)) for tool in code.tools if tool.pose is None
    ]
    return tuple(
        UNBOUND.at(
            code.declared_at.get(f"{record} {name}") or language.named_at(text, name),
            f"`{code.name}` names `{name}`, which is not under [{table}]",
            hint=did_you_mean(name, known) or f"add `[{table}.{name}]` to cell.toml",
        )
        for table, record, name, known in (*signals, *tools)
        if name not in known
    )

"""State set by an instruction: its source line and its tool."""

from ropsim.flow import Instruction, ModalState
from ropsim.model import Station, Tool
from ropsim.simulation.state.cell_run import CellRun
from ropsim.simulation.state.station_run import StationRun


def put_in_force(run: CellRun, at: StationRun, step: Instruction) -> None:
    """Let origin, line and tool of an instruction be in force at a station from now on."""
    at.origin, span = step.origin, step.origin.span
    at.is_busy = True
    at.activations.begin(step.origin, at.tick)
    at.track("line", span.line if span else 0)
    if step.modal is at.modal:
        return  # its tool is in force
    at.modal = step.modal
    run.take(at, _tool_in_force(at.station, step.modal), run.parts)
    at.tool_frames.set(at.tick, at.chain.tool_pose(step.modal))


def _tool_in_force(station: Station, modal: ModalState) -> Tool | None:
    """Return the tool of the cell that is in force; None for the bare interface or a tool of the program."""
    return station.tools.get(modal.tool or (station.default_tool if modal.X_MT is None else ""))

"""Lines of a run of commands: what tasks of the program do stands in its text."""

from pathlib import Path

from ropsim.flow import MoveEvent
from ropsim.simulation import Fidelity, RunOptions
from ropsim.studio.testing import in_program
from ropsim.workbench import begin_session, open_project

FIRST_CELL = Path(__file__).parents[4] / "examples" / "first_cell"
KINEMATIC = RunOptions(fidelity=Fidelity.KINEMATIC)


def test_tasks_have_their_lines_and_commands_have_none() -> None:
    project = open_project(FIRST_CELL)
    session = begin_session(project, KINEMATIC, ("mov pick_up above 90", "Carry pick_up, set_down"))
    shown = in_program(session)
    text = project.program().source
    first, *carried = shown.events_of(MoveEvent)
    assert first.origin is not None
    assert first.origin.span is None
    for move in carried:
        assert move.origin is not None
        span = move.origin.span
        assert span is not None
        assert span.source == text.name
        assert text.line(span.line).split()[0] in ("mov", "lin")
    (station,) = shown.facts.stations
    assert station.source == text.name
    of_task = range(text.text.splitlines().index("task Carry(a: loc, b: loc)") + 2, len(text.lines))
    assert {0} < set(shown.rows("line").astype(int).tolist()) < {0, *of_task}
    assert (shown.rows("q") == session.recording.rows("q")).all()

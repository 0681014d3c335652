"""State of the worker between two jobs, and the handlers of jobs."""

from dataclasses import dataclass, field
from typing import TYPE_CHECKING

from ropsim.meshes import MeshLibrary
from ropsim.studio.desk.finished import Shelf
from ropsim.studio.desk.jog.jog import JoggedArms
from ropsim.studio.desk.line import Line
from ropsim.studio.desk.live.run import run_live
from ropsim.studio.desk.scene import open_scene
from ropsim.studio.desk.simulate import simulate
from ropsim.studio.desk.ways import look_at_ways
from ropsim.studio.wire.jobs import (
    CheckTaskForm,
    CheckTasks,
    EstimateTasks,
    Job,
    JogJoints,
    JogTcp,
    ListTasks,
    LiveStart,
    LookAtWays,
    OfferWords,
    OpenScene,
    OpenTaskForm,
    SaveRun,
    Simulate,
    Tell,
)
from ropsim.studio.wire.replies import Failed, Reply
from ropsim.workbench import Workspace

if TYPE_CHECKING:  # with its engine it is loaded by who chooses tasks
    from ropsim.studio.desk.command_line import ToldRobot
    from ropsim.studio.desk.tasks.bench import TaskBench

NOT_KEPT = "this run is not kept any more: simulate it again"
NOTHING_OPEN = "no cell is open: the cell file has errors, they are in the list of problems"


@dataclass(slots=True)
class Desk:
    """State of the worker.

    Attributes:
        arms: arms of the newest scene, None without one.
        meshes: meshes of the newest scene, so that unchanged files are not converted again.
        shelf: the newest finished run.
        workspace: keeps results for the texts of the project.
        bench: the tasks that may be chosen, None before the first request.
        told: the robot that executes commands, None before the first.
        is_cold: whether `warm` has something to do.
    """

    arms: JoggedArms | None = None
    meshes: MeshLibrary | None = None
    shelf: Shelf = field(default_factory=Shelf)
    workspace: Workspace = field(default_factory=Workspace)
    bench: "TaskBench | None" = None
    told: "ToldRobot | None" = None
    is_cold: bool = False

    def do(self, job: Job, line: Line) -> Reply:
        """Return the reply to a job.

        Raises:
            Cancelled: it was given up.
            RopsimError: it cannot be done; the message is in words.
        """
        match job:
            case OpenScene():
                opened = open_scene(job, self.meshes, self.workspace)
                self.arms = JoggedArms.of(opened.cell) if opened.cell is not None else None
                self.meshes = opened.meshes or self.meshes
                self.is_cold = self.arms is not None
                return opened.reply
            case Simulate():
                return simulate(job, line, self.shelf, self.workspace)
            case LiveStart():
                return run_live(job, line, shelf=self.shelf, workspace=self.workspace)
            case SaveRun(number, form):
                kept = self.shelf.run
                return kept.file(form) if kept is not None and kept.number == number else Failed(NOT_KEPT)
            case LookAtWays(number):
                return look_at_ways(number, line, self.shelf) or Failed(NOT_KEPT)
            case JogJoints() | JogTcp():
                return self.arms.move(job) if self.arms else Failed(NOTHING_OPEN)
            case ListTasks() | CheckTasks() | EstimateTasks() | OpenTaskForm() | CheckTaskForm():
                from ropsim.studio.desk.tasks.bench import TaskBench

                self.bench = self.bench or TaskBench(self.workspace)
                return self.bench.do(job, line)
            case Tell():
                return self._told().tell(job, line)
            case OfferWords():
                return self._told().offer(job)

    def _told(self) -> "ToldRobot":
        from ropsim.studio.desk.command_line import ToldRobot

        self.told = self.told or ToldRobot(self.workspace)
        return self.told

    def warm(self) -> None:
        """Load modules for the first jog, so that it is as quick as the others."""
        if self.is_cold and self.arms is not None:
            self.arms.warm()
        self.is_cold = False

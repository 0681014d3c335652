"""Where tasks are chosen: the knowledge of the project at hand, and who does which job."""

from collections.abc import Mapping
from dataclasses import dataclass, replace
from pathlib import Path

from ropsim.core import Category, RopsimError
from ropsim.studio.desk.line import Line
from ropsim.studio.desk.tasks.estimate import estimated
from ropsim.studio.desk.tasks.forms import form_checked, form_opened
from ropsim.studio.desk.tasks.known_project import KnownProject, key_of, known_project
from ropsim.studio.desk.tasks.listing import task_list
from ropsim.studio.desk.tasks.stating import checked
from ropsim.studio.wire.jobs import (
    CheckTaskForm,
    CheckTasks,
    EstimateTasks,
    ListTasks,
    OpenTaskForm,
    TasksJob,
)
from ropsim.studio.wire.messages import plain
from ropsim.studio.wire.replies import TasksReply
from ropsim.workbench import Workspace, open_overlaid

_STOPPED = "what reads the tasks has stopped in the middle of its work; it starts again when it is asked"
_INSTALL = "a file of ropsim that reads tasks is missing or damaged: install ropsim again"
_CAUSES: Mapping[Category, str] = {
    Category.OUT_OF_TIME: "reading the tasks took too long; the machine may be busy",
    Category.ENGINE_LOST: _STOPPED,
    Category.DAMAGED: _INSTALL,
}
"""Words on failures of the engine for operators, who do not know the engine, by category of the failure."""


@dataclass(slots=True)
class TaskBench:
    """State of the worker for tasks.

    Attributes:
        workspace: keeps results for the texts of the project.
        known: data of the project, None before the first request.
        revision: counts how often something else was known.
    """

    workspace: Workspace
    known: KnownProject | None = None
    revision: int = 0

    def do(self, job: TasksJob, line: Line) -> TasksReply:
        """Return the reply to a job.

        Raises:
            Cancelled: it was given up.
            RopsimError: it cannot be done; the message is in words.
        """
        try:
            return self._done(job, line)
        except RopsimError as error:
            cause = _CAUSES.get(error.diagnostic.category)
            if cause is None:
                raise
            raise RopsimError(replace(error.diagnostic, message=cause)) from error

    def _done(self, job: TasksJob, line: Line) -> TasksReply:
        match job:
            case ListTasks():
                known = self._known(job)
                return TasksReply(plain(task_list(known, self.revision)))
            case CheckTasks(_, _, number, steps):
                known = self._known(job)
                return TasksReply(plain(checked(known, steps, number, self.revision)))
            case OpenTaskForm():
                return TasksReply(plain(form_opened(job, self._known(job).knowledge.base)))
            case CheckTaskForm():
                project = open_overlaid(Path(job.folder), job.texts, self.workspace)
                return TasksReply(plain(form_checked(job, project, self.workspace)))
            case EstimateTasks():
                return TasksReply(plain(estimated(job, line, self.workspace)))

    def _known(self, job: ListTasks | CheckTasks | OpenTaskForm) -> KnownProject:
        project = open_overlaid(Path(job.folder), job.texts, self.workspace)
        key = key_of(project)
        if self.known is None or self.known.key != key:
            before, self.known = self.known, known_project(project, key)
            self.revision += 1
            if before is not None:
                before.knowledge.base.close()
        return self.known

"""One project and the tabs that show it: and the handlers of messages from a page."""

import asyncio
import time
from collections.abc import Callable, Coroutine
from pathlib import Path

from ropsim.core import Diagnostic, RopsimError, shortage
from ropsim.studio.diagnostics import (
    INTERNAL,
    NO_PROJECT,
    NOT_UNDERSTOOD,
    READ_ONLY,
    TRUST_NOT_KEPT,
    WORKER_LOST,
)
from ropsim.studio.processes.project_maker import project_made
from ropsim.studio.processes.workers import DESK, WorkerLink
from ropsim.studio.session.command_line import CommandLine, LineCommand
from ropsim.studio.session.editing import Editing
from ropsim.studio.session.folders import folders_in, places_of
from ropsim.studio.session.runs import Runs
from ropsim.studio.session.scenes import Scenes
from ropsim.studio.session.tab import Tab
from ropsim.studio.session.tabs import GRACE, Tabs
from ropsim.studio.session.tasks import ChosenTasks
from ropsim.studio.texts.document import Document
from ropsim.studio.texts.project_files import CELL, project_folder
from ropsim.studio.wire import commands, orders
from ropsim.studio.wire.messages import (
    Answered,
    ExampleState,
    PointNames,
    Robots,
    TrustChanged,
    TrustState,
    Welcome,
    notice,
)
from ropsim.userfiles import (
    STARTER,
    Trust,
    TrustError,
    code_in,
    example_names,
    example_summary,
    recent_projects,
    set_trust,
    trust_in,
)
from ropsim.version import __version__

REST = 0.25
"""How long the cell file must rest before the scene is made anew [s]."""


class Session:
    """The studio of one project.

    Args:
        folder: of the project.
        neutral: working folder of the workers, where no project lies.
        worker: `module:function` that runs in all worker processes.
        switch: opens another project instead.
    """

    def __init__(
        self,
        folder: Path,
        neutral: Path,
        worker: str = DESK,
        switch: Callable[[Path], None] = lambda _: None,
    ) -> None:
        self._folder = folder
        self._tabs = Tabs(time.monotonic)
        self.editing = Editing(folder, self._tabs, self._welcome_all, self._text_changed)
        self._neutral = neutral
        self._desk = WorkerLink("drawing desk", str(neutral), self._desk_lost, worker)
        self._simulator = WorkerLink("simulator", str(neutral), self._simulator_lost, worker)
        self._bench = WorkerLink("checker of tasks", str(neutral), self._tell_lost, worker)
        self.tasks = ChosenTasks(folder, self._bench, self._texts)
        self._told = WorkerLink("command line", str(neutral), self._tell_lost, worker)
        self.command_line = CommandLine(folder, self._told, self._texts, self._tabs, self.editing.create)
        self.scenes = Scenes(folder, self._desk, self._texts, self._tabs.tell)
        self.runs = Runs(
            folder, self._simulator, self._texts, self._versions, self._tabs.tell, self._tabs.show
        )
        self._scene_timer: asyncio.TimerHandle | None = None
        self._background: set[asyncio.Task[None]] = set()
        self._code: tuple[str, ...] = ()
        self._switch = switch
        self._recent: tuple[Path, ...] = ()
        self._examples: tuple[ExampleState, ...] = ()

    async def open(self) -> None:
        """Read the project, draw it, and simulate its program."""
        self._desk.start()
        self._simulator.start()
        await self.editing.open()
        self._code = await asyncio.to_thread(code_in, self._folder)
        self._recent = await asyncio.to_thread(recent_projects)
        self._examples = tuple(ExampleState(name, example_summary(name)) for name in example_names())
        self.scenes.refresh()
        self.runs.run("", "dynamic")

    async def close(self) -> None:
        """Keep unsaved texts and end the workers."""
        for tab in self._tabs:
            tab.close()
        self.runs.close()
        if self._scene_timer is not None:
            self._scene_timer.cancel()
        await self.editing.close()
        workers = (self._desk, self._simulator, self._bench, self._told)
        await asyncio.gather(*(one.close() for one in workers))
        for task in self._background:
            task.cancel()

    def kill(self) -> None:
        """End the workers at once, whether the session was closed or not."""
        self._desk.kill()
        self._simulator.kill()
        self._bench.kill()
        self._told.kill()

    async def receive(self, tab: Tab, text: str | bytes) -> None:
        """Handle a message of a page; the session continues after any message."""
        command, problem = commands.read_command(text)
        if command is None:
            message = f"the server does not understand what the page says: {problem[:300]}"
            tab.send(notice(NOT_UNDERSTOOD.at(None, message, hint="load the page again")))
            return
        try:
            await self._do(tab, command)
        except Exception as error:  # one request may fail, the texts of the session must not
            message = f"`{type(command).__name__}` failed: {type(error).__name__}: {error}"
            fault = INTERNAL.at(None, message, hint="the rest goes on; please report it")
            tab.send(notice(shortage(error) or fault))

    async def leave(self, tab: Tab) -> None:
        """Forget a closed tab; its unsaved texts are kept, and another may edit after a while."""
        self._tabs.remove(tab)
        asyncio.get_running_loop().call_later(GRACE, self._tabs.pass_on)
        await self.editing.keep()

    async def _do(self, tab: Tab, command: commands.Command) -> None:
        match command:
            case commands.Hello(name):
                self._join(tab, name)
            case (
                commands.Edit()
                | commands.Save()
                | commands.Revert()
                | commands.Create()
                | commands.KeepPoints()
            ):
                await self.editing.handle(tab, command)
            case commands.OpenProject() | commands.NewProject():
                await self._leave_for(tab, command)
            case commands.ListFolders(path):
                tab.send(await asyncio.to_thread(folders_in, path, places_of(self._folder)))
            case commands.ListRobots():
                tab.send(Robots(await asyncio.to_thread(_robots)))
            case commands.TakeOver():
                self._tabs.take_over(tab)
            case commands.Trust(trusted):
                await self._trust(tab, Trust.GIVEN if trusted else Trust.WITHHELD)
            case commands.JogJoints() | commands.JogTcp():
                self._in_background(self._jog(tab, command))
            case commands.OpenTasks() | commands.CheckTasks():
                self._in_background(self.tasks.answer(tab, command))
            case commands.OpenTaskForm() | commands.CheckTaskForm():
                self._in_background(self.tasks.answer_form(tab, command))
            case (
                commands.OpenCommandLine()
                | commands.TellRobot()
                | commands.CompleteLine()
                | commands.GiveUpLine()
            ):
                self._tell_robot(tab, command)
            case _:
                self._run(command)

    async def _leave_for(self, tab: Tab, command: commands.OpenProject | commands.NewProject) -> None:
        """Let another project take the place of this one, if the tab may and there is one."""
        if not self._tabs.may_edit(tab):
            message = "another tab edits this project; it was not left"
            finding = READ_ONLY.at(None, message, hint="`Take over` gives the right to this tab")
            tab.send(Answered(notice(finding)))
            return
        try:
            place = self._folder.parent / Path(command.path).expanduser()
            if isinstance(command, commands.NewProject):
                example = command.example or STARTER
                making = asyncio.to_thread(project_made, place, example, command.robot, self._neutral)
                place = await making
            folder = await asyncio.to_thread(project_folder, place)
        except (RopsimError, RuntimeError, ValueError) as error:
            finding = error.diagnostic if isinstance(error, RopsimError) else _no_place(command.path)
            tab.send(Answered(notice(finding)))
            return
        tab.send(Answered(None))
        self._switch(folder)

    def _tell_robot(self, tab: Tab, command: LineCommand) -> None:
        match command:
            case commands.OpenCommandLine():
                self._in_background(self.command_line.open(tab))
            case commands.TellRobot():
                self._in_background(self.command_line.tell(tab, command))
            case commands.CompleteLine():
                self._in_background(self.command_line.offer(tab, command))
            case commands.GiveUpLine():
                self.command_line.give_up()

    def _run(self, command: commands.Command) -> None:
        match command:
            case commands.RunNow(program, fidelity):
                self.runs.run(program, fidelity)
            case commands.CancelRun():
                self.runs.cancel()
            case commands.LiveStart(program, speed, begin):
                self.runs.start_live(program, speed, begin)
            case orders.LiveControl() | orders.LiveOverride() | orders.LiveSpeed() | orders.SetSignal():
                self.runs.order_live(command)
            case commands.ForgetInputs():
                self.runs.forget_inputs()

    def _join(self, tab: Tab, name: str) -> None:
        if tab.name:
            return
        tab.name = name or "unnamed"
        self._tabs.add(tab)
        tab.send(self._welcome(tab))
        if self.editing.points.names:
            tab.send(PointNames(self.editing.points.names))
        if self.scenes.newest is not None:
            tab.send(self.scenes.newest)
        for message in self.runs.news:
            tab.send(message)
        for finding in self.editing.warnings:
            tab.send(notice(finding))

    def _welcome(self, tab: Tab) -> Welcome:
        documents = self.editing.documents
        return Welcome(
            __version__,
            self._folder.name,
            str(self._folder),
            documents.programs,
            documents.program,
            tuple(one.state(one.text) for one in documents.all),
            self._tabs.may_edit(tab),
            self._trust_state(),
            tuple(str(one) for one in self._recent if one != self._folder),
            self._examples,
        )

    def _welcome_all(self) -> None:
        for tab in self._tabs:
            tab.send(self._welcome(tab))

    def _text_changed(self, document: Document) -> None:
        self.runs.text_changed()
        if document.name == CELL:
            if self._scene_timer is not None:
                self._scene_timer.cancel()
            self._scene_timer = asyncio.get_running_loop().call_later(REST, self.scenes.refresh)

    def _texts(self) -> dict[str, str]:
        return dict(self.editing.documents.unsaved_texts)

    def _versions(self) -> dict[str, int]:
        return {one.name: one.version for one in self.editing.documents.all}

    def _trust_state(self) -> TrustState:
        return TrustState(trust_in(self._folder) is Trust.GIVEN, self._code)

    async def _trust(self, tab: Tab, trust: Trust) -> None:
        try:
            await asyncio.to_thread(set_trust, self._folder, trust)
        except TrustError as error:
            tab.send(notice(TRUST_NOT_KEPT.at(None, error.diagnostic.message, hint=error.diagnostic.hint)))
        self._code = await asyncio.to_thread(code_in, self._folder)
        state = self._trust_state()
        self._tabs.tell(TrustChanged(state.trusted, state.code))

    async def _jog(self, tab: Tab, command: commands.JogJoints | commands.JogTcp) -> None:
        tab.send(await self.scenes.jog(command))

    def _in_background(self, answering: Coroutine[None, None, None]) -> None:
        """Answer a tab without holding up its next messages."""
        task = asyncio.get_running_loop().create_task(answering)
        self._background.add(task)
        task.add_done_callback(self._background.discard)

    def _desk_lost(self, words: str) -> None:
        self._tell_lost(words)
        self.scenes.recover()

    def _simulator_lost(self, words: str) -> None:
        self._tell_lost(words)

    def _tell_lost(self, words: str) -> None:
        finding: Diagnostic = WORKER_LOST.at(None, words, hint="it is started again; texts are not touched")
        self._tabs.tell(notice(finding))


def _no_place(path: str) -> Diagnostic:
    return NO_PROJECT.at(
        None, f"`{path[:200]}` is no path of this machine", hint="give the folder of a project"
    )


def _robots() -> tuple[str, ...]:
    """Return the names of the built-in robots; the library is imported for that only."""
    from ropsim.workbench import built_in_robots

    return built_in_robots()

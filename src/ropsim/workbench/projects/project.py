"""A project folder: its cell, its programs, and the operations on them."""

from collections.abc import Callable, Iterable, Mapping
from dataclasses import field
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim import icr
from ropsim.cellfile import program_in_cell_file
from ropsim.core import Diagnostic, RopsimError, SourceText, did_you_mean, frozen_dataclass, plural
from ropsim.model import ROBOT, Cell, ReadRobot, RobotSource, Station
from ropsim.workbench.compiling.compiled_project import CompiledProgram, CompiledProject, found_in
from ropsim.workbench.compiling.free_targets import targets_found_in
from ropsim.workbench.project_diagnostics import MOVES_SKIPPED, NO_CELL, NO_PROGRAM
from ropsim.workbench.robots.robot_files import RobotFile, robots_read
from ropsim.workbench.tasks.point_texts import NO_POINTS, PointTexts
from ropsim.workbench.tasks.task_texts import NO_TASKS, TaskTexts
from ropsim.workbench.workspace.workspace import Workspace

if TYPE_CHECKING:
    from ropsim.flow import Recording
    from ropsim.simulation import RunCollisions, RunOptions
    from ropsim.views import Comparison
    from ropsim.workbench.projects.calibrated_project import CalibratedProject
    from ropsim.workbench.report import Report
    from ropsim.workbench.what_if import Change, Subject


DEFAULT_PROGRAM = "main"
"""Program that runs if neither the caller nor `cell.toml` names one."""


class ProjectError(RopsimError):
    """A project that cannot be opened, or a program that cannot be run; carries the finding."""


class FailedRunError(RopsimError):
    """A run with errors or skipped moves.

    Attributes:
        diagnostic: the first error of the run.
        recording: of the whole run, with all findings.
    """

    def __init__(self, recording: "Recording") -> None:
        super().__init__(recording.first_error or _skipped(recording))
        self.recording = recording


def _skipped(recording: "Recording") -> Diagnostic:
    """Return that a run without an error left out moves."""
    from ropsim.flow import MoveEvent, SkipEvent

    count = sum(isinstance(event, SkipEvent) for event in recording.events)
    moves = count + sum(isinstance(event, MoveEvent) for event in recording.events)
    return MOVES_SKIPPED.at(None, f"the run left out {count} of {plural(moves, 'move')}")


@frozen_dataclass
class Project:
    """A project as read; nothing in it runs code.

    Attributes:
        folder: of the project.
        cell: its work cell, None where `cell.toml` is absent or wrong.
        sources: texts of the programs by name.
        cell_text: text of `cell.toml`, None where absent.
        diagnostics: findings of reading.
        robot_files: files of robots that the cell names, with the robots read from them.
        tasks: texts of the tasks that its programs can call besides their own.
        points: texts of the lists of points that its programs can use.
        workspace: that has read it, and keeps results for its texts; not part of the content of the project.
        laws: texts of the files of joint controllers that the cell names, by their paths.
    """

    folder: Path
    cell: Cell | None
    sources: Mapping[str, SourceText]
    cell_text: SourceText | None = None
    diagnostics: tuple[Diagnostic, ...] = field(default=())
    robot_files: Mapping[RobotSource, RobotFile] = field(default_factory=dict)
    tasks: TaskTexts = NO_TASKS
    points: PointTexts = NO_POINTS
    workspace: Workspace = field(default_factory=Workspace, repr=False, compare=False)
    laws: Mapping[str, SourceText] = field(default_factory=dict)

    def __repr__(self) -> str:
        """Return one line: its folder, cell and programs, and its findings."""
        cell = f"{self.cell!r}" if self.cell else "no cell"
        programs = ", ".join(self.sources) or "none"
        errors = sum(one.is_error for one in self.diagnostics)
        found = f", {plural(errors, 'error')}" if errors else ""
        return f"<Project {self.folder}: {cell}, programs {programs}{found}>"

    @property
    def is_broken(self) -> bool:
        """Return whether reading found errors; then no program runs."""
        return any(diagnostic.is_error for diagnostic in self.diagnostics)

    @property
    def texts(self) -> Mapping[str, SourceText]:
        """Return all texts of the project, by the names that spans use."""
        robots = (one.text for one in self.robot_files.values())
        every = (*self.sources.values(), self.cell_text, *robots, *self.tasks.own, *self.tasks.users)
        every = (*every, *self.points.texts.values(), *self.laws.values())
        return {text.name: text for text in every if text is not None}

    @property
    def toml_texts(self) -> tuple[SourceText, ...]:
        """Return the texts that may name meshes: that of the cell, then the TOML files of its robots."""
        robots = (one.text for source, one in self.robot_files.items() if source.path.endswith(".toml"))
        return tuple(text for text in (self.cell_text, *robots) if text is not None)

    @property
    def robots(self) -> Mapping[RobotSource, ReadRobot]:
        """Return the robots read from files."""
        return robots_read(self.robot_files)

    def compile(self) -> CompiledProject:
        """Return all programs compiled, with the findings of the whole project.

        A program that several stations run is the one of the first of these; findings at any station are
        reported. With an invalid cell, only findings in programs that do not depend on the cell are reported.
        """
        if self.cell is None and self.is_broken:
            checked = map(self.workspace.syntax, self.sources.values())
            read = tuple(one for text in checked for one in text.diagnostics)
            return CompiledProject({}, (*self.around_programs, *read))
        compiled = {name: self._at_stations(name, text) for name, text in self.sources.items()}
        found = [one for programs in compiled.values() for one in found_in(programs)]
        programs = {name: next(iter(stations.values())) for name, stations in compiled.items()}
        found += targets_found_in(self.cell, compiled)
        return CompiledProject(programs, (*self.around_programs, *found))

    @property
    def around_programs(self) -> tuple[Diagnostic, ...]:
        """Return the findings that stand in no program: of the cell, of files that cannot be read."""
        return self.diagnostics if self.is_broken else (*self.diagnostics, *self._unwritten())

    def _at_stations(self, name: str, text: SourceText) -> dict[str, CompiledProgram]:
        """Return a program compiled for each station that runs it: their tools and places differ."""
        if self.cell is None:
            return {ROBOT: self.compiled_text(text, None)}
        return {station.name: self.compiled_text(text, station) for station in self.cell.stations_of(name)}

    def compiled_text(self, text: SourceText, station: Station | None) -> CompiledProgram:
        """Return a task or ICR text (by its ending), compiled for a station; None stands for the first."""
        name = station.name if station is not None else ""
        at = self.workspace.at(
            self.cell_text, cell_name(self.folder), name, self.robots, self.tasks, self.points
        )
        return self.workspace.compiled(text, at)

    def program(self, name: str | None = None) -> CompiledProgram:
        """Return one compiled program; without a name that of the first station, else `main` or the only one.

        Raises:
            ProjectError: the project is broken, or the program does not exist.
        """
        wanted = name or (self.cell.first.program if self.cell else DEFAULT_PROGRAM)
        return self._compiled(wanted, self.cell.station_of(wanted) if self.cell else None, name)

    def programs(self, name: str | None = None) -> dict[str, CompiledProgram]:
        """Return the compiled programs of the stations.

        Args:
            name: a program that runs at its own station, or at the first one in place of its own.

        Raises:
            ProjectError: the project is broken, or the program does not exist.
        """
        if self.cell is None:
            return {ROBOT: self.program(name)}
        chosen = self.cell.station_of(name) if name else None
        found = {}
        for station in self.cell.stations.values():
            given = name if station is chosen else None
            if given or station.program:
                found[station.name] = self._compiled(given or station.program, station, given)
        return found

    def _compiled(self, wanted: str, station: Station | None, given: str | None) -> CompiledProgram:
        for diagnostic in self.diagnostics:
            if diagnostic.is_error:
                raise ProjectError(diagnostic)
        if given is None:
            wanted = self._instead_of(wanted)
        text = self.sources.get(wanted)
        if text is None:
            raise ProjectError(self._missing(wanted, station if given is None else None))
        return self.compiled_text(text, station)

    def _instead_of(self, wanted: str) -> str:
        """Return the program that runs: the only one of the project if `main` is requested and missing."""
        only = len(self.sources) == 1 and wanted == DEFAULT_PROGRAM and wanted not in self.sources
        return next(iter(self.sources)) if only else wanted

    def _unwritten(self) -> tuple[Diagnostic, ...]:
        """Return a finding for each station that runs a program without a text."""
        stations = self.cell.stations.values() if self.cell else ()
        return tuple(
            self._missing(station.program, station)
            for station in stations
            if station.program and self._instead_of(station.program) not in self.sources
        )

    def _missing(self, wanted: str, station: Station | None) -> Diagnostic:
        """Return the finding that a program has no text; at the station that runs it, where one does."""
        known = ", ".join(f"`{one}`" for one in sorted(self.sources)) or "none"
        message, hint = (
            f"the project has no program `{wanted}`, it has {known}",
            did_you_mean(wanted, self.sources),
        )
        if station is None:
            return NO_PROGRAM.at(None, message, hint=hint)
        span = program_in_cell_file(self.cell_text, station.name)
        other = '`program = ""` for a station that stands still'
        if station.name == ROBOT:
            other = "name another one by `program` in `[cell]`"
        hint = hint or f"write `programs/{wanted}.task`, or {other}"
        return NO_PROGRAM.at(span, f"station `{station.name}` runs `{wanted}`: {message}", hint=hint)

    def simulate(
        self, program: str | None = None, options: "RunOptions | None" = None, *, strict: bool = False
    ) -> "Recording":
        """Compile and run the programs of the cell.

        A move that cannot be made is skipped and becomes a finding: see `ok` of the recording.

        Args:
            program: name of one; its station runs it, the others their own. None for the default programs.
            options: fidelity and recording.
            strict: raise where the recording is not ok, after the whole run.

        Raises:
            ProjectError: unknown program, no cell, or an error in one of them.
            FailedRunError: with `strict`, the run has errors or skipped moves; it carries the recording.
        """
        from ropsim.simulation import RunOptions, run

        cell, codes = self.runnable(self.programs(program))
        recording = run(cell, codes, options or RunOptions())
        if strict and not recording.ok:
            raise FailedRunError(recording)
        return recording

    def collisions(
        self, recording: "Recording", progress: Callable[[float], None] = lambda _: None
    ) -> "RunCollisions":
        """Return the collisions of a run of this project, and the least distance between bodies.

        Args:
            recording: of a run in its cell.
            progress: receives the share that has been checked, from 0 to 1.

        Raises:
            ProjectError: the project has no cell.
        """
        from ropsim.meshes import mesh_points
        from ropsim.simulation import run_collisions

        if self.cell is None:
            raise ProjectError(NO_CELL.at(None, f"`{self.folder}` has no cell"))
        return run_collisions(recording, self.cell, mesh_points(self.folder, self.cell), progress)

    def checked(
        self, recording: "Recording", progress: Callable[[float], None] = lambda _: None
    ) -> "Recording":
        """Return a recording of a run of this project whose collisions are checked.

        Nothing is checked twice.

        Args:
            recording: of a run in its cell.
            progress: receives the share that has been checked, from 0 to 1.

        Raises:
            ProjectError: the project has no cell.
        """
        from ropsim.simulation import needs_check, with_collisions

        if self.cell is not None and not needs_check(recording):
            return recording
        return with_collisions(recording, self.collisions(recording, progress))

    def changes(self, texts: Iterable[str]) -> "list[Change | Subject]":
        """Return the changes that texts describe; nothing is run.

        Args:
            texts: as `--what-if` of `ropsim run` takes them: `speed=120%`, `payload=3kg`, `zones=each`.

        Raises:
            WhatIfError: X896, a text is no change, or the cell lacks the entity to be changed.
        """
        from ropsim.workbench.what_if import Subject, read_change
        from ropsim.workbench.what_if.applying import changed_cell

        wanted = [read_change(text) for text in texts]
        for change in wanted:
            if self.cell is not None and not isinstance(change, Subject):
                changed_cell(self.cell, change)
        return wanted

    def what_if(
        self,
        changes: Iterable[str],
        program: str | None = None,
        options: "RunOptions | None" = None,
        recording: "Recording | None" = None,
    ) -> "Comparison":
        """Run the programs of the cell unchanged and with one change each, and return them side by side.

        Args:
            changes: as `changes` takes them.
            program: as for `simulate`.
            options: of all runs.
            recording: of the unchanged run, if available.

        Raises:
            ProjectError: unknown program, no cell, or an error in one of them.
            WhatIfError: X896, a text is no change, or the cell lacks the entity to be changed.
        """
        from ropsim.meshes import mesh_points
        from ropsim.simulation import RunOptions, run
        from ropsim.workbench.what_if.comparing import compare

        wanted = self.changes(changes)
        cell, codes = self.runnable(self.programs(program))
        options = options or RunOptions()
        meshes = mesh_points(self.folder, cell)
        return compare(recording or run(cell, codes, options), cell, codes, wanted, options, meshes)

    def calibrate(
        self,
        trace: str | Path,
        program: str | None = None,
        planning: Callable[[], None] = lambda: None,
    ) -> tuple["CalibratedProject | None", tuple[Diagnostic, ...]]:
        """Return the limits under which a program lasts as long as in a trace, and the findings.

        Args:
            trace: a table of times and joint coordinates, logged while the robot ran the program.
            program: name of the one that ran; None for that of the first station.
            planning: called before each sequence that is planned again.

        Returns:
            The calibration, None where there is none; and the findings. Nothing is written.

        Raises:
            ProjectError: unknown program, no cell, or an error in one of them.
            CalibrationError: X840 or X841, the trace cannot be opened.
        """
        from ropsim.workbench.projects.calibrating import calibrate_project

        cell, codes = self.runnable(self.programs(program))
        station = cell.station_of(program) if program else cell.first
        assert self.cell_text is not None  # a project with a cell has its text
        return calibrate_project(cell, codes, station, self.cell_text, self.robots, trace, planning)

    def runnable(self, programs: Mapping[str, CompiledProgram]) -> tuple[Cell, dict[str, icr.Program]]:
        """Return the cell and the verified code of compiled programs, by station.

        Raises:
            ProjectError: no cell, or an error in cell or programs; see `.diagnostic`.
        """
        codes = {}
        for station, compiled in programs.items():
            for diagnostic in compiled.diagnostics:
                if diagnostic.is_error:
                    raise ProjectError(diagnostic)
            if self.cell is None or compiled.icr is None:
                raise ProjectError(NO_CELL.at(None, f"`{compiled.source.name}` belongs to no cell"))
            codes[station] = compiled.icr
        if self.cell is None:
            raise ProjectError(NO_CELL.at(None, f"`{self.folder}` has no cell"))
        return self.cell, codes

    def report(self, recording: "Recording", before: Iterable[Diagnostic] = ()) -> "Report":
        """Return the report of a recording; it quotes the programs and shows the run in the cell.

        Args:
            recording: of a run of this project.
            before: findings of compiling its program; they count as findings of the run.
        """
        from ropsim.workbench.report import Report, Setting

        setting = Setting(self.cell, self.folder, self.toml_texts) if self.cell else None
        return Report.of(recording, self.texts, setting, before)


def cell_name(folder: Path) -> str:
    """Return the name of a cell whose file has no name: that of its folder."""
    return folder.resolve().name

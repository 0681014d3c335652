"""The knowledge base of a project with its cell: facts at the start, and reach of the arm."""

from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import TYPE_CHECKING

from ropsim.core import Diagnostic, SourceText, frozen_dataclass
from ropsim.model import Cell
from ropsim.workbench.cell.geometry import CellGeometry
from ropsim.workbench.cell.part_places import part_places, parts_behind
from ropsim.workbench.compiling.environment import environment_of
from ropsim.workbench.projects.opening import open_project
from ropsim.workbench.projects.project import Project
from ropsim.workbench.tasks.task_texts import TaskTexts, users_folder
from ropsim.workbench.workspace.workspace import Workspace

if TYPE_CHECKING:  # with their engine they take a tenth of a start, so their callers load them
    from ropsim.prolog import Prolog, Term
    from ropsim.tasks import KnowledgeBase, WorldState

CELL_FILE, KNOWLEDGE = "cell.toml", "kb"


@frozen_dataclass
class Knowledge:
    """A knowledge base and the cell that it is queried for.

    Attributes:
        base: the tasks.
        state: facts at the start; empty without a cell.
        findings: errors in the cell and the texts.
        texts: of both, by the names that spans use.
    """

    base: "KnowledgeBase"
    state: "WorldState"
    findings: tuple[Diagnostic, ...]
    texts: Mapping[str, SourceText]


def open_knowledge(path: str | Path, prolog: "Prolog | None" = None) -> Knowledge:
    """Return the knowledge base of a project, or of a folder or a text without a cell.

    Args:
        path: of the project, the folder or the text.
        prolog: which SWI-Prolog reads the texts and answers; the built-in one where nothing is said.

    Raises:
        TaskError: the path does not exist.
        ProjectError: the project may not be read.
    """
    from ropsim.prolog import Prolog
    from ropsim.tasks import KnowledgeBase, WorldState, effect_findings, own_tasks

    place = Path(path)
    folder = place.parent if place.name == CELL_FILE else place
    if (folder / CELL_FILE).is_file():
        return knowledge_of(open_project(folder), prolog)
    base = KnowledgeBase.open(place, users=users_folder(), prolog=prolog or Prolog.BUILT_IN)
    found = (*base.findings, *effect_findings(base, own_tasks(base)))
    return Knowledge(base, WorldState(), found, base.texts)


def knowledge_of(project: Project, prolog: "Prolog | None" = None) -> Knowledge:
    """Return the knowledge base of a project; with an invalid cell, the tasks alone and the errors."""
    from ropsim.prolog import Prolog
    from ropsim.tasks import KnowledgeBase, WorldState, body_findings, effect_findings, own_tasks

    cell, which = project.cell, prolog or Prolog.BUILT_IN
    if cell is None:
        texts = project.tasks
        base = KnowledgeBase(texts.own, findings=texts.findings, users=texts.users, prolog=which)
        found = (*project.diagnostics, *base.findings, *effect_findings(base, own_tasks(base)))
        return Knowledge(base, WorldState(), found, {**project.texts, **base.texts})
    texts = project.tasks
    base = KnowledgeBase(texts.own, CellGeometry(cell, project.folder), texts.findings, texts.users, which)
    own = own_tasks(base)
    found = (*base.findings, *body_findings(base, environment_of(cell), own), *effect_findings(base, own))
    return Knowledge(base, world_state(cell), found, {**project.texts, **base.texts})


def has_knowledge(project: Project) -> bool:
    """Return whether a project has a knowledge base of its own."""
    return project.cell is not None and (project.folder / KNOWLEDGE).is_dir()


def task_findings(project: Project) -> tuple[tuple[Diagnostic, ...], Mapping[str, SourceText]]:
    """Return the findings in the knowledge base of a project, and its texts; empty without one.

    It is that of the workspace of the project, whose Prolog has read it for the programs already.
    """
    if project.cell is None or not has_knowledge(project):
        return (), {}
    from ropsim.tasks import body_findings, effect_findings, own_tasks

    base = project.workspace.knowledge(project.tasks)
    own = own_tasks(base)
    bodies = (*body_findings(base, environment_of(project.cell), own), *effect_findings(base, own))
    return (*project.tasks.findings, *base.findings, *bodies), base.texts


def text_findings(
    workspace: Workspace, tasks: TaskTexts, cell: Cell | None, name: str
) -> tuple[Diagnostic, ...]:
    """Return the findings in one text of tasks; without a cell bodies are not compiled.

    Args:
        workspace: whose Prolog reads the texts.
        tasks: all of them.
        cell: for which bodies are compiled.
        name: of the text.
    """
    from ropsim.tasks import body_findings, effect_findings

    base = workspace.knowledge(tasks)
    found = [one for one in base.findings if one.span is not None and one.span.source == name]
    own = [task for task in base.tasks() if task.span.source == name]
    bodies = body_findings(base, environment_of(cell), own) if cell is not None else ()
    more = (*bodies, *effect_findings(base, own))
    return (*found, *(one for one in more if one.span is not None and one.span.source == name))


def world_state(cell: Cell) -> "WorldState":
    """Return the facts in a cell at the start of a run.

    `part(P)`, `location(L)`, `device(D)` and `tool(T)` name the entities, `at(P, L)` and `free(L)` say where
    parts lie, `without_gripper(T)` which tools cannot grasp, and the gripper is open if a tool has a gripper.
    `follows(N, P)` says that a supply brings N to where P has been taken; the place of N before is unknown.
    Whether a location in a moving frame is free is unknown.
    """
    from ropsim.tasks import WorldState

    return WorldState.of(*_facts(cell))


def _facts(cell: Cell) -> Iterator["Term"]:
    from ropsim.prolog import Atom, Struct

    tools, mounted = cell.first.tools, cell.first.default_tool
    bare = [name for name, tool in tools.items() if tool.gripper is None]
    if mounted and len(bare) < len(tools):
        yield Struct("gripper", (Atom("open"),))
    yield from (Struct("without_gripper", (Atom(name),)) for name in bare)
    places = part_places(cell)
    taken = frozenset(places.values())
    for part in cell.parts:
        if part.turn == 0:
            yield Struct("part", (Atom(part.name),))
            if part.name in places:
                yield Struct("at", (Atom(part.name), Atom(places[part.name])))
    yield from (Struct("follows", (Atom(part), Atom(before))) for part, before in parts_behind(cell).items())
    for name in cell.locations:
        yield Struct("location", (Atom(name),))
        if name not in taken and name not in cell.located:
            yield Struct("free", (Atom(name),))
    yield from (Struct("device", (Atom(name),)) for name in cell.devices)
    if mounted:
        yield Struct("tool", (Atom(mounted),))

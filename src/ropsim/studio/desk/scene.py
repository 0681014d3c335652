"""Scene of the cell."""

from functools import partial
from pathlib import Path
from typing import cast

from ropsim.cellfile import mesh_in_files
from ropsim.core import frozen_dataclass
from ropsim.meshes import MeshLibrary, load_meshes
from ropsim.model import Cell
from ropsim.records import numeric
from ropsim.studio.wire.jobs import OpenScene
from ropsim.studio.wire.replies import SceneReply
from ropsim.views import plain_findings, scene
from ropsim.workbench import ProjectError, Workspace, open_overlaid


@frozen_dataclass
class OpenedScene:
    """Result of opening a scene.

    Attributes:
        reply: for the page.
        cell: None where it is broken.
        meshes: of the cell, None without one.
    """

    reply: SceneReply
    cell: Cell | None = None
    meshes: MeshLibrary | None = None


def open_scene(job: OpenScene, known: MeshLibrary | None, workspace: Workspace) -> OpenedScene:
    """Return the scene of a project with unsaved texts.

    Args:
        job: folder and texts.
        known: meshes of an earlier scene; files that have not changed are not converted again.
        workspace: that has read the project before.
    """
    folder = Path(job.folder)
    try:
        project = open_overlaid(folder, job.texts, workspace)
    except ProjectError as error:
        return OpenedScene(SceneReply(None, plain_findings([error.diagnostic]), {}))
    cell = project.cell
    if cell is None:
        return OpenedScene(SceneReply(None, plain_findings(project.diagnostics), {}))
    meshes = load_meshes(folder, cell, partial(mesh_in_files, project.toml_texts), known or MeshLibrary())
    drawn = cast("dict[str, object]", numeric(scene(cell, meshes.addresses)))
    findings = plain_findings((*project.diagnostics, *meshes.diagnostics))
    return OpenedScene(SceneReply(drawn, findings, dict(meshes.contents)), cell, meshes)

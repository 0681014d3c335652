"""The way to pages and texts of workspaces, which is loaded when the first one is written."""

from typing import TYPE_CHECKING

from ropsim.views.terminal.columns import Style

if TYPE_CHECKING:
    from ropsim.workspace import Study


def workspace_page(study: "Study") -> str:
    """Return workspaces and points of a task as one HTML page that needs nothing else."""
    from ropsim.views.reach.page import workspace_page as written

    return written(study)


def workspace_text(study: "Study", style: Style) -> str:
    """Return the terminal text of a study of workspaces."""
    from ropsim.views.reach.terminal import workspace_text as written

    return written(study, style)

"""The built viewer of replays: one script and one style sheet that come with the installation."""

from importlib.resources import files

from ropsim.core import frozen_dataclass


@frozen_dataclass
class Viewer:
    """The viewer.

    Attributes:
        script: its program.
        style: its style sheet.
    """

    script: str
    style: str


def built_viewer() -> Viewer | None:
    """Return the viewer, None where ropsim was installed without its built pages."""
    folder = files("ropsim").joinpath("static", "replay")
    try:
        script = folder.joinpath("replay.js").read_text("utf-8")
        style = folder.joinpath("replay.css").read_text("utf-8")
    except FileNotFoundError:
        return None
    return Viewer(script, style)

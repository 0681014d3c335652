"""Published joint controllers, which come with ropsim as files."""

from importlib.resources import files
from pathlib import Path

from ropsim.blockdiagram.diagnostics import NOT_PUBLISHED, DiagramError
from ropsim.core import SourceText, did_you_mean, read_bytes


def published_controllers() -> tuple[str, ...]:
    """Return the names of the published controllers that come with ropsim: those of robot models."""
    return tuple(sorted(one.stem for one in _folder().glob("*.p21")))


def published_controller(name: str) -> SourceText:
    """Return the file of a published controller; its description cites the source.

    Args:
        name: one of `published_controllers`.

    Raises:
        DiagramError: C619, there is no controller of this name.
    """
    names = published_controllers()
    if name not in names:
        hint = did_you_mean(name, names) or f"there are {', '.join(f'`{one}`' for one in names)}"
        raise DiagramError(
            NOT_PUBLISHED.at(None, f"there is no published controller `{name[:60]}`", hint=hint)
        )
    return SourceText(f"{name}.p21", read_bytes(_folder() / f"{name}.p21").decode("utf-8"))


def _folder() -> Path:
    return Path(str(files("ropsim.blockdiagram").joinpath("library")))

"""The example projects that come with ropsim, and new projects made from them."""

import shutil
import tempfile
from pathlib import Path

from ropsim.core import did_you_mean
from ropsim.workbench.project import ProjectError
from ropsim.workbench.project_diagnostics import NO_EXAMPLE, PLACE_TAKEN
from ropsim.workbench.project_name import name_from_folder, name_project

#: What `ropsim new` copies when no example is named.
STARTER = "first_cell"
_LEFT_OUT = shutil.ignore_patterns("out", "__pycache__")


def example_names() -> tuple[str, ...]:
    """Return the names of the examples."""
    return tuple(sorted(path.parent.name for path in _folder().glob("*/cell.toml")))


def example_summary(name: str) -> str:
    """Return the first comment line of an example's cell file."""
    first = (_folder() / name / "cell.toml").read_text(encoding="utf-8").partition("\n")[0]
    return first.lstrip("# ")


def new_project(place: str | Path, example: str = STARTER) -> Path:
    """Make a project folder from an example and return it; all files appear at once or none does.

    The project has the name of its folder.

    Raises:
        ProjectError: no such example, or the place is taken or cannot be written.
    """
    target = Path(place)
    if example not in example_names():
        known = ", ".join(f"`{name}`" for name in example_names())
        message = f"there is no example `{example}`, there are {known}"
        raise ProjectError(NO_EXAMPLE.at(None, message, hint=did_you_mean(example, example_names())))
    try:
        if target.exists() and (not target.is_dir() or any(target.iterdir())):
            raise ProjectError(PLACE_TAKEN.at(None, f"`{place}` exists and is not an empty folder"))
        target.parent.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=target.parent, prefix=".ropsim-") as work:
            made = Path(work) / "project"
            shutil.copytree(_folder() / example, made, ignore=_LEFT_OUT)
            name_project(made, name_from_folder(target.resolve().name))
            _move(made, target)
    except OSError as error:
        message = f"`{place}` cannot be made: {error.strerror or error}"
        raise ProjectError(PLACE_TAKEN.at(None, message)) from error
    return target


def _move(made: Path, target: Path) -> None:
    """Put a folder at its place; into an empty folder its entries move, `cell.toml` as the last one."""
    if not target.exists():
        made.replace(target)
        return
    for entry in sorted(made.iterdir(), key=lambda entry: entry.name == "cell.toml"):
        entry.replace(target / entry.name)


def _folder() -> Path:
    """Return the folder of the examples: inside an installed package, or beside `src` in a checkout."""
    package = Path(__file__).parents[1]
    installed = package / "examples"
    return installed if installed.is_dir() else package.parents[1] / "examples"

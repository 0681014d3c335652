"""The example projects that come with ropsim: their names, and purposes."""

from pathlib import Path

# Example that `ropsim new` copies when no example is named.
STARTER = "first_cell"


def examples_folder() -> Path:
    """Return the folder of the examples: inside an installed package, or next to `src` in a checkout."""
    package = Path(__file__).parents[1]
    installed = package / "examples"
    return installed if installed.is_dir() else package.parents[1] / "examples"


def example_names() -> tuple[str, ...]:
    """Return the names of the examples."""
    return tuple(sorted(path.parent.name for path in examples_folder().glob("*/cell.toml")))


def example_summary(name: str) -> str:
    """Return the first comment line of an example's cell file."""
    first = (examples_folder() / name / "cell.toml").read_text(encoding="utf-8").partition("\n")[0]
    return first.lstrip("# ")

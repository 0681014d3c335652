"""The one finding on files of a project that do not lie in its folder."""

from ropsim.core.catalogue import define
from ropsim.core.diagnostic import Diagnostic, Severity
from ropsim.core.inside import LeadsOutError
from ropsim.core.span import Span

OUTSIDE_PROJECT = define(
    "U962",
    "outside-project",
    Severity.ERROR,
    "a file of a project does not lie in the project folder",
    """
A project is complete in its folder, and a project from somebody else must not look around on your disk. One
rule holds for every file of a project, for reading and for writing: `cell.toml`, programs, robot files,
meshes, lists of points, texts of tasks and their manifest. A path may neither begin with `/` or a drive nor
contain `..`, and all links on it must stay in the folder. A link from one place of the project to another one
is fine, and so is a project folder that is reached by a link.

Copy the file into the project, robot files best into `robots/`, meshes into `geometry/`.

```toml
[robot]
model = "robots/my_arm.toml"
```
""",
)


def outside_project(name: str, error: LeadsOutError, span: Span | None = None) -> Diagnostic:
    """Return the finding that a file does not lie in the project folder.

    Args:
        name: of the file, as messages use it.
        error: how its path leads out.
        span: where the path is written.
    """
    message = f"`{name[:200]}` {error.strerror}"
    return OUTSIDE_PROJECT.at(span, message, hint="copy the file into the project")

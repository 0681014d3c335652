r"""Print the requirements of a dependency group of pyproject.toml in one line, each without blanks inside.

The line has no end: on Windows that would be `\r\n`, of which a shell keeps the first half.
`pip install --group` needs pip 25.1; the pip that comes with Python 3.11 is older.
"""

import sys
import tomllib
from pathlib import Path


def main(group: str) -> None:
    """Print the requirements of `group`."""
    project = tomllib.loads((Path(__file__).parent.parent / "pyproject.toml").read_text("utf-8"))
    print(*(str(one).replace(" ", "") for one in project["dependency-groups"][group]), end="")


if __name__ == "__main__":
    main(sys.argv[1])

"""Print the requirements of a dependency group of pyproject.toml, one per line.

`pip install --group` needs pip 25.1; the pip that comes with Python 3.11 is older.
"""

import sys
import tomllib
from pathlib import Path


def main(group: str) -> None:
    """Print the requirements of `group` without blanks inside."""
    project = tomllib.loads((Path(__file__).parent.parent / "pyproject.toml").read_text("utf-8"))
    for requirement in project["dependency-groups"][group]:
        print(str(requirement).replace(" ", ""))


if __name__ == "__main__":
    main(sys.argv[1])

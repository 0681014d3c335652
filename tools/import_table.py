"""Write the table of packages in docs/explanation/imports.md, from the imports of their modules.

python tools/import_table.py           write the table
python tools/import_table.py --check   compare only; exit 1 where it differs
"""

import ast
import sys
from pathlib import Path

ROOT = Path(__file__).parent.parent
SOURCE = ROOT / "src" / "ropsim"
PAGE = ROOT / "docs" / "explanation" / "imports.md"
BEGIN = "<!-- imports: written by tools/import_table.py -->"
END = "<!-- end of imports -->"


def imported(text: str) -> set[str]:
    """Return the packages of ropsim that a module imports anywhere in its text."""
    found: set[str] = set()
    for node in ast.walk(ast.parse(text)):
        match node:
            case ast.ImportFrom(module="ropsim", names=names):
                found |= {alias.name for alias in names}
            case ast.ImportFrom(module=str() as module) if module.startswith("ropsim."):
                found.add(module.split(".")[1])
            case _:
                pass
    return found


def packages() -> dict[str, tuple[int, frozenset[str]]]:
    """Return number of modules and imported packages of each package of ropsim, by name."""
    names = sorted(path.parent.name for path in SOURCE.glob("*/__init__.py"))
    table: dict[str, tuple[int, frozenset[str]]] = {}
    for name in names:
        modules = sorted((SOURCE / name).rglob("*.py"))
        others = set().union(*(imported(path.read_text("utf-8")) for path in modules))
        table[name] = len(modules), frozenset(others.intersection(names) - {name})
    return table


def ordered(table: dict[str, tuple[int, frozenset[str]]]) -> list[str]:
    """Return the names of the packages, each before all that it imports; neighbours by name.

    Raises:
        ValueError: packages import each other in a circle.
    """
    left, order = dict(table), []
    while left:
        free = [name for name in left if not any(name in others for _, others in left.values())]
        if not free:
            raise ValueError(f"an import circle among {', '.join(left)}")
        order.append(min(free))
        del left[order[-1]]
    return order


def row(name: str, modules: int, others: frozenset[str]) -> str:
    """Return the row of one package."""
    return f"| `{name}` | {modules} | {', '.join(sorted(others)) or 'nothing'} |"


def page(text: str) -> str:
    """Return the page with the table of today between its markers.

    Raises:
        ValueError: a marker is missing.
    """
    before, rest = text.split(BEGIN)
    _, after = rest.split(END)
    table = packages()
    rows = [row(name, *table[name]) for name in ordered(table)]
    lines = ["| package | modules | imports |", "|---|---|---|", *rows]
    return f"{before}{BEGIN}\n\n" + "\n".join(lines) + f"\n\n{END}{after}"


def main(arguments: list[str]) -> int:
    """Write or check the page; return the exit code."""
    text = PAGE.read_text("utf-8")
    wanted = page(text)
    if arguments == ["--check"]:
        if text != wanted:
            print(f"stale: {PAGE.name}; run python tools/import_table.py")
        return int(text != wanted)
    PAGE.write_text(wanted, "utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

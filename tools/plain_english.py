"""Count words of a private dialect in docstrings and comments, per package of ropsim.

python tools/plain_english.py                  print the table and the worst files
python tools/plain_english.py --words PACKAGE  print each marker of a package with its place
python tools/plain_english.py --check          exit 1 if a package has more than 5 markers per 1,000 words

The words are the regular expressions of `plain_english.toml`. A marker counts once for each place where an
expression matches and no exception covers the match. The same list finds 1 to 3 markers per 1,000 words in
the docstrings and comments of numpy, scipy, pandas and trimesh.
"""

import ast
import io
import re
import sys
import tokenize
import tomllib
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).parent.parent
SOURCE = ROOT / "src" / "ropsim"
LIST = Path(__file__).with_suffix(".toml")
LIMIT = 5.0
"""Markers per 1,000 words that a package may have."""
WORST = 15
"""Files that the table names."""


@dataclass(frozen=True)
class Prose:
    """One docstring or comment.

    Attributes:
        line: number of its first line.
        text: its text; a docstring without quotes, a comment with its `#`.
    """

    line: int
    text: str

    @property
    def words(self) -> int:
        """Number of words."""
        return len(self.text.split())


@dataclass(frozen=True)
class Markers:
    """Regular expressions of the marker words.

    Attributes:
        words: any marker word.
        exceptions: phrases that contain a marker word in its technical sense.
    """

    words: re.Pattern[str]
    exceptions: re.Pattern[str]

    def found(self, text: str) -> list[tuple[int, str]]:
        """Return offset and text of each marker, in order of the text."""
        matches = list(self.words.finditer(text))
        free = [match.span() for match in self.exceptions.finditer(text)] if matches else []
        counted = (one for one in matches if not any(a <= one.start() and one.end() <= b for a, b in free))
        return [(one.start(), one[0]) for one in counted]


def markers(path: Path = LIST) -> Markers:
    """Read the list of marker words."""
    table = tomllib.loads(path.read_text("utf-8"))
    words, exceptions = "|".join(table["words"].values()), "|".join(table["exceptions"])
    return Markers(re.compile(words, re.IGNORECASE), re.compile(exceptions, re.IGNORECASE))


def prose(text: str) -> Iterator[Prose]:
    """Yield the docstrings (of modules, classes, functions, attributes) and comments of a module."""
    for node in ast.walk(ast.parse(text)):
        match node:
            case ast.Expr(value=ast.Constant(value=str() as found)):
                yield Prose(node.lineno, found)
            case _:
                pass
    if "#" not in text:
        return
    for token in tokenize.generate_tokens(io.StringIO(text).readline):
        if token.type == tokenize.COMMENT:
            yield Prose(token.start[0], token.string)


@dataclass(frozen=True)
class Count:
    """Words and markers of a file or a package."""

    name: str
    words: int
    markers: int

    @property
    def share(self) -> float:
        """Markers per 1,000 words."""
        return 1000 * self.markers / self.words if self.words else 0.0


def count(path: Path, among: Markers) -> Count:
    """Return words and markers of one file."""
    found = list(prose(path.read_text("utf-8")))
    name = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else path.as_posix()
    return Count(name, sum(one.words for one in found), sum(len(among.found(one.text)) for one in found))


def counts(package: Path, among: Markers) -> list[Count]:
    """Return words and markers of each file of a package."""
    return [count(path, among) for path in sorted(package.rglob("*.py"))]


def total(name: str, files: list[Count]) -> Count:
    """Return the sum over files."""
    return Count(name, sum(one.words for one in files), sum(one.markers for one in files))


def packages() -> list[Path]:
    """Return the folders of the packages of ropsim, by name."""
    return sorted(path.parent for path in SOURCE.glob("*/__init__.py"))


def _print_words(package: Path, among: Markers) -> None:
    for path in sorted(package.rglob("*.py")):
        for one in prose(path.read_text("utf-8")):
            for offset, word in among.found(one.text):
                line = one.line + one.text.count("\n", 0, offset)
                print(f"{path.relative_to(ROOT)}:{line}: {word}")


def main(arguments: list[str]) -> int:
    """Print the table or the markers of a package, or check the limit; return the exit code."""
    among = markers()
    match arguments:
        case ["--words", name]:
            _print_words(SOURCE / name, among)
            return 0
        case [] | ["--check"]:
            pass
        case _:
            print(__doc__)
            return 2
    files = {path.name: counts(path, among) for path in packages()}
    table = sorted((total(name, found) for name, found in files.items()), key=lambda one: -one.share)
    if arguments == ["--check"]:
        above = [one for one in table if one.share > LIMIT]
        for one in above:
            print(f"{one.name}: {one.share:.1f} markers per 1,000 words, at most {LIMIT:g}")
        return int(bool(above))
    print(f"{'package':<14}{'words':>8}{'markers':>9}{'per 1,000':>11}")
    for one in (*table, total("all", [one for found in files.values() for one in found])):
        print(f"{one.name:<14}{one.words:>8}{one.markers:>9}{one.share:>11.1f}")
    print("\nworst files")
    worst = sorted((one for found in files.values() for one in found), key=lambda one: -one.markers)
    for one in worst[:WORST]:
        print(f"{one.markers:>5}{one.share:>8.1f}  {one.name}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

"""Codes: in the band of their package, each with an up-to-date page."""

import ast
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

from tools.diagnostic_pages import BANDS, RETIRED

from support.sources import trees

ROOT = Path(__file__).parents[2]


@cache
def defined_codes() -> dict[str, str]:
    """Return the package of every code that some source file defines."""
    codes: dict[str, str] = {}
    for path, tree in trees().items():
        for node in ast.walk(tree):
            match node:
                case ast.Call(func=ast.Name("define"), args=[ast.Constant(str() as code), *_]):
                    codes[code] = path.partition("/")[0]
                case _:
                    pass
    return codes


def test_codes_stand_in_the_band_of_their_package() -> None:
    strays = {
        code: package
        for code, package in defined_codes().items()
        if code[:2] not in BANDS or package not in BANDS[code[:2]].packages
    }
    assert strays == {}


def code_literals(path: Path) -> list[str]:
    """Return the places of a file at which the text of a defined code stands, its definition aside."""
    tree = ast.parse(path.read_text("utf-8"))
    calls = [one for one in ast.walk(tree) if isinstance(one, ast.Call)]
    definitions = {id(one.args[0]) for one in calls if ast.unparse(one.func) == "define"}
    found = [one for one in ast.walk(tree) if isinstance(one, ast.Constant) and id(one) not in definitions]
    places = [f"{path.name}:{one.lineno}: {one.value}" for one in found if one.value in defined_codes()]
    by_band = [one for one in calls if ast.unparse(one.func).endswith(".code.startswith")]
    return places + [f"{path.name}:{one.lineno}: {ast.unparse(one)}" for one in by_band]


def test_a_code_stands_in_its_definition_only() -> None:
    """Who treats findings of a class alike reads the category of a finding, or the code of a kind."""
    sources = [path for path in (ROOT / "src" / "ropsim").rglob("*.py") if "static" not in path.parts]
    assert [place for path in sources for place in code_literals(path)] == []
    pages = [one for one in (ROOT / "frontend" / "src").rglob("*.ts*") if ".test." not in one.name]
    quoted = re.compile(rf"""['"`](?:{"|".join(defined_codes())})['"`]""")
    texts = {page.name: page.read_text("utf-8") for page in pages}
    assert {name: found for name, text in texts.items() if (found := quoted.findall(text))} == {}


def test_the_search_for_codes_finds_lists_comparisons_and_bands(tmp_path: Path) -> None:
    source = tmp_path / "lists.py"
    lines = 'A = {"S723", "X1"}', 'b = one.code == "S751"', 'c = one.code.startswith("L")', 'd = "see S751"'
    source.write_text("\n".join(lines))
    assert code_literals(source) == [
        "lists.py:1: S723",
        "lists.py:2: S751",
        "lists.py:3: one.code.startswith('L')",
    ]


def test_no_code_is_used_again() -> None:
    assert sorted(set(defined_codes()) & set(RETIRED)) == []


def test_explain_knows_every_code_that_is_defined() -> None:
    program = "from ropsim.cli.catalogue import all_kinds; print(*all_kinds())"
    listed = subprocess.run(  # a process of its own: tests define kinds too
        [sys.executable, "-c", program], capture_output=True, text=True, check=True
    )
    assert sorted(listed.stdout.split()) == sorted(defined_codes())


def test_every_code_has_its_page_and_every_page_its_code() -> None:
    result = subprocess.run(
        [sys.executable, "tools/diagnostic_pages.py", "--check"],
        cwd=ROOT,
        capture_output=True,
        text=True,
        check=False,
    )
    assert (result.returncode, result.stderr) == (0, ""), result.stdout

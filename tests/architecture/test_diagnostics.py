"""Codes: in the band of their package, each with an up-to-date page."""

import ast
import re
import subprocess
import sys
from functools import cache
from pathlib import Path

from tools.diagnostic_pages import BANDS

from ropsim.cli import RETIRED
from support.sources import nodes, trees

ROOT = Path(__file__).parents[2]


@cache
def defined_codes() -> dict[str, str]:
    """Return the package of every code that some source file defines."""
    codes: dict[str, str] = {}
    for path, tree in trees().items():
        for node in nodes(tree, ast.Call):
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


def code_literals(path: str, tree: ast.Module) -> list[str]:
    """Return the lines of a module at which the text of a defined code stands, its definition aside."""
    calls = [*nodes(tree, ast.Call)]
    definitions = {id(one.args[0]) for one in calls if is_named(one.func, "define")}
    found = [one for one in nodes(tree, ast.Constant) if id(one) not in definitions]
    places = [f"{path}:{one.lineno}: {one.value}" for one in found if one.value in defined_codes()]
    starts = [one for one in calls if is_named(one.func, "startswith")]
    by_band = [one for one in starts if ast.unparse(one.func).endswith(".code.startswith")]
    return places + [f"{path}:{one.lineno}: {ast.unparse(one)}" for one in by_band]


def is_named(function: ast.expr, name: str) -> bool:
    """Return whether the last part of the name of a called function is `name`."""
    return getattr(function, "id", getattr(function, "attr", None)) == name


def test_a_code_stands_in_its_definition_only() -> None:
    """Who treats findings of a class alike reads the category of a finding, or the code of a kind."""
    assert [place for path, tree in trees().items() for place in code_literals(path, tree)] == []
    pages = [one for one in (ROOT / "frontend" / "src").rglob("*.ts*") if ".test." not in one.name]
    quoted = re.compile(rf"""['"`](?:{"|".join(defined_codes())})['"`]""")
    texts = {page.name: page.read_text("utf-8") for page in pages}
    assert {name: found for name, text in texts.items() if (found := quoted.findall(text))} == {}


def test_the_search_for_codes_finds_lists_comparisons_and_bands() -> None:
    lines = 'A = {"S723", "X1"}', 'b = one.code == "S751"', 'c = one.code.startswith("L")', 'd = "see S751"'
    assert code_literals("lists.py", ast.parse("\n".join(lines))) == [
        "lists.py:1: S723",
        "lists.py:2: S751",
        "lists.py:3: one.code.startswith('L')",
    ]


def test_no_code_is_used_again() -> None:
    assert sorted(set(defined_codes()) & set(RETIRED)) == []


def test_retired_codes_lead_to_codes_that_are_defined() -> None:
    led = {code for one in RETIRED.values() for code in re.findall(r"\b[A-Z]\d{3}\b", one.now)}
    assert led
    assert sorted(led - set(defined_codes())) == []


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

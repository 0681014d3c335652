"""Codes: in the band of their package, each with an up-to-date page."""

import ast
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

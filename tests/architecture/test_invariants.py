"""Invariants of ARCHITECTURE.md that can be read off the source: units, the base frame, files."""

import ast

import pytest

from support.sources import trees

EDGES = {"cellfile", "cli", "exchange", "language", "lsp", "robotfile", "robots", "studio", "tomltext"}
EDGES |= {"views"}
"""Where people write and read degrees and millimetres; `robots` has published figures,
`exchange` files with degrees."""
HIGH = {"cli", "studio", "lsp", "workbench", "cellfile", "records", "userfiles"}
HIGH |= {"robotfile", "tomltext", "meshes"}
"""Packages that read and write files of users."""
OWN_FILES = {
    "core/files.py",
    "core/turns.py",
    "codegen/code_digest.py",
    "codegen/machine_code.py",
    "prolog/native/program.py",
}
"""The door to the disk; the compiler's version; machine code that is kept; the folder of a child process."""
OUTPUT = {"print", "open", "input"}


def converts(tree: ast.Module) -> bool:
    """Return whether a module turns radians to degrees, metres to millimetres, or back."""
    return any(
        (isinstance(node, ast.Attribute) and node.attr in {"degrees", "radians", "deg2rad", "rad2deg"})
        or (
            isinstance(node, ast.Constant)
            and ((isinstance(node.value, float) and node.value in {180.0, 1000.0}) or node.value == 180)
        )
        for node in ast.walk(tree)
    )


def words_findings(tree: ast.Module) -> bool:
    """Return whether a module makes findings, or speaks of coordinates in them."""
    modules = {node.module or "" for node in ast.walk(tree) if isinstance(node, ast.ImportFrom)}
    names = {node.name for node in ast.walk(tree) if isinstance(node, ast.FunctionDef)}
    makes = any("diagnostics" in module or module == "ropsim.motion" for module in modules)
    return makes or names >= {"coordinate", "rate"} or any(name.endswith("_words") for name in names)


@pytest.mark.parametrize(
    ("text", "found"),
    [("import math\nx = math.degrees(1.0)", True), ("y = x * 1e3", True), ("hz = 1000", False)],
)
def test_a_change_of_units_is_seen(text: str, found: bool) -> None:
    assert converts(ast.parse(text)) is found


def test_units_change_at_the_edges_and_in_the_words_of_findings_only() -> None:
    inside = {
        path for path, tree in trees().items() if converts(tree) and path.partition("/")[0] not in EDGES
    }
    inside.discard("meshes/reading.py")  # files of meshes do not say their unit
    assert {path for path in inside if not words_findings(trees()[path])} == set()


def test_the_base_frame_begins_in_two_places_and_is_shown_in_one() -> None:
    callers = {
        path
        for path, tree in trees().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == "in_base"
    }
    assert callers == {"workbench/environment.py", "controller/chain.py", "lsp/names.py"}


def test_nothing_below_the_readers_of_files_opens_or_prints() -> None:
    calls = {
        (path, node.func.id)
        for path, tree in trees().items()
        if path.partition("/")[0] not in HIGH and path not in OWN_FILES
        for node in ast.walk(tree)
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id in OUTPUT
    }
    paths = {
        path
        for path, tree in trees().items()
        if path.partition("/")[0] not in HIGH and path not in OWN_FILES
        for node in ast.walk(tree)
        if isinstance(node, ast.Call)
        and isinstance(node.func, ast.Attribute)
        and node.func.attr in {"read_bytes", "write_bytes", "write_text", "mkdir", "unlink"}
    }
    assert (calls, paths) == (set(), set())

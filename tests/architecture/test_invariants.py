"""Invariants of ARCHITECTURE.md that can be read off the source: units, the base frame, files."""

import ast

import pytest

from support.sources import nodes, trees

EDGES = {"cellfile", "cli", "exchange", "language", "lsp", "parts", "robotfile", "robots", "studio"}
EDGES |= {"tomltext", "views"}
"""Where people write and read degrees and millimetres; `robots` and `parts` have published figures,
`exchange` files with degrees."""
HIGH = {"cli", "studio", "lsp", "workbench", "cellfile", "records", "userfiles"}
HIGH |= {"robotfile", "tomltext", "meshes"}
"""Packages that read and write files of users."""
OWN_FILES = {
    "core/disk/files.py",
    "core/disk/inside.py",
    "core/disk/own_folder.py",
    "core/disk/temporary_file.py",
    "codegen/machine/kept_code.py",
    "prolog/native/program.py",
}
"""The doors to the disk; the compiler's version; the folder of a child process."""
OUTPUT = {"print", "open", "input"}


def converts(tree: ast.Module) -> bool:
    """Return whether a module turns radians to degrees, metres to millimetres, or back."""
    by_name = {"degrees", "radians", "deg2rad", "rad2deg"}
    return any(node.attr in by_name for node in nodes(tree, ast.Attribute)) or any(
        (isinstance(node.value, float) and node.value in {180.0, 1000.0}) or node.value == 180
        for node in nodes(tree, ast.Constant)
    )


def words_findings(tree: ast.Module) -> bool:
    """Return whether a module makes findings, or speaks of coordinates in them."""
    modules = {node.module or "" for node in nodes(tree, ast.ImportFrom)}
    names = {node.name for node in nodes(tree, ast.FunctionDef)}
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
        for node in nodes(tree, ast.Call)
        if isinstance(node.func, ast.Name) and node.func.id == "in_base"
    }
    assert callers == {
        "workbench/compiling/environment.py",
        "planning/built_in/standard_chain.py",
        "lsp/analysis/names.py",
    }


def test_nothing_below_the_readers_of_files_opens_or_prints() -> None:
    calls = {
        (path, node.func.id)
        for path, tree in trees().items()
        if path.partition("/")[0] not in HIGH and path not in OWN_FILES
        for node in nodes(tree, ast.Call)
        if isinstance(node.func, ast.Name) and node.func.id in OUTPUT
    }
    paths = {
        path
        for path, tree in trees().items()
        if path.partition("/")[0] not in HIGH and path not in OWN_FILES
        for node in nodes(tree, ast.Call)
        if isinstance(node.func, ast.Attribute)
        and node.func.attr in {"read_bytes", "write_bytes", "write_text", "mkdir", "unlink"}
    }
    assert (calls, paths) == (set(), set())


CACHE_DOOR = {"core/disk/kept_files.py", "core/disk/user_folders.py", "core/disk/own_folder.py"}
"""The one way to what is kept between processes: see `core/disk/kept_files.py`."""
CACHE_NAMES = {"cache_folder", "CACHE_OVERRIDE", "OwnFolder", "lock_file"}
CACHE_TEXTS = ("ROPSIM_CACHE_DIR", "XDG_CACHE_HOME", "XDG_STATE_HOME", "XDG_CONFIG_HOME", "XDG_RUNTIME_DIR")


def names_the_cache(tree: ast.Module) -> bool:
    """Return whether a module knows where the cache folder lies, or reads the variables that say so."""
    names = {node.id for node in nodes(tree, ast.Name)}
    names |= {node.attr for node in nodes(tree, ast.Attribute)}
    names |= {node.name for node in nodes(tree, ast.alias)}
    texts = docstrings(tree)
    in_texts = (node.value in CACHE_TEXTS and node not in texts for node in nodes(tree, ast.Constant))
    return not CACHE_NAMES.isdisjoint(names) or any(in_texts)


def docstrings(tree: ast.Module) -> set[ast.AST]:
    """Return the texts that stand alone, as docstrings do."""
    return {node.value for node in nodes(tree, ast.Expr)}


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("from ropsim.core import cache_folder", True),
        ("import os\nplace = os.environ['XDG_CACHE_HOME']", True),
        ("from ropsim.core.disk.own_folder import OwnFolder", True),
        ("from ropsim.core import KeptFiles", False),
    ],
)
def test_a_way_around_the_door_of_the_cache_is_seen(text: str, found: bool) -> None:
    assert names_the_cache(ast.parse(text)) is found


def test_what_is_kept_goes_through_one_door() -> None:
    found = {path for path, tree in trees().items() if path != "core/__init__.py" and names_the_cache(tree)}
    assert found == CACHE_DOOR


LOCKS = {"fcntl", "msvcrt", "filelock"}


def test_one_module_takes_locks() -> None:
    takers = {
        path
        for path, tree in trees().items()
        if LOCKS & {node.module for node in nodes(tree, ast.ImportFrom)}
        or LOCKS & {one.name for node in nodes(tree, ast.Import) for one in node.names}
    }
    assert takers == {"core/disk/file_lock.py"}


def test_nothing_changes_the_mask_of_permissions() -> None:
    """All threads of a process share it: a change for a moment opens the new files of the others to all."""
    found = {
        path for path, tree in trees().items() for node in nodes(tree, ast.Attribute) if node.attr == "umask"
    }
    assert found == set()


def test_machine_code_is_loaded_where_its_seal_was_checked() -> None:
    loaders = {
        path
        for path, tree in trees().items()
        for node in nodes(tree, ast.Attribute)
        if node.attr in {"deserialize", "deserialize_file", "add_object_file", "CDLL", "LoadLibrary"}
    }
    assert loaders == {"codegen/machine/object_code.py", "prolog/wasm/module_cache.py"}


OWN_READERS = {
    "codegen/machine/kept_code.py",
    "studio/web/pages.py",
    "userfiles/examples.py",
    "workbench/report.py",
}
"""They read files of the package."""


def test_files_of_users_are_read_by_the_reader_that_is_bounded() -> None:
    found = {
        path
        for path, tree in trees().items()
        for node in nodes(tree, ast.Call)
        if (
            (isinstance(node.func, ast.Attribute) and node.func.attr in {"read_bytes", "read_text"})
            or (isinstance(node.func, ast.Name) and node.func.id == "open")
        )
        and not any(isinstance(one, ast.Name) and one.id == "icr" for one in ast.walk(node.func))
    }
    assert (
        found - {"cli/commands/servers.py", "cli/terminal/streams.py"} == OWN_READERS
    )  # those open the streams of the process

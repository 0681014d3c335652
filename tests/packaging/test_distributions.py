"""What an sdist and a wheel carry: built pages, no sources of pages, nothing git ignores otherwise."""

import hashlib
import shutil
import subprocess
import sys
import tarfile
import zipfile
from pathlib import Path

import hatch_build
import pytest

ROOT = Path(__file__).parents[2]
PAGES = {"studio/index.html", "studio/assets/index-1a2b3c.js", "replay/replay.js", "replay/replay.css"}
PROLOG = {Path(name).name for name in hatch_build.PROLOG}


@pytest.fixture(scope="module")
def project(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a small checkout with the real build files and pages that are up to date."""
    root = tmp_path_factory.mktemp("checkout") / "ropsim"
    root.mkdir()
    for name in ("pyproject.toml", "hatch_build.py", ".gitignore", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, root / name)
    shutil.copytree(ROOT / "examples", root / "examples", ignore=shutil.ignore_patterns("out"))
    package = root / "src" / "ropsim"
    for name in ("__init__.py", "version.py"):
        package.mkdir(parents=True, exist_ok=True)
        shutil.copy(ROOT / "src" / "ropsim" / name, package / name)
    for name in PAGES:
        page = package / "static" / name
        page.parent.mkdir(parents=True, exist_ok=True)
        page.write_text(name)
    hatch_build.prolog_folder(root).mkdir(parents=True)
    for name in PROLOG:
        (hatch_build.prolog_folder(root) / name).write_text(name)
    (root / "frontend" / "src").mkdir(parents=True)
    (root / "frontend" / "src" / "main.ts").write_text("1")
    hatch_build.stamp_of(root).write_text(hatch_build.digest(root))
    return root


def built(root: Path, target: str, folder: Path) -> Path:
    """Build a distribution and return its file."""
    subprocess.run(
        [sys.executable, "-m", "hatchling", "build", "-t", target, "-d", str(folder)],
        cwd=root,
        capture_output=True,
        check=True,
    )
    (path,) = folder.iterdir()
    return path


@pytest.fixture(scope="module")
def unpacked(project: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return the folder of an unpacked sdist."""
    folder = tmp_path_factory.mktemp("sdist")
    with tarfile.open(built(project, "sdist", folder / "file")) as archive:
        archive.extractall(folder / "unpacked", filter="data")
    (root,) = (folder / "unpacked").iterdir()
    return root


def contents(wheel: Path) -> dict[str, str]:
    """Return the digest of every file of a wheel by name."""
    with zipfile.ZipFile(wheel) as archive:
        return {name: hashlib.sha256(archive.read(name)).hexdigest() for name in archive.namelist()}


def test_an_sdist_carries_built_pages_and_no_sources_of_them(unpacked: Path) -> None:
    static = unpacked / "src" / "ropsim" / "static"
    assert {path.relative_to(static).as_posix() for path in static.rglob("*") if path.is_file()} == PAGES
    assert {path.name for path in hatch_build.prolog_folder(unpacked).iterdir()} == PROLOG
    assert not (unpacked / "frontend").exists()
    assert (unpacked / "hatch_build.py").is_file()
    assert not hatch_build.is_stale(unpacked)


def test_a_wheel_carries_the_pages_and_the_examples(project: Path, tmp_path: Path) -> None:
    names = set(contents(built(project, "wheel", tmp_path)))
    assert {f"ropsim/static/{name}" for name in PAGES} <= names
    assert {f"ropsim/prolog/data/{name}" for name in PROLOG} <= names
    assert "ropsim/examples/palletizing/cell.toml" in names
    assert [name for name in names if "frontend" in name or name.endswith(".build")] == []


def test_a_wheel_carries_the_kernels_prepared(project: Path, tmp_path: Path) -> None:
    """The back-end of pip finds numba by a `PYTHONPATH` of its own, which the hook must leave."""
    root = tmp_path / "checkout"
    shutil.copytree(project, root)
    source, package = ROOT / "src" / "ropsim", root / "src" / "ropsim"
    for name in ("codegen", "core", "spatial"):
        shutil.copytree(source / name, package / name, ignore=shutil.ignore_patterns("__pycache__", "*.zip"))
    (package / "half_kernel.py").write_text(
        '"""Half."""\n\nfrom ropsim.codegen import Array1, kernel\n\n\n@kernel\n'
        'def half(x: Array1) -> None:\n    """Halve a number."""\n    x[0] *= 0.5\n'
    )
    wheel = built(root, "wheel", tmp_path / "dist")
    with zipfile.ZipFile(wheel) as archive:
        prepared = archive.extract("ropsim/codegen/prepared.zip", tmp_path)
    with zipfile.ZipFile(prepared) as archive:
        (name,) = archive.namelist()
        assert name.startswith("half_")
        assert "@ropsim_entry(" in archive.read(name).decode()


def test_a_wheel_without_numba_is_made_without_kernels(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    root = tmp_path / "checkout"
    shutil.copytree(project, root)
    (root / "src" / "ropsim" / "codegen").mkdir()
    (root / "src" / "ropsim" / "codegen" / "prepare.py").write_text("import numba_that_is_not_there\n")
    names = set(contents(built(root, "wheel", tmp_path / "dist")))
    assert "ropsim/codegen/prepare.py" in names
    assert "ropsim/codegen/prepared.zip" not in names


def test_a_wheel_from_the_sdist_is_the_wheel_from_the_checkout(
    project: Path, unpacked: Path, tmp_path: Path
) -> None:
    from_checkout = contents(built(project, "wheel", tmp_path / "a"))
    assert contents(built(unpacked, "wheel", tmp_path / "b")) == from_checkout

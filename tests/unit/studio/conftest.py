"""A project of which a toy is the simulator."""

from pathlib import Path

import pytest


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    monkeypatch.setenv("ROPSIM_STATE_HOME", str(tmp_path / "state"))
    monkeypatch.setenv("ROPSIM_CONFIG_HOME", str(tmp_path / "config"))
    project = tmp_path / "cell"
    (project / "programs").mkdir(parents=True)
    (project / "controllers").mkdir()
    (project / "cell.toml").write_text("[cell]\n", "utf-8")
    (project / "programs" / "main.task").write_text("x\n", "utf-8")
    (project / "controllers" / "evil.py").write_text("raise SystemExit\n", "utf-8")
    return project

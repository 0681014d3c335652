"""Runs and plans of a cell are under the gravity that its file says."""

from pathlib import Path

import numpy as np
import pytest

import ropsim
from ropsim.flow import Recording

STANDING = 5
"""A sample while the program waits."""


def run(folder: Path, gravity: str) -> Recording:
    (folder / "programs").mkdir(parents=True)
    (folder / "cell.toml").write_text(f'[robot]\nmodel = "puma560"\n[cell]\ngravity = [0, 0, {gravity}]\n')
    text = "program main\nunits mm, deg, s\n\nwait 0.1 s\nmov joints(0, 20, -120, 0, -60, 0)\n"
    (folder / "programs" / "main.task").write_text(text)
    return ropsim.open(folder).simulate()


def test_drives_hold_an_arm_with_the_torque_that_its_weight_asks_for(tmp_path: Path) -> None:
    here, there = (run(tmp_path / name, g) for name, g in (("earth", "-9.81"), ("moon", "-1.62")))
    torques = here.rows("tau")[STANDING], there.rows("tau")[STANDING]
    assert torques[0][1] > 10.0  # N·m
    np.testing.assert_allclose(torques[1], torques[0] * 1.62 / 9.81, atol=1e-3)


def test_a_move_that_no_motor_can_hold_is_refused(tmp_path: Path) -> None:
    recording = run(tmp_path / "giant", "-60")
    (found,) = [one for one in recording.findings if one.is_error]
    assert found.code == "M564"
    assert "186.4 N·m" in found.message
    assert recording.facts.stations[0].skipped_moves == 1


@pytest.mark.parametrize("gravity", ["0", "9.81"])
def test_arms_run_without_weight_and_upside_down(gravity: str, tmp_path: Path) -> None:
    assert run(tmp_path / "cell", gravity).ok

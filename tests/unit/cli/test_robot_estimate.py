"""`ropsim robot estimate`: what it writes, refuses and doubts."""

from pathlib import Path

import pytest

from ropsim.cli.testing import main

ARM = """\
convention = "standard"
joints = [
  { d = 400, alpha = 90, limits = [-170, 170], speed = 200 },
  { a = 500, limits = [-10, 170], speed = 200 },
  { a = 400, limits = [-150, 0], speed = 200 },
]
links = [
  { mass = 9, com = [0, 0, 0], inertia = [0.1, 0.1, 0.1, 0, 0, 0] },
  { mass = 6, com = [-200, 0, 0], inertia = [0.1, 0.1, 0.1, 0, 0, 0] },
  { mass = 3, com = [-200, 0, 0], inertia = [0.1, 0.1, 0.1, 0, 0, 0] },
]
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / "arm.toml"
    path.write_text(ARM, "utf-8")
    return path


def test_the_file_that_is_read_is_not_replaced(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["robot", "estimate", str(file), f"{file.parent}/../{file.parent.name}/arm.toml"]) != 0
    assert "X847" in capsys.readouterr().err
    assert file.read_text("utf-8") == ARM


@pytest.mark.parametrize(("payload", "doubted"), [("5000", True), ("23", True), ("22", False)])
def test_a_payload_above_the_mass_of_the_arm_is_doubted(
    payload: str, doubted: bool, file: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    """Its links have 9 + 6 + 3 kg: four fifths of 22.5 kg."""
    made = file.with_name("made.toml")
    assert main(["robot", "estimate", str(file), str(made), "--payload", payload]) == 0
    written = capsys.readouterr()
    assert ("X926" in written.err) is doubted
    assert made.exists()

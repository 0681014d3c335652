"""No text is lost and none is written over unsaid, whatever users, other programs and crashes do."""

import os
import tempfile
from pathlib import Path

import pytest

from support.examples import examples
from support.text_machine import TextMachine

HISTORIES = int(os.environ.get("ROPSIM_TEXT_HISTORIES", examples(200)))
"""10,000 take a quarter of an hour."""

STEPS, PARTS = 40, 4
MEMORY = Path("/dev/shm")
"""A disk in memory, where there is one: what is asked here is no question of durable disks."""


@pytest.mark.slow
@pytest.mark.parametrize("part", range(PARTS))
def test_no_text_is_lost_and_none_is_written_over_unsaid(
    part: int, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for seed in range(part, HISTORIES, PARTS):
        with tempfile.TemporaryDirectory(dir=MEMORY if MEMORY.is_dir() else tmp_path) as home:
            monkeypatch.setenv("ROPSIM_STATE_HOME", f"{home}/state")
            machine = TextMachine(Path(home).resolve(), seed)
            try:
                machine.run(STEPS)
            except AssertionError as error:
                raise AssertionError(f"history {seed}: {', '.join(machine.history)}: {error}") from error

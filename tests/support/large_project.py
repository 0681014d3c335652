"""The palletizing cell, also with a program of a thousand lines."""

import shutil
from pathlib import Path

from ropsim.core import replace_file

PALLETIZING = Path(__file__).parents[2] / "examples" / "palletizing"
INPUT = b"\n[signals.ready]\ninput = 1\n"
TASK = """\
task Visit{k}(part: loc, clear: length = {k} mm)
  set speed 250 mm/s
  x = clear * 3 - 20 mm / 2
  repeat 3
    mov part above clear
    lin part speed 150 mm/s
    if x > 40 mm then x = x - 1 mm
  endr
  lin part above clear
endp

"""


def large_palletizing(folder: Path, lines: int = 1_000) -> Path:
    """Copy the example with an input, and with tasks that nobody calls: a program of `lines` lines."""
    shutil.copytree(PALLETIZING, folder, ignore=shutil.ignore_patterns("out"))
    cell, program = folder / "cell.toml", folder / "programs" / "main.task"
    replace_file(cell, cell.read_bytes() + INPUT)
    head, loop, tail = program.read_text("utf-8").partition("for each slot")
    missing = lines - (head + loop + tail).count("\n")
    tasks = "".join(TASK.format(k=k + 1) for k in range(-(-missing // TASK.count("\n"))))
    replace_file(program, (head + tasks + loop + tail).encode())
    return folder

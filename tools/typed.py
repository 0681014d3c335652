"""Type random programs into the studio in a real browser: `python -m tools.typed N --first N --pace X`.

Told is each program whose text or depth is another one than a plain editor with auto-indent would have, how
many times Enter met an open list, and how long lists take to come.
"""

import argparse
import shutil
import statistics
import sys
import tempfile
from contextlib import contextmanager
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from support.browser import FLAGS, THRIFTY, UNDRAWN, Pages, launched  # noqa: E402  # the path above is needed first
from support.studio_page import StudioPage  # noqa: E402  # as above
from support.studio_process import Studio  # noqa: E402  # as above
from support.typed_programs import typed_program  # noqa: E402  # as above
from support.typist import Typed, typed  # noqa: E402  # as above

PROJECT = ROOT / "examples" / "first_cell"
FEWEST, MOST = 4, 10
"""Lines of a program."""


def main() -> int:
    """Type what the arguments say and return 1 where a text is another one."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("programs", type=int, nargs="?", default=200, help="how many, default: 200")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="number of the first one")
    parser.add_argument("--pace", type=float, default=1.0, metavar="X", help="factor on waits, default: 1")
    options = parser.parse_args()
    numbers = range(options.first, options.first + options.programs)
    programs = (typed_program(number, FEWEST, MOST) for number in numbers)
    results: list[Typed] = []
    with tempfile.TemporaryDirectory() as place, contextmanager(launched)((*FLAGS, THRIFTY)) as browser:
        folder = Path(place) / "first_cell"
        shutil.copytree(PROJECT, folder, ignore=shutil.ignore_patterns("out"))
        pages = Pages(browser, UNDRAWN)
        with Studio(folder, Path(place) / "home") as studio:
            page = StudioPage.opened(pages, studio.url)
            page.document("main.task")
            for one in typed(page, programs, options.pace):
                results.append(one)
                if one.fault:
                    print(one.fault, flush=True)
            complaints = pages.complaints()
            pages.close()
    _report(results, complaints)
    return 1 if complaints or any(one.fault for one in results) else 0


def _report(results: list[Typed], complaints: list[str]) -> None:
    for complaint in complaints:
        print(f"the page complained: {complaint}")
    breaths = [breath for one in results for breath in one.breaths]
    latencies = [latency for one in results for latency in one.latencies]
    print(
        f"{len(results)} programs, {sum(one.keys for one in results)} keys, "
        f"{sum(one.taken for one in results)} entries taken from lists, "
        f"{sum(bool(one.fault) for one in results)} differ"
    )
    print(f"Enter pressed {len(breaths)} times, {sum(one.listed for one in results)} times with a list open")
    if latencies:
        middle = statistics.median(latencies)
        share = sum(breath > middle for breath in breaths) / max(len(breaths), 1)
        came = f"{len(latencies)} lists, {1e3 * middle:.0f} ms (median) behind a key"
        print(f"{came}; {share:.0%} of the pauses before Enter are longer")


if __name__ == "__main__":
    sys.exit(main())

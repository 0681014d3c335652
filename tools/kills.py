"""Kill everything that is written, many times: `python -m tools.kills --kills N --seed S`.

docs/explanation/robustness.md tells how and what was found.
"""

import argparse
import sys
from itertools import product
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from support.kills.family import killed_job, nursery  # noqa: E402  # the path above is needed first
from support.kills.jobs import JOBS  # noqa: E402


def main() -> int:
    """Kill what the arguments say and return 1 where something was lost."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--kills", type=int, default=50, metavar="N", help="of each job and each way")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="another seed, other moments")
    options = parser.parse_args()
    faults = 0
    ways: tuple[tuple[str, ...], ...] = ((), ("timed",))
    with nursery() as copies:
        for job, how in product(JOBS, ways):
            found = killed_job(copies, job, options.kills, options.seed, *how)
            way = "at random times" if how else f"at {found.moments} counted moments"
            print(f"{job:10} killed {found.killed:4} times {way}  {len(found.faults)} faults")
            for fault in found.faults:
                print(f"  {fault}")
            faults += len(found.faults)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())

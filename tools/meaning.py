"""Read task programs at random in two ways: `python -m tools.meaning --programs N --first N`.

One way is compiler and machine, the other an evaluator written after docs/reference/language.md. Program N is
always the same; `--show N` writes it to standard output. docs/explanation/robustness.md tells what was found.
"""

import argparse
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from support.programs.agreement import disagreement  # noqa: E402  # the path above is needed first
from support.programs.making import spoilt_program  # noqa: E402  # as above
from support.programs.text import written  # noqa: E402  # as above


def main() -> int:
    """Read what the arguments say and return 1 where the two ways differ."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--programs", type=int, default=1000, metavar="N", help="how many programs")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="number of the first one")
    parser.add_argument("--show", type=int, metavar="N", help="write this program to standard output")
    options = parser.parse_args()
    if options.show is not None:
        sys.stdout.write(written(spoilt_program(options.show)))
        return 0
    start = time.process_time()
    differ = too_long = 0
    for seed in range(options.first, options.first + options.programs):
        found = disagreement(seed)
        too_long += found is None
        if found:
            differ += 1
            print(found)
    seconds = time.process_time() - start
    told = f"{options.programs:,} programs, {differ} differ, {too_long:,} too long or too far away"
    print(f"{told}, {seconds:.0f} s of processor")
    return 1 if differ else 0


if __name__ == "__main__":
    sys.exit(main())

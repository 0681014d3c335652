"""Read hostile input by the hundred thousand: `python -m tools.fuzz TARGET --cases N --seed S`.

Each case has a number, and is the same whenever it is made again; `--show NUMBER` writes it to standard
output. Without a target all are fuzzed. docs/explanation/robustness.md tells how and what was found.
"""

import argparse
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

from support.fuzzing.guard import Result, fuzz, nursery  # noqa: E402  # the path above is needed first
from support.fuzzing.targets import NAMES, target_of  # noqa: E402  # as above


def main() -> int:
    """Fuzz what the arguments say and return 1 where something was wrong."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("target", nargs="*", choices=[*NAMES, []], help="what to fuzz, default: everything")
    parser.add_argument("--cases", type=int, default=1000, metavar="N", help="how many inputs of each")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="number of the first input")
    parser.add_argument("--seed", type=int, default=1, metavar="S", help="another seed makes other inputs")
    parser.add_argument("--show", type=int, metavar="N", help="write this input to standard output")
    options = parser.parse_args()
    names = options.target or list(NAMES)
    if options.show is not None:
        sys.stdout.buffer.write(target_of(names[0]).case(options.seed, options.show))
        return 0
    faults = 0
    cases = range(options.first, options.first + options.cases)
    with nursery() as copies:
        for name in names:
            start = time.perf_counter()
            result = fuzz(copies, name, options.seed, cases)
            _tell(result, time.perf_counter() - start)
            faults += len(result.faults)
    return 1 if faults else 0


def _tell(result: Result, seconds: float) -> None:
    print(
        f"{result.target:10} {result.cases:8,} cases  {len(result.faults):3} faults  {seconds:7.0f} s"
        f"  {result.seconds:7.0f} s of processor  {result.peak / 1e6:5.0f} MB at most"
    )
    print(
        "           " + ", ".join(f"{answer} {count:,}" for answer, count in result.answers.most_common(12))
    )
    for number, fault in sorted(result.faults.items()):
        print(f"  case {number}: {fault}")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())

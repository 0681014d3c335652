"""Plan random stretches on every arm of the house: `python -m tools.walks ARM --cases N --first N`.

Each stretch has a number, and is the same whenever it is made again. Told is each that breaks a law: limits
of joints, torque and tool at every control tick, continuity of position and speed, zones that cost time.
"""

import argparse
import sys
import time
from pathlib import Path

ROOT = Path(__file__).parent.parent
sys.path.insert(0, str(ROOT / "tests"))

import numpy as np  # noqa: E402  # the path above is needed first

from ropsim.model import Payload  # noqa: E402  # as above
from support.walking_arms import chain, every_arm  # noqa: E402  # as above
from support.walks import cost_of_zones, faults_of, hairpins, random_walk  # noqa: E402  # as above

LOADS = Payload(), Payload(2.0, np.array([0.02, -0.01, 0.08]))
WALKS = {"of all kinds": random_walk, "of hairpins": hairpins}


def main() -> int:
    """Plan what the arguments say and return 1 where a law was broken."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("arm", nargs="*", choices=[*every_arm(), []], help="which arms, default: all")
    parser.add_argument("--cases", type=int, default=1000, metavar="N", help="how many of each sort")
    parser.add_argument("--first", type=int, default=0, metavar="N", help="number of the first one")
    options = parser.parse_args()
    broken = 0
    for name in options.arm or every_arm():
        for sort, made in WALKS.items():
            start, faults = time.perf_counter(), 0
            for seed in range(options.first, options.first + options.cases):
                walk = made(chain(name), np.random.default_rng(seed))
                found = faults_of(chain(name), walk, LOADS[seed % 2])
                found += cost_of_zones(chain(name), walk, LOADS[seed % 2])
                faults += bool(found)
                for fault in found:
                    print(f"{name}, stretch {seed} {sort}: {fault}", flush=True)
            print(f"{name}: {options.cases} {sort}, {faults} broken, {time.perf_counter() - start:.0f} s")
            broken += faults
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())

"""A process whose copies carry out modules: what these import has been imported once, for all of them.

python -m support.nursery MODULE … imports these and waits for requests.
"""

import json
import os
import subprocess
import sys
import traceback
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from importlib import import_module
from pathlib import Path
from tempfile import TemporaryDirectory
from types import TracebackType
from typing import Self

_TESTS = Path(__file__).parents[1]


@dataclass(frozen=True, slots=True)
class Ended:
    """How a copy has ended.

    Attributes:
        code: exit code, or the negative number of the signal that ended it.
        printed: what it has written to standard output.
        complained: the same for standard error.
    """

    code: int
    printed: str
    complained: str


class Nursery:
    """The process, of which each request forks a copy; it has no threads."""

    def __init__(self, modules: Sequence[str]) -> None:
        """Start it.

        Args:
            modules: by name, with all that their copies are going to need.
        """
        self._process = subprocess.Popen(
            [sys.executable, "-m", "support.nursery", *modules],
            env={**os.environ, "PYTHONPATH": os.pathsep.join([str(_TESTS), *sys.path])},
            stdin=subprocess.PIPE,
            stdout=subprocess.PIPE,
            text=True,
        )

    def __enter__(self) -> Self:
        """Return the running process."""
        return self

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        """End it."""
        self._process.communicate()

    def run(self, module: str, words: Sequence[str], environment: Mapping[str, str]) -> Ended:
        """Call `main` of a module in a copy, as `python -m MODULE` does, and wait for its end.

        Args:
            module: by name.
            words: its arguments.
            environment: variables that are others there.
        """
        assert self._process.stdin is not None
        assert self._process.stdout is not None
        with TemporaryDirectory(prefix="ropsim-copy-") as folder:
            request = {"module": module, "words": words, "environment": environment, "folder": folder}
            self._process.stdin.write(json.dumps(request) + "\n")
            self._process.stdin.flush()
            code = int(self._process.stdout.readline())
            said = [(Path(folder) / name).read_text("utf-8", "replace") for name in ("printed", "complained")]
            return Ended(code, *said)


def _carry_out(request: Mapping[str, object]) -> int:
    """Carry out a request in a copy of this process and return how that has ended."""
    child = os.fork()
    if child:
        return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])
    code = 1
    try:
        _become(request)
        import_module(str(request["module"])).main()
        code = 0
    except SystemExit as end:
        code = end.code if isinstance(end.code, int) else int(end.code is not None)
    except BaseException:
        traceback.print_exc()
    sys.stdout.flush()
    sys.stderr.flush()
    os._exit(code)


def _become(request: Mapping[str, object]) -> None:
    """Give this process the streams, arguments and environment of a request."""
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)
    for number, name in ((1, "printed"), (2, "complained")):
        os.dup2(os.open(Path(str(request["folder"])) / name, os.O_WRONLY | os.O_CREAT), number)
    words, environment = request["words"], request["environment"]
    assert isinstance(words, list)
    assert isinstance(environment, dict)
    os.environ.update(environment)
    sys.argv[:] = [str(request["module"]), *words]


def main() -> None:
    """Import what the arguments name and carry out requests until there are no more."""
    for name in sys.argv[1:]:
        import_module(name)
    for line in sys.stdin:
        sys.stdout.write(f"{_carry_out(json.loads(line))}\n")
        sys.stdout.flush()


if __name__ == "__main__":
    main()

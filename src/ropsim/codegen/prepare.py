"""Write LLVM's texts of all kernels: `python -m ropsim.codegen.prepare ARCHIVE`, while a wheel is made."""

import re
import sys
from collections.abc import Iterator
from importlib import import_module
from pathlib import Path

from ropsim.codegen.kernel import Kernel
from ropsim.codegen.machine.object_code import ENTRY, portable_text, with_entry
from ropsim.codegen.machine.prepared import names_in, prepared_name, write_prepared
from ropsim.core import read_bytes

_PACKAGE = Path(__file__).parents[1]
_MARK = re.compile(b"^@kernel$", re.MULTILINE)


def kernels() -> Iterator[Kernel]:
    """Yield all kernels of ropsim, by module and name."""
    for path in sorted(_PACKAGE.rglob("*.py")):
        if not _MARK.search(read_bytes(path)):
            continue
        module = import_module(".".join(("ropsim", *path.relative_to(_PACKAGE).with_suffix("").parts)))
        for _, one in sorted(vars(module).items()):
            if isinstance(one, Kernel) and one.function.__module__ == module.__name__:
                yield one


def prepare(path: Path) -> int:
    """Write the archive, unless it has the texts of these kernels, and return the number of texts in it.

    Raises:
        ImportError: numba cannot be imported, or its stages are others.
    """
    from ropsim.codegen.machine.numba_stages import STAGES

    wanted = {prepared_name(one.function.__name__, one.source()): one for one in kernels()}
    if names_in(path) != wanted.keys():
        texts = {name: STAGES.llvm_text(one.entry(STAGES)) for name, one in wanted.items()}
        write_prepared({name: portable_text(with_entry(*text), ENTRY) for name, text in texts.items()}, path)
    return len(wanted)


if __name__ == "__main__":
    sys.stdout.write(f"{prepare(Path(sys.argv[1]))} kernels prepared\n")

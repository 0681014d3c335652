"""SWI-Prolog as its npm package `swipl-wasm` brings it: code, packed library, and tables in a script.

The script is never run. Its names of imports and exports are shortened, and the tables say which is which;
other tables say where each file of the library lies in the packed data.
"""

import re
from collections.abc import Mapping
from functools import lru_cache
from hashlib import sha256
from importlib.resources import files
from pathlib import Path

from ropsim.core import RopsimError, frozen_without_equality, read_bytes
from ropsim.prolog.diagnostics import ENGINE_FILES_CHANGED, ENGINE_FILES_MISSING
from ropsim.prolog.wasm.library import Library, Packed

NAMES = ("swipl-web.wasm", "swipl-web.data", "swipl-web.js")
_EXPORT = re.compile(r'_(\w+)=(?:Module\["\w+"\]=)?wasmExports\["([\w$]+)"\]')
_START = re.compile(r'TTY\.init\(\);wasmExports\["([\w$]+)"\]\(\)')
_CALL = re.compile(r"(\d+):\(\$0,\$1\)=>prolog_js_call\(\$0,\$1\)")
_FILE = re.compile(r'\{filename:"([^"]+)",start:([\de.]+),end:([\de.]+)')


@frozen_without_equality
class Artefact:
    """The parts of SWI-Prolog for WebAssembly.

    Attributes:
        code: the module.
        imports: meanings of the short names of imports, such as `fd_write`.
        exports: the short name of each function of C, such as `PL_initialise`.
        start: the short name of the function that prepares the memory.
        call_code: the number under which Prolog calls its host.
        library: the files of SWI-Prolog.
        digest: of code and library.
    """

    code: bytes
    imports: Mapping[str, str]
    exports: Mapping[str, str]
    start: str
    call_code: int
    library: Library
    digest: str


@lru_cache(maxsize=1)
def artefact() -> Artefact:
    """Return SWI-Prolog from the data of the package; it is read once per process.

    Raises:
        RopsimError: the files are missing, because the pages were not built, or are others.
    """
    return artefact_in(Path(str(files("ropsim.prolog").joinpath("data"))))


def artefact_in(folder: Path) -> Artefact:
    """Return SWI-Prolog from the files in a folder.

    Raises:
        RopsimError: the files are missing or of an unknown version.
    """
    try:
        code, data, script = (read_bytes(folder / name) for name in NAMES)
    except OSError as error:
        found = Path(error.filename).name if error.filename else "a file"
        raise RopsimError(
            ENGINE_FILES_MISSING.at(
                None,
                f"SWI-Prolog is not there: `{found}` is missing in `{folder.name}` of ropsim.prolog",
                hint="`make demo` or `python hatch_build.py` fetches it with the pages of the studio",
            )
        ) from error
    try:
        return _read(code, data, script.decode())
    except (AttributeError, ValueError, IndexError) as error:
        raise RopsimError(
            ENGINE_FILES_CHANGED.at(
                None,
                f"the files of SWI-Prolog are not those of swipl-wasm 8.0.5: {error}",
                hint="install ropsim again, or run `python hatch_build.py` in a checkout",
            )
        ) from error


def _read(code: bytes, data: bytes, script: str) -> Artefact:
    """Take the tables out of the script; a missing table raises AttributeError or ValueError."""
    begin = script.index("wasmImports={") + len("wasmImports={")
    pairs = (pair.split(":") for pair in script[begin : script.index("}", begin)].split(","))
    call, start = _CALL.search(script), _START.search(script)
    if call is None or start is None:
        raise ValueError("the script has no call of the host")
    return Artefact(
        code,
        {short: name.removeprefix("_") for short, name in pairs},
        dict(_EXPORT.findall(script)),
        start[1],
        int(call[1]),
        Library(_packed(data, script), _places(script)),
        sha256(code + data).hexdigest(),
    )


def _packed(data: bytes, script: str) -> Packed:
    begin = script.index("compressedData={data:null")
    tables = script[begin : script.index('compressedData["data"]=byteArray', begin)]
    return Packed(data, _numbers("offsets", tables), _numbers("sizes", tables), _numbers("successes", tables))


def _numbers(name: str, tables: str) -> tuple[int, ...]:
    found = re.search(name + r":\[([\de,]*)\]", tables)
    if found is None:
        raise ValueError(f"the script has no table of {name}")
    return tuple(int(float(number)) for number in found[1].split(","))  # 1e3 is a number there


def _places(script: str) -> dict[str, tuple[int, int]]:
    return {path: (int(float(start)), int(float(end))) for path, start, end in _FILE.findall(script)}

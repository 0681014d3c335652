"""Check the sources of the pages: types, lint and format, unit tests.

    python -m tools.frontend

Node comes from the wheel of the `check` group; the packages of the lock file go to `frontend/node_modules`,
and again only when the lock file has changed.
"""

import hashlib
import subprocess
import sys
from pathlib import Path

from hatch_build import PagesError, npm, npm_command, npm_environment

FRONTEND = Path(__file__).parents[1] / "frontend"
CHECKS = ("types", "lint", "test")


def main() -> int:
    """Run all checks and return the exit code."""
    if not FRONTEND.is_dir():
        print("no sources of pages here: an sdist carries them built")
        return 0
    try:
        install()
        failed = [check for check in CHECKS if not passes(check)]
    except PagesError as error:
        print(error, file=sys.stderr)
        return 1
    if failed:
        print(f"frontend: failed: {', '.join(failed)} (`npm run format` formats)", file=sys.stderr)
    return int(bool(failed))


def install() -> None:
    """Install the packages of the lock file where they are not what it says.

    Raises:
        PagesError: npm fails.
    """
    stamp = FRONTEND / "node_modules" / ".installed"
    wanted = hashlib.sha256((FRONTEND / "package-lock.json").read_bytes()).hexdigest()
    if stamp.is_file() and stamp.read_text("ascii") == wanted:
        return
    npm(FRONTEND, "ci", "--include=dev", "--prefer-offline", "--no-audit", "--no-fund")
    stamp.write_text(wanted, "ascii")


def passes(check: str) -> bool:
    """Run one script of package.json, its output shown, and tell whether it went well."""
    command = [*npm_command(), "run", "--silent", check]
    return subprocess.run(command, cwd=FRONTEND, env=npm_environment(), check=False).returncode == 0


if __name__ == "__main__":
    sys.exit(main())

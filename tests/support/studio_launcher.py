"""`ropsim …` as a process of its own, with a tiny page in place of the built ones and few language servers.

Arguments: folder to write the page to, then those of ropsim.
"""

import sys
from pathlib import Path

MOST_LANGUAGE_SERVERS = 3
"""Each is a process."""
INDEX = """<!doctype html>
<html lang="en"><head><meta charset="utf-8"><meta property="csp-nonce" nonce="__CSP_NONCE__">
<title>ropsim studio</title></head><body></body></html>
"""


def make_pages(folder: Path) -> Path:
    """Write the tiny page and one asset, and return their folder."""
    (folder / "assets").mkdir(parents=True, exist_ok=True)
    (folder / "index.html").write_text(INDEX, "utf-8")
    (folder / "assets" / "index-1a2b3c.js").write_text("export const answer = 42\n", "utf-8")
    return folder


def main() -> int:
    """Run the command line with the page."""
    from ropsim.cli.main import main as command_line
    from ropsim.studio.web import pages, sockets

    sockets.MOST_LANGUAGE_SERVERS = MOST_LANGUAGE_SERVERS
    folder = make_pages(Path(sys.argv[1]))
    pages.pages_folder = lambda: folder
    return command_line(sys.argv[2:])


if __name__ == "__main__":
    sys.exit(main())

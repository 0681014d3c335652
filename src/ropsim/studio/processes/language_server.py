"""The language server of a page, in a separate process: the same as `ropsim lsp`, at the end of a socket."""

import socket

from ropsim.lsp import serve


def serve_page(far: socket.socket) -> None:
    """Serve the page at the other end until it closes the socket."""
    with far, far.makefile("rb", buffering=0) as source, far.makefile("wb") as sink:
        serve(source, sink)

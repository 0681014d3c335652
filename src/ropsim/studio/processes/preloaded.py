"""Modules of workers and language servers, for the process whose copies they are."""

import gc

from ropsim.core import without_collection

with without_collection():
    import ropsim.studio.desk
    import ropsim.studio.processes.language_server  # noqa: F401  both are there for the copies

    # Modules stay: copies need not look through them, and share their memory. Put aside here, this process
    # does not look through them either, when the search for garbage is on again.
    gc.freeze()

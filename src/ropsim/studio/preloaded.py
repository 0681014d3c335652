"""All that a worker is made of, for the process whose copies the workers are; it does nothing else."""

import gc

from ropsim.core import without_collection

with without_collection():
    import ropsim.studio.desk  # noqa: F401  it is there for the copies

gc.freeze()  # modules stay: copies need not look through them, and share their memory

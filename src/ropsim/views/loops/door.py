"""The way to pages of responses, which is loaded when the first one is written."""

from ropsim.views.loops.records import LoopPage


def response_page(page: LoopPage) -> str:
    """Return responses and margins of loops as one HTML page that needs nothing else."""
    from ropsim.views.loops.page import response_page as written

    return written(page)

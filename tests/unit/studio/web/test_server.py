from starlette.applications import Starlette

from ropsim.studio.web.server import _configuration


def test_a_page_that_answers_late_is_not_cut_off() -> None:
    """A dialog, a sleeping machine or a busy one may hold it up for any time; it must not lose its line."""
    assert _configuration(Starlette()).ws_ping_interval is None

"""Operations that Windows refuses while another process has the file open."""

from collections.abc import Callable
from time import sleep

PAUSES = (0.01, 0.02, 0.04, 0.08, 0.16)
"""Before each further attempt [s]: a virus scanner or a reader holds a file about as long."""
_HELD = (5, 32)
"""What Windows reports: ERROR_ACCESS_DENIED and ERROR_SHARING_VIOLATION."""


def retried(operation: Callable[[], object]) -> None:
    """Carry out an operation again while Windows refuses it because another process has the file open.

    Args:
        operation: which changes nothing when it fails.

    Raises:
        OSError: the operation failed for another reason, or at the last attempt.
    """
    for pause in PAUSES:
        try:
            operation()
        except PermissionError as error:
            if getattr(error, "winerror", None) not in _HELD:  # no other system sets it
                raise
            sleep(pause)
        else:
            return
    operation()

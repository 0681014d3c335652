"""What wrong use of a knowledge base raises."""

from ropsim.core import RopsimError


class TaskError(RopsimError):
    """A folder, a fact, a goal or a task text cannot be taken as what it should be."""

"""Versions of tasks, by what their task text says."""

import hashlib

from ropsim.tasks.errors import TaskError
from ropsim.tasks.known_task import KnownTask
from ropsim.tasks.task_text import task_text

SHORT = 8
"""Digits of a version that people are shown."""


def version_of(task: KnownTask) -> str:
    """Return the version of a task, by its content: the SHA-256 of its task text, empty where it has none."""
    try:
        return version_of_text(task_text(task))
    except TaskError:
        return ""


def version_of_text(text: str) -> str:
    """Return the SHA-256 of a task text, as 64 digits."""
    return hashlib.sha256(text.encode(errors="surrogatepass")).hexdigest()

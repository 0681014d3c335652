"""Findings as they are sent to a page."""

from collections.abc import Mapping
from typing import Annotated, TypeAlias

from msgspec import Meta

Finding: TypeAlias = Annotated[Mapping[str, object], Meta(title="Finding")]
"""A finding as plain JSON values; its `time` [s] is null where it has none."""

"""Contents of messages that other packages define, as plain JSON values: findings, events, figures, cells."""

from collections.abc import Mapping
from typing import Annotated, TypeAlias

from msgspec import Meta

Finding: TypeAlias = Annotated[Mapping[str, object], Meta(title="Finding")]
"""A finding as plain JSON values; its `time` [s] is null without a time."""

RunEvent: TypeAlias = Annotated[Mapping[str, object], Meta(title="RunEvent")]
"""An event of a run as plain JSON values."""

Result: TypeAlias = Annotated[Mapping[str, object], Meta(title="ResultFigures")]
"""Figures of a run as plain JSON values."""

Ways: TypeAlias = Annotated[Mapping[str, object], Meta(title="WayFacts")]
"""Contacts of a run as plain JSON values."""

Scene: TypeAlias = Annotated[Mapping[str, object], Meta(title="SceneDescription")]
"""Scene of a cell, as plain JSON values."""

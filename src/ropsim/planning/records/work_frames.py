"""Work frames: which tool and which task frame a move is meant in."""

from collections.abc import Mapping, Sequence
from dataclasses import field
from functools import lru_cache

from ropsim.core import Diagnostic, Span, did_you_mean
from ropsim.flow import ModalState, Origin
from ropsim.model import Tool
from ropsim.motion import FRAME_OF_OTHERS, UNKNOWN_FRAME, UNKNOWN_TOOL
from ropsim.planning.records.moving_frames import MovingFrame
from ropsim.planning.records.wording import passes
from ropsim.spatial import Array, Pose, record

_IDENTITY = Pose()


@lru_cache(maxsize=64)
def inverted(X: Pose) -> Pose:
    """Return the inverse of a pose that is needed for many moves, such as that of a tool."""
    return X.inverse()


@record
class WorkFrames:
    """The tools and task frames of the cell; they override the nominal ones of a program.

    Attributes:
        tools: by name.
        frames: X_BK of fixed frames, by name.
        moving: frames moved by external axes of the robot, by name.
        others: names of the stations that move the other ones, by the name of the frame.
        default_tool: name of the tool in force where a program names none; empty for none.
    """

    tools: Mapping[str, Tool] = field(default_factory=dict)
    frames: Mapping[str, Pose] = field(default_factory=dict)
    default_tool: str = ""
    moving: Mapping[str, MovingFrame] = field(default_factory=dict)
    others: Mapping[str, str] = field(default_factory=dict)

    def tool_pose(self, modal: ModalState, span: Span | None) -> Pose | Diagnostic:
        """Return X_MT of the tool in force, or M506 if its pose is undefined.

        Args:
            modal: the modal state of the move.
            span: the source line of the move.
        """
        name = modal.tool or (self.default_tool if modal.X_MT is None else "")
        tool = self.tools.get(name)
        if tool is not None:
            return tool.X_MT
        if modal.X_MT is not None:
            return modal.X_MT
        if not name:
            return _IDENTITY
        known = ", ".join(f"`{tool}`" for tool in sorted(self.tools)) or "none"
        return UNKNOWN_TOOL.at(
            span,
            f"tool `{name}` is not defined, the tools of the cell are {known}",
            hint=did_you_mean(name, self.tools) or f"add `[tools.{name}]` to the cell file",
            data={"tool": name},
        )

    def frame_pose(self, modal: ModalState, q: Array) -> Pose:
        """Return X_BK of the task frame in force.

        Args:
            modal: the modal state of the move.
            q: joint coordinates [rad | m], shape (n,), of which only the external axes count: their values at
                the end of the move.
        """
        moving = self.moving.get(modal.frame)
        return moving.pose(q) if moving else self.frames.get(modal.frame, modal.X_BK)

    def carried(self, modal: ModalState, axes: Sequence[int]) -> MovingFrame | None:
        """Return the task frame in force where one of some external axes moves it, else None.

        Args:
            modal: the modal state of the move.
            axes: numbers of the axes that move.
        """
        moving = self.moving.get(modal.frame)
        return moving if moving and moving.is_moved_by(axes) else None

    def out_of_hand(self, modal: ModalState, span: Span | None) -> tuple[Diagnostic, ...]:
        """Return M519 where another station moves the task frame in force, else nothing."""
        if modal.frame not in self.others:
            return ()
        station = self.others[modal.frame]
        finding = FRAME_OF_OTHERS.at(
            span,
            f"task frame `{modal.frame}` is moved by the station `{station}`, this one cannot work in it",
            hint=f"work in it with the program of `{station}`, or give this one a frame that stands still",
            data={"frame": modal.frame, "station": station},
        )
        return (finding,)

    def frame_findings(self, modal: ModalState, origin: Origin) -> tuple[Diagnostic, ...]:
        """Return M512 where a named task frame has no pose of its own, else nothing."""
        if not modal.frame:
            return ()
        names = {*self.frames, *self.moving, *self.others}
        if modal.frame in names or modal.X_BK != _IDENTITY:
            return ()
        known = ", ".join(f"`{frame}`" for frame in sorted(names)) or "none"
        finding = UNKNOWN_FRAME.at(
            origin.span,
            f"task frame `{modal.frame}` is not defined, the frames of the cell are {known}",
            label=passes(origin),
            hint=did_you_mean(modal.frame, names) or f"add `[frames.{modal.frame}]` to the cell file",
            data={"frame": modal.frame, **origin.data},
        )
        return (finding,)

"""Events in words, for timelines and lists."""

from ropsim.flow import (
    AwaitEvent,
    Event,
    GripEvent,
    InputEvent,
    MessageEvent,
    MoveEvent,
    OutputEvent,
    ReleaseEvent,
    SkipEvent,
    TaskEvent,
    WaitEvent,
)


def event_text(event: Event) -> str:
    """Return an event as a few words, `LIN pass 3` or `LIN to seam 3`; a message has its own text."""
    match event:
        case MoveEvent(motion=motion):
            point = event.origin.point if event.origin else None
            return (
                f"{motion} to point {point.number} of {point.list}"
                if point
                else f"{motion} pass {event.visit}"
            )
        case SkipEvent(motion=motion):
            return f"{motion} not possible"
        case WaitEvent(pause=pause):
            return f"wait {pause:g} s"
        case AwaitEvent(channel=channel, value=value, came=came):
            wanted = channel if value else f"not {channel}"
            return f"wait until {wanted}" + ("" if came else ", in vain")
        case OutputEvent(channel=channel, value=value):
            level = ("off", "on")[value] if isinstance(value, bool) else value
            return f"{channel} = {level}"
        case MessageEvent(text=text) | TaskEvent(name=text):
            return text
        case GripEvent(part=part):
            return f"grip {part}" if part else "close on nothing"
        case ReleaseEvent(part=part):
            return f"release {part}" if part else "open"
        case InputEvent(signal=signal, value=value):
            return f"{signal} = {value:g}"
        case _:
            return event.kind

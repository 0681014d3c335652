"""On what parts stand that have come into the cell or have been released."""

from collections.abc import Collection, Mapping

from ropsim.core import Diagnostic
from ropsim.flow import Origin
from ropsim.kinematics import Blocks, Standing, height_above, part_blocks, stacked, standings
from ropsim.model import WORLD, Cell, SupportLimits, lying_words, spoken_body
from ropsim.simulation.diagnostics.part_diagnostics import RELEASED_IN_THE_AIR, RELEASED_INSIDE
from ropsim.simulation.parts.moment import Moment
from ropsim.simulation.parts.placements import Placements, Seat
from ropsim.simulation.parts.scenery import Scenery
from ropsim.spatial import Pose


def stood(
    state: Placements, names: Collection[str], scenery: Scenery, limits: SupportLimits, moment: Moment
) -> tuple[Placements, dict[str, Standing]]:
    """Return placements in which some parts hang on what carries them, and how each one stands.

    A part keeps its pose, however far it is above or in its support; what nothing carries hangs on the world.
    It moves with what carries it.

    Args:
        state: where the parts are.
        names: of parts that rest.
        scenery: what stands still.
        limits: what counts as standing on something.
        moment: where everything is now.
    """
    poses = moment.poses(state)
    blocks = part_blocks((scenery.parts[name], poses[name]) for name in names)
    others = _others(state, poses, scenery, moment)
    found = dict(zip(names, standings(blocks, others, limits.gap), strict=True))
    seats = state.seats
    state = state.with_seats(
        {
            name: Seat(_parent(one, scenery), seats[name].rides, seats[name].pose)
            for name, one in found.items()
        }
    )
    family = state.family(*names)  # what lies on them rides along
    carriers = {name: _carrier(state, name, scenery, moment) for name in family}
    moved = {
        name: Seat(state.seats[name].parent, carrier, moment.on(carrier, poses[name]))
        for name, carrier in carriers.items()
        if carrier != state.seats[name].rides
    }
    return state.with_seats(moved) if moved else state, found


def _parent(standing: Standing, scenery: Scenery) -> str:
    """Return on what a part hangs that stands so."""
    return scenery.belts.get(standing.on or WORLD, standing.on or WORLD)


def _carrier(state: Placements, name: str, scenery: Scenery, moment: Moment) -> str:
    """Return with what a part moves, by what it hangs on."""
    while name in state.seats:
        name = state.seats[name].parent
    if name in moment.carriers:
        return name
    return scenery.objects[name].rides if name in scenery.objects else WORLD


def release_findings(
    state: Placements,
    name: str,
    standing: Standing,
    scenery: Scenery,
    cell: Cell,
    moment: Moment,
    origin: Origin,
) -> list[Diagnostic]:
    """Return what is wrong with the place where a part has been released; nothing where nobody can know.

    Args:
        state: after the release.
        name: of the part.
        standing: how it stands.
        scenery: what stands still.
        cell: of the run; its limits say what counts as standing on something, and as being in it.
        moment: where everything is now.
        origin: of the instruction.
    """
    if not scenery.ground.known:
        return []
    data: dict[str, object] = {"pass": origin.visit, "part": name}
    if standing.depth > cell.supports.depth:
        return [_inside(name, standing, cell, origin, data)]  # what is held by a body does not fall
    if standing.on is not None:
        return []
    poses = moment.poses(state)
    block = part_blocks([(scenery.parts[name], poses[name])])
    height, below = height_above(block, 0, _others(state, poses, scenery, moment))
    return [_in_the_air(name, height, below, cell, origin, data)]


def _in_the_air(
    name: str, height: float, below: str, cell: Cell, origin: Origin, data: Mapping[str, object]
) -> Diagnostic:
    side, down = ("above", "lower") if height >= 0.0 else ("below", "on something")
    where = f"{abs(height) * 1e3:.1f} mm {side} {spoken_body(cell, below)}"
    return RELEASED_IN_THE_AIR.at(
        origin.span,
        f"part `{name}` is released {where}; {lying_words(cell.supports)}",
        label=f"pass {origin.visit}",
        hint=f"set it down {down}, or put what carries it into the cell file",
        data={**data, "below": below, "height_m": height},
    )


def _inside(
    name: str, standing: Standing, cell: Cell, origin: Origin, data: Mapping[str, object]
) -> Diagnostic:
    return RELEASED_INSIDE.at(
        origin.span,
        f"part `{name}` is released in {spoken_body(cell, standing.inside)}, "
        f"{standing.depth * 1e3:.1f} mm deep, allowed are {cell.supports.depth * 1e3:g} mm",
        label=f"pass {origin.visit}",
        hint="set it down higher or elsewhere; the depth allowed is `depth` in `[supports]`",
        data={**data, "inside": standing.inside, "depth_m": standing.depth},
    )


def _others(state: Placements, poses: Mapping[str, Pose], scenery: Scenery, moment: Moment) -> Blocks:
    """Return what can carry parts: objects, devices, and parts that no tool holds."""
    held, seats, parts = scenery.tools, state.seats, scenery.parts
    resting = part_blocks([(parts[one], X_WO) for one, X_WO in poses.items() if seats[one].rides not in held])
    return stacked([scenery.ground.blocks, moment.solids, resting])

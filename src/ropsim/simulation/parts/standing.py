"""Supports of parts that have come into the cell or have been released."""

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
    """Return placements in which some parts are attached to their supports, and the support of each.

    A part keeps its pose, however far it is above or in its support; a part without support is attached to
    the world. It moves with its support.

    Args:
        state: where the parts are.
        names: of parts that rest.
        scenery: fixed data of the cell.
        limits: tolerances for support.
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
    family = state.family(*names)  # parts on them ride along
    carriers = {name: _carrier(state, name, scenery, moment) for name in family}
    moved = {
        name: Seat(state.seats[name].parent, carrier, moment.on(carrier, poses[name]))
        for name, carrier in carriers.items()
        if carrier != state.seats[name].rides
    }
    return state.with_seats(moved) if moved else state, found


def _parent(standing: Standing, scenery: Scenery) -> str:
    """Return the parent of a part with this support."""
    return scenery.belts.get(standing.on or WORLD, standing.on or WORLD)


def _carrier(state: Placements, name: str, scenery: Scenery, moment: Moment) -> str:
    """Return the carrier of a part, by its parent."""
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
    """Return the findings on the place where a part has been released; none if it cannot be checked.

    Args:
        state: after the release.
        name: of the part.
        standing: how it stands.
        scenery: fixed data of the cell.
        cell: of the run; with tolerances for support and overlap.
        moment: where everything is now.
        origin: of the instruction.
    """
    if not scenery.ground.known:
        return []
    data: dict[str, object] = {**origin.data, "part": name}
    if standing.depth > cell.supports.depth:
        return [_inside(name, standing, cell, origin, data)]  # a part held by a body does not fall
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
    """Return the possible supports of parts: objects, devices, and parts that no tool holds."""
    held, seats, parts = scenery.tools, state.seats, scenery.parts
    resting = part_blocks([(parts[one], X_WO) for one, X_WO in poses.items() if seats[one].rides not in held])
    return stacked([scenery.ground.blocks, moment.solids, resting])

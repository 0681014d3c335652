"""Check the ways of a run for collisions: contacts, the least distance, and omitted checks."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np

from ropsim.collision import COARSE, NO_MESHES, Collisions, MeshPoints, Nearness, Pair, has_filled_hollow
from ropsim.core import Diagnostic, frozen_dataclass
from ropsim.flow import BodyPair, Clearance, Contact, Recording, WayFacts
from ropsim.model import BodyKind, BodyTree, Cell
from ropsim.simulation.servo.diagnostics import DIVERGED
from ropsim.simulation.ways.approaches import Nearest, TrackPairs, nearest, pairs_on_tracks
from ropsim.simulation.ways.carrier_motion import Motion, frames_of, joint_motion_of
from ropsim.simulation.ways.contacts import contacts_of, line_of
from ropsim.simulation.ways.findings import contact_findings, without_contact_findings
from ropsim.simulation.ways.intents import intended
from ropsim.simulation.ways.tracks import tracks

COLLISIONS = "collisions"
"""Name of the check in `checked` of a recording."""


@frozen_dataclass
class RunCollisions:
    """Collisions of a run.

    Attributes:
        findings: an error S751 for each two bodies and line that collide, S771 for each that may, and a
            warning S770 for each that come too near.
        facts: the contacts, the least distance, and omitted checks.
    """

    findings: tuple[Diagnostic, ...] = ()
    facts: WayFacts = WayFacts()


def with_collisions(recording: Recording, found: RunCollisions) -> Recording:
    """Return a recording with its contacts, their findings behind the findings of the run.

    Args:
        recording: of a run.
        found: its collisions.
    """
    checked = tuple(dict.fromkeys((*recording.facts.checked, COLLISIONS)))
    facts = replace(recording.facts, checked=checked, ways=found.facts)
    findings = (*without_contact_findings(recording.findings), *found.findings)
    return replace(recording, findings=findings, facts=facts)


def needs_check(recording: Recording) -> bool:
    """Return whether a run may have collisions that have not been checked yet.

    The ways of an arm that has run away (S701) are none of a machine; they are not checked.

    Args:
        recording: of the run.
    """
    is_lost = any(one.code == DIVERGED.code for one in recording.findings)
    return COLLISIONS not in recording.facts.checked and not is_lost


def run_collisions(
    recording: Recording,
    cell: Cell,
    meshes: MeshPoints = NO_MESHES,
    progress: Callable[[float], None] = lambda _: None,
) -> RunCollisions:
    """Return the contacts of a run, and the least distance between bodies.

    Every body of the robots and devices, with held parts, is checked against everything else at all recorded
    rows at which the two may meet.

    Args:
        recording: of a run in the cell.
        cell: simulated cell.
        meshes: points of its meshes; bodies with others are not checked.
        progress: receives the share that has been checked, from 0 to 1; an exception of it ends the check.
    """
    progress(0.0)
    solids = Collisions(cell, meshes)
    at_start = frozenset(one.pair for one in solids.meetings({}))
    drawn = frozenset(pair for pair in at_start if _has_part(solids.tree, pair)) | {*solids.at_rest}
    made = tracks(solids.tree, recording.placements)
    intents = intended(cell, solids.tree, recording, made)
    checked = pairs_on_tracks(solids, made, intents, drawn, cell.clearance)
    there = {one.body for one in made}
    facts = WayFacts(
        unseen=tuple(name for name in solids.shapeless if name in there),
        met=tuple(BodyPair(*one) for one in sorted(drawn)),
        required=cell.clearance,
    )
    if not len(checked.pairs) or not len(recording.time):
        return RunCollisions((), facts)
    motion = joint_motion_of(solids.tree, recording)
    seen = nearest(solids, checked, motion, progress)
    found = contacts_of(solids, checked, seen, motion, recording, cell, at_start)
    clearance = _deepest(found.deep) or _clearance(solids, checked, seen, motion, recording)
    met = (*facts.met, *(BodyPair(*pair) for pair in found.drawn))
    facts = replace(
        facts,
        clearance=clearance,
        met=met,
        contacts=found.deep,
        near=found.near,
        undecided=found.undecided,
        filled=_filled(solids.tree, (*found.deep, *found.near, *found.undecided)),
    )
    return RunCollisions(contact_findings(replace(recording.facts, ways=facts)), facts)


def _filled(tree: BodyTree, contacts: tuple[Contact, ...]) -> tuple[str, ...]:
    """Return the bodies of contacts of which hollows count as filled, in the order of the tree."""
    met = {name for one in contacts for name in (one.one, one.other)}
    return tuple(
        body.name for body in tree.bodies if body.name in met and any(map(has_filled_hollow, body.shapes))
    )


def _has_part(tree: BodyTree, pair: Pair) -> bool:
    kinds = {body.name: body.kind for body in tree.bodies}
    return any(kinds[name] is BodyKind.PART for name in pair)


def _deepest(contacts: tuple[Contact, ...]) -> Clearance | None:
    """Return the deepest penetration as the least distance of the run; None where there is none."""
    if not contacts:
        return None
    one = min(contacts, key=lambda each: each.distance)
    return Clearance(one.one, one.other, one.distance, one.time, one.station, one.line)


def _clearance(
    solids: Collisions, checked: TrackPairs, seen: Nearest, motion: Motion, recording: Recording
) -> Clearance | None:
    """Return the least distance of a run without penetrations, 0 for touch; None where nothing counts."""
    gaps = np.where(checked.pairs[:, 4] > 0.0, seen.gaps, np.inf)
    pair = int(np.argmin(gaps))
    if not np.isfinite(gaps[pair]):
        return None
    place = float(seen.places[pair])
    found = _at(solids, checked, motion, pair, place)
    time = motion.time_at(place)
    line, station = line_of(checked, pair, time, recording, solids.tree.by_name())
    return Clearance(found.one, found.other, max(found.distance, 0.0), time, station, line)


def _at(solids: Collisions, checked: TrackPairs, motion: Motion, pair: int, place: float) -> Nearness:
    """Return how near a pair is at a place, counted in rows."""
    frames = frames_of(solids.tree, checked.carriers, motion.at(np.array([place])))[:, 0]
    poses = np.zeros((len(solids.bodies.convexes), 12))
    numbers = []
    for values in checked.items[checked.pairs[pair, :2].astype(int)]:
        number, carrier = int(values[0]), int(values[1])
        R, p = values[7:16].reshape(3, 3), values[16:19]
        if carrier >= 0:
            X = frames[carrier]
            R, p = X[:9].reshape(3, 3) @ R, X[:9].reshape(3, 3) @ p + X[9:]
        poses[number, :9], poses[number, 9:] = R.ravel(), p
        numbers.append(number)
    rows = np.array([numbers])
    found = solids.bodies.distances(poses, rows, np.zeros(1), (np.inf, np.inf))
    return solids.bodies.nearness(poses, numbers, found[0], COARSE)

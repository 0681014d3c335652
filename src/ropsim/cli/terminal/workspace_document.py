"""The JSON document of `ropsim robot workspace`: SI units, the frames of the base and of the task."""

from ropsim.workspace import ArmStudy, PointCheck, Standing, Study


def study_document(study: Study) -> dict[str, object]:
    """Return arms with their workspaces, and candidates with their points, as plain data."""
    return {
        "point": study.kind.value,
        "robots": [_arm(one) for one in study.arms],
        "ranking": [_standing(one) for one in study.standings],
    }


def _arm(arm: ArmStudy) -> dict[str, object]:
    space, turned = arm.workspace, arm.dexterity
    return {
        "name": arm.robot.name,
        "workspace": space
        and {
            "sweep": space.sweep.kind.value,
            "unit": "m^2" if space.sweep.measure == "m²" else "m^3",
            "volume": space.volume,
            "error": space.error,
            "extremes": [[one.value for one in space.extremes[k : k + 2]] for k in (0, 2)],
            "assumed_ranges": list(space.ranges.assumed),
        },
        "dexterity": turned
        and {
            "directions": turned.directions.count,
            "volume": turned.volume,
            "error": turned.error,
            "half": turned.half,
            "half_error": turned.half_error,
        },
    }


def _standing(standing: Standing) -> dict[str, object]:
    pose = standing.candidate.X_WB
    return {
        "robot": standing.candidate.robot.name,
        "base": {"position": pose.position.tolist(), "orientation": pose.orientation.tolist()},
        "reached": standing.reached,
        "margin": standing.margin,
        "manipulability": standing.manipulability,
        "points": [_check(one) for one in standing.checks],
    }


def _check(check: PointCheck) -> dict[str, object]:
    reach, miss = check.reach, check.miss
    return {
        "name": check.point.name,
        "position": check.point.position.tolist(),
        "orientation": None if check.point.orientation is None else check.point.orientation.tolist(),
        "reached": reach is not None,
        "q": reach and reach.q.tolist(),
        "posture": reach and reach.posture,
        "ways": reach.ways if reach else 0,
        "margin": reach and reach.margin.share,
        "manipulability": reach and reach.manipulability,
        "directions": check.directions,
        "why": miss and miss.why,
        "distance": miss and miss.distance,
        "angle": miss and miss.angle,
        "beyond_limits": [
            {"joint": one.name, "excess": one.excess} for one in (miss.violations if miss else ())
        ],
    }

"""All targets by name."""

from collections.abc import Mapping

from support.fuzzing import (
    binaries,
    meshes,
    nirox_files,
    part21_files,
    recordings,
    robot_files,
    server,
    texts,
    traces,
)
from support.fuzzing.target import Target

TARGETS: Mapping[str, Target] = {
    one.name: one
    for one in (
        *meshes.TARGETS,
        *texts.TARGETS,
        *binaries.TARGETS,
        *recordings.TARGETS,
        *robot_files.TARGETS,
        *server.TARGETS,
        *traces.TARGETS,
        *part21_files.TARGETS,
        *nirox_files.TARGETS,
    )
}

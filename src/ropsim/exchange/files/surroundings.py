"""Files that a robot file may use: files in its own folder and in packages near to it."""

import os
from collections.abc import Mapping
from pathlib import Path

from ropsim.exchange.files.folder import NO_PACKAGES, RobotFolder
from ropsim.exchange.files.packages import Packages, own_package

_WORKSPACE = "src"  # the folder of a workspace of ROS in which all packages lie
_MOST_ABOVE = 4  # folders between a package and that


def around_file(file: Path, packages: Mapping[str, str] = NO_PACKAGES) -> RobotFolder:
    """Return the files that a robot file anywhere on the disk may use; paths count from the drive.

    Read are files of its package, the nearest folder upwards with a `package.xml`, else of its own folder and
    of the one around that, where meshes usually lie; and files of packages that are given, or lie near
    to it: below the folder `src` of a workspace, else below two folders above the package.

    Args:
        file: the robot file.
        packages: folders of packages by name, absolute or relative to the working folder.
    """
    start = _absolute(Path(file)).parent
    root = Path(start.anchor)
    own = own_package(start, root) or _around(start)
    given = {name: _from(root, _absolute(Path(place))) for name, place in packages.items()}
    found = Packages(root, start, _highest(own), {name: place for name, place in given.items() if place})
    return RobotFolder(root, found, _from(root, start), (_from(root, own),), Path.cwd())


def in_project(project: Path, path: str, packages: Mapping[str, str] = NO_PACKAGES) -> RobotFolder:
    """Return the files that a robot file of a project may use: files of the project.

    Args:
        project: folder of the project, from which paths count.
        path: of the robot file in it, with `/`.
        packages: folders of packages by name, in the project, with `/`; others are found by `package.xml`.
    """
    beside = path.rpartition("/")[0]
    found = Packages(project, project / beside, project, packages)
    return RobotFolder(project, found, beside)


def _around(start: Path) -> Path:
    """Return the folder around another one; the latter itself where the home folder or a drive is around."""
    home = Path("~").expanduser()
    above = start.parent
    is_wide = above in (above.parent, home, *home.parents)
    return start if is_wide else above


def _highest(own: Path) -> Path:
    """Return the highest folder that is searched: `src` of a workspace, else two folders above a package.

    It is below the home folder of the user.
    """
    home = Path("~").expanduser()
    above = [own]
    for place in own.parents[:_MOST_ABOVE]:
        if place == home:
            break
        above.append(place)
        if place.name == _WORKSPACE:
            return place
    return above[:3][-1]


def _absolute(place: Path) -> Path:
    """Return a path from the drive on, without `..`; links stay."""
    return Path(os.path.normpath(place.absolute()))


def _from(root: Path, place: Path) -> str:
    """Return a folder from the root on; empty on another drive."""
    try:
        return os.path.relpath(place, root).replace(os.sep, "/")
    except ValueError:
        return ""

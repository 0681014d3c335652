"""Running a module of the project and its imports, separate from all other modules of the process."""

import builtins
from collections.abc import Mapping, Sequence
from pathlib import PurePosixPath
from types import ModuleType

from ropsim.model import ControllerFile, file_at, import_folders

_NAME = "project_module"


class ModuleLoading:
    """Modules of one project, each run once; `import` in them finds the others.

    Neither `sys.path` nor `sys.modules` is read or changed for them, so that modules of two projects with the
    same name do not meet. Modules that are no files of the project are imported as usual.

    Args:
        file: the module, with the modules that it imports.
    """

    __slots__ = ("_made", "_texts")

    def __init__(self, file: ControllerFile) -> None:
        self._texts = {file.path: file.text, **{one.path: one.text for one in file.modules}}
        self._made: dict[str, ModuleType] = {}

    @property
    def paths(self) -> Sequence[str]:
        """Return the files of the modules."""
        return tuple(self._texts)

    def module(self, path: str) -> ModuleType:
        """Return the module of a file, which is run where it has not been yet; its exceptions are raised."""
        if path in self._made:
            return self._made[path]
        dotted = ".".join((_NAME, *PurePosixPath(path).with_suffix("").parts)) if self._made else _NAME
        module = self._made[path] = ModuleType(dotted)
        module.__file__ = path
        module.__dict__["__builtins__"] = {**vars(builtins), "__import__": self._importer(path)}
        try:
            exec(compile(self._texts[path], path, "exec"), module.__dict__)  # the user trusts the project
        except BaseException:
            del self._made[path]
            raise
        return module

    def _importer(self, importer: str) -> "_Importer":
        return _Importer(self, importer)

    def found(self, importer: str, level: int, name: str) -> PurePosixPath | None:
        """Return where a module of the project lies that another one imports; None for none."""
        for folder in import_folders(importer, level):
            place = folder.joinpath(*name.split(".")) if name else folder
            if self._has(place):
                return place
        return None

    def at(self, place: PurePosixPath) -> ModuleType:
        """Return the module at a place of the project; an empty one for a folder without `__init__.py`."""
        if path := file_at(place, self._texts.__contains__):
            return self.module(path)
        return self._made.setdefault(f"{place}/", ModuleType(".".join((_NAME, *place.parts))))

    def has_module(self, place: PurePosixPath) -> bool:
        """Return whether there is a module or a folder with modules at a place of the project."""
        return self._has(place)

    def _has(self, place: PurePosixPath) -> bool:
        inside = "" if place == PurePosixPath() else f"{place}/"
        is_folder = any(one.startswith(inside) for one in self._texts)
        return is_folder or bool(file_at(place, self._texts.__contains__))


class _Importer:
    """`__import__` of one module of a project."""

    __slots__ = ("_importer", "_loading")

    def __init__(self, loading: ModuleLoading, importer: str) -> None:
        self._loading, self._importer = loading, importer

    def __call__(
        self,
        name: str,
        globals: Mapping[str, object] | None = None,
        locals: Mapping[str, object] | None = None,
        fromlist: Sequence[str] | None = (),
        level: int = 0,
    ) -> ModuleType:
        loading = self._loading
        place = loading.found(self._importer, level, name)
        if place is None:
            if level:
                wanted = "." * level + name
                raise ImportError(f"the project has no module `{wanted}` beside `{self._importer}`")
            return __import__(name, globals, locals, fromlist or (), 0)
        parts = len(name.split(".")) if name else 0
        chain = [place, *list(place.parents)[: parts - 1]][::-1] if parts else [place]
        modules = [loading.at(one) for one in chain]
        for package, inner, where in zip(modules[:-1], modules[1:], chain[1:], strict=True):
            setattr(package, where.name, inner)
        if not fromlist:
            return modules[0]
        for one in fromlist:
            if one != "*" and not hasattr(modules[-1], one) and loading.has_module(place / one):
                setattr(modules[-1], one, loading.at(place / one))
        return modules[-1]

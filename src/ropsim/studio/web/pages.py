"""The built pages, finished runs and meshes, over HTTP."""

import secrets
from collections.abc import Awaitable, Callable, Mapping
from pathlib import Path, PurePath
from urllib.parse import quote

from starlette.requests import Request
from starlette.responses import HTMLResponse, PlainTextResponse, Response
from starlette.routing import BaseRoute, Mount, Route
from starlette.staticfiles import StaticFiles

import ropsim
from ropsim.studio.diagnostics import NO_PAGES, StudioError
from ropsim.studio.session.session import Session
from ropsim.studio.session.workplace import Workplace
from ropsim.studio.web.security import content_policy
from ropsim.studio.wire.jobs import RunForm

NONCE_MARK = "__CSP_NONCE__"
FILES: Mapping[str, tuple[RunForm, str]] = {
    "npz": ("recording", "application/octet-stream"),
    "inputs.json": ("inputs", "application/json"),
    "html": ("report", "text/html; charset=utf-8"),
    "icr": ("code", "text/plain; charset=utf-8"),
}
"""Forms and media types of a finished run by the ending of the file."""

FOR_EVER = {"cache-control": "private, max-age=31536000, immutable"}


def pages_folder() -> Path:
    """Return the folder of the built pages.

    Raises:
        StudioError: U952, they were not built.
    """
    folder = Path(ropsim.__file__).parent / "static" / "studio"
    if not (folder / "index.html").is_file():
        message = "the pages of the studio are not part of this installation"
        hint = (
            "install ropsim again without ROPSIM_SKIP_FRONTEND; in the source tree, `make demo` builds them"
        )
        raise StudioError(NO_PAGES.at(None, message, hint=hint))
    return folder


def routes(folder: Path, workplace: Workplace) -> list[BaseRoute]:
    """Return the routes: `/`, `/assets/…`, `/mesh/<address>.glb`, and runs.

    `/run/<id>.pack` is the data for the page; the other endings are files to keep: recording, inputs as
    `ropsim run --inputs` takes them, report, neutral code. `/told/<id>.pack` is the run of typed commands.
    """

    def index(request: Request) -> Response:
        del request
        nonce = secrets.token_urlsafe(16)
        page = (folder / "index.html").read_text("utf-8").replace(NONCE_MARK, nonce)
        headers = {"content-security-policy": content_policy(nonce), "cache-control": "no-cache"}
        return HTMLResponse(page, headers=headers)

    async def pack(request: Request) -> Response:
        number = _run_number(request)
        content = workplace.session.runs.pack(number) if number is not None else None
        return _bytes(content, "application/octet-stream", {})

    async def told(request: Request) -> Response:
        number = _run_number(request)
        content = workplace.session.command_line.pack(number) if number is not None else None
        return _bytes(content, "application/octet-stream", {})

    async def mesh(request: Request) -> Response:
        content = workplace.session.scenes.mesh(request.path_params["address"])
        return _bytes(content, "model/gltf-binary", FOR_EVER)

    return [
        Route("/", index),
        Route("/run/{run}.pack", pack),
        Route("/told/{run}.pack", told),
        *(Route(f"/run/{{run}}.{ending}", _saved(workplace, ending)) for ending in FILES),
        Route("/mesh/{address}.glb", mesh),
        Mount("/assets", _Assets(directory=folder / "assets")),
    ]


def _saved(workplace: Workplace, ending: str) -> Callable[[Request], Awaitable[Response]]:
    """Return the endpoint for a finished run in one of its forms."""
    form, media_type = FILES[ending]

    async def saved(request: Request) -> Response:
        number, session = _run_number(request), workplace.session
        content = await session.runs.file(number, form) if number is not None else None
        return _bytes(content, media_type, _to_keep(session, ending) if content is not None else {})

    return saved


def _run_number(request: Request) -> int | None:
    """Return the run that an address means, None where it is no number in plain digits."""
    text: str = request.path_params["run"]
    return int(text) if len(text) < 19 and text.isascii() and text.isdecimal() else None


def _to_keep(session: Session, ending: str) -> dict[str, str]:
    """Return headers by which a browser saves a response under the name of the program."""
    name = quote(PurePath(session.runs.newest_program).stem, safe="")
    return {"content-disposition": f"attachment; filename*=UTF-8''{name}.{ending}"}


class _Assets(StaticFiles):
    """Files whose names carry a hash of their content: browsers keep them for ever."""

    def file_response(self, *arguments: object, **options: object) -> Response:
        response = super().file_response(*arguments, **options)  # type: ignore[arg-type]  # passed on unchanged
        response.headers.update(FOR_EVER)
        return response


def _bytes(content: bytes | None, media_type: str, headers: dict[str, str]) -> Response:
    if content is None:
        return PlainTextResponse("there is no such run or mesh any more", status_code=404)
    return Response(content, media_type=media_type, headers=headers)

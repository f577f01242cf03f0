"""Pictures of results: a page to walk through, a report to send, a figure for notebooks.

Needs the extra ``viz``: ``pip install '.[viz]'`` in the sources.

>>> gmcr.viz.report(result, source, target, "report.html", noise_bound=0.02)
>>> gmcr.viz.plot(result, source, target, noise_bound=0.02)
>>> server = gmcr.viz.show(result, source, target, noise_bound=0.02)
"""

from __future__ import annotations

import importlib.util
import threading
from pathlib import Path
from typing import TYPE_CHECKING

from .. import CloudLike, CloudResult, Options, Result
from .._arguments import solver_options
from .prepare import scene_of_result
from .scene import DrawLimits

if TYPE_CHECKING:
    import plotly.graph_objects as go  # type: ignore[import-untyped]
    import viser
    from typing_extensions import Unpack

    from .._keywords import SolverKeywords

__all__ = ["DrawLimits", "plot", "report", "show"]


def plot(
    result: Result | CloudResult,
    source: CloudLike,
    target: CloudLike,
    options: Options | None = None,
    *,
    limits: DrawLimits | None = None,
    **keywords: Unpack[SolverKeywords],
) -> go.Figure:
    """Both clouds and the correspondences, with a slider from before to after.

    Parameters
    ----------
    result : Result or CloudResult
        Of ``register_correspondences`` or ``register_clouds``.
    source, target : array_like, shapes (N, 3) and (M, 3), or paths of clouds
        What the result was computed from, metres.
    options : Options, optional
        Those that the result was computed with.
    limits : DrawLimits, optional
        How much to draw; the legend says how much of it is drawn.
    **keywords
        Fields of ``Options``, instead of ``options``.

    Returns
    -------
    plotly.graph_objects.Figure
        A notebook shows it as it is.

    Raises
    ------
    ImportError
        where plotly is not installed.
    ValueError
        where these are not the points, or not the options, of the result.
    """
    _require("plotly")
    from .figures import clouds_figure

    chosen = _known_options(options, **keywords)
    return clouds_figure(*scene_of_result(result, source, target, chosen, limits))


def report(
    result: Result | CloudResult,
    source: CloudLike,
    target: CloudLike,
    path: str | Path,
    options: Options | None = None,
    *,
    title: str = "Registration",
    limits: DrawLimits | None = None,
    **keywords: Unpack[SolverKeywords],
) -> Path:
    """Writes one HTML file with all that the result says; it opens without a network.

    Parameters
    ----------
    result, source, target, options, limits, **keywords
        As for ``plot``. The noise bound in the residuals and the consensus graph need the options,
        unless this is a CloudResult.
    path : str or Path
        File to write, about 5 MB and more.
    title : str
        Heading of the page.

    Returns
    -------
    Path
        The file.

    Raises
    ------
    ImportError, ValueError
        as ``plot``.
    OSError
        where the file cannot be written.
    """
    _require("plotly")
    from .page import write_page

    chosen = _known_options(options, **keywords)
    outcome, scene = scene_of_result(result, source, target, chosen, limits)
    write_page(Path(path), outcome, scene, title)
    return Path(path)


def show(
    result: Result | CloudResult,
    source: CloudLike,
    target: CloudLike,
    options: Options | None = None,
    *,
    host: str = "127.0.0.1",
    port: int = 8080,
    block: bool = False,
    limits: DrawLimits | None = None,
    **keywords: Unpack[SolverKeywords],
) -> viser.ViserServer:
    """Serves an interactive page: clouds, correspondences, consensus graph, before/after slider.

    viser prints the address.

    Parameters
    ----------
    result, source, target, options, limits, **keywords
        As for ``plot``.
    host : str
        Address to listen on; "0.0.0.0" lets others in.
    port : int
        Port; the next free one where it is taken.
    block : bool
        Return only when interrupted (Ctrl-C), for scripts.

    Returns
    -------
    viser.ViserServer
        ``server.stop()`` ends it.

    Raises
    ------
    ImportError, ValueError
        as ``plot``, with viser in place of plotly.
    """
    _require("viser")
    from .viewer import serve

    chosen = _known_options(options, **keywords)
    server = serve(*scene_of_result(result, source, target, chosen, limits), host, port)
    if block:
        try:
            threading.Event().wait()
        except KeyboardInterrupt:
            server.stop()
    return server


def _known_options(options: Options | None, **keywords: Unpack[SolverKeywords]) -> Options | None:
    """The options as given; None where nothing is said of them, as defaults would be a guess."""
    return solver_options(options, **keywords) if options is not None or keywords else None


def _require(package: str) -> None:
    if importlib.util.find_spec(package) is None:
        raise ImportError(f"gmcr.viz needs {package}: pip install '.[viz]' in the sources of gmcr")

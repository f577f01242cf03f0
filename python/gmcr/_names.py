"""Names that people seek where they are not, answered with where to find it."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from difflib import get_close_matches
from functools import partial
from typing import Any, NoReturn

from ._gmcr import CloudResult, Result, Similarity

_LIKENESS = 0.75  # of a name and the one that it was meant to be

_REGISTER = (
    "gmcr.register_clouds(source, target) for two clouds, or "
    "gmcr.register_correspondences(source, target, noise_bound=0.05) for matched points"
)
_READ = "gmcr.io.read_points(path)"

#: What is sought in the package -> what to write.
_OF_PACKAGE = {
    "register": _REGISTER,
    "registration": _REGISTER,
    "align": _REGISTER,
    "solve": _REGISTER,
    "icp": "gmcr.refine_clouds(result, source, target)",
    "read": _READ,
    "read_points": _READ,
    "read_cloud": "gmcr.io.read_cloud(path)",
    "read_point_cloud": _READ,
    "load": _READ,
    "register_scans": "gmcr.multiview.register_scans(scans)",
    "plot": "gmcr.viz.plot(result, source, target)",
    "show": "gmcr.viz.show(result, source, target)",
    "report": "gmcr.viz.report(result, source, target, 'report.html')",
}

_MATRIX = ".matrix(), the transform (4, 4)"

#: What is sought in a result or a pose -> what to write.
_OF_RESULTS = {
    "transformation": _MATRIX,
    "transform": _MATRIX,
    "pose": _MATRIX,
    "T": _MATRIX,
    "R": ".rotation",
    "t": ".translation",
}


def no_name_of_package(name: str, known: Iterable[str]) -> AttributeError:
    """What to raise where the package has no such name."""
    start = f"module 'gmcr' has no attribute {name!r}"
    if name in _OF_PACKAGE:
        return AttributeError(f"{start}; write {_OF_PACKAGE[name]}")
    near = get_close_matches(name, known, 1, _LIKENESS)
    return AttributeError(f"{start}; did you mean {near[0]!r}?" if near else start)


def answer_for_results() -> None:
    """Has results and poses answer names that they lack.

    Python asks ``__getattr__`` only where a name was not found, so that nothing else is slower.
    """
    kinds: tuple[Any, ...] = (Result, CloudResult, Similarity)
    for kind in kinds:
        kind.__getattr__ = _Answer()


class _Answer:
    """``__getattr__`` of a class whose stub lacks it, since with it every name would pass there."""

    __nb_signature__ = ""  # what the generator of the stub writes of it

    def __get__(self, instance: object, owner: type) -> Callable[[str], NoReturn]:
        return partial(_no_name_of_result, instance)


def _no_name_of_result(given: object, name: str) -> NoReturn:
    start = f"{type(given).__name__!r} object has no attribute {name!r}"
    if name in _OF_RESULTS:
        raise AttributeError(f"{start}; write {_OF_RESULTS[name]}")
    raise AttributeError(start, name=name, obj=given)  # by which Python itself suggests another

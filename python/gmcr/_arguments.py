"""What users may pass, as what the compiled part takes."""

from __future__ import annotations

from typing import Any, Protocol, TypeVar

import numpy as np
import numpy.typing as npt

from ._gmcr import Options, Similarity


class HasPose(Protocol):
    """Anything with a transform, such as a ``Result`` or a ``SyntheticProblem``."""

    @property
    def target_from_source(self) -> Similarity: ...


PoseLike = Similarity | HasPose | npt.ArrayLike
T = TypeVar("T")


def as_points(values: npt.ArrayLike, name: str) -> npt.NDArray[np.float64]:
    """(N, 3) float64 array in C order; the very same array where it is one already.

    Raises
    ------
    ValueError
        naming the argument, where the shape is another or these are no numbers.
    """
    array = np.asarray(values)
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: expected numbers, but the dtype is {array.dtype}")
    if array.ndim != 2 or array.shape[1] != 3:
        raise ValueError(f"{name}: expected shape (N, 3), but it is {array.shape}")
    return np.ascontiguousarray(array, dtype=np.float64)


def as_pose(pose: PoseLike) -> Similarity:
    """Transform of a ``Similarity``, of a result, or of a homogeneous matrix (4, 4)."""
    if isinstance(pose, Similarity):
        return pose
    found = getattr(pose, "target_from_source", None)
    return found if isinstance(found, Similarity) else Similarity.from_matrix(pose)  # type: ignore[arg-type]


def as_options(kind: type[T], options: T | None, keywords: dict[str, Any]) -> T:
    """Options as given, or made from the keywords.

    Raises
    ------
    TypeError
        where both are given, or a keyword is unknown.
    """
    if options is None:
        return kind(**keywords)
    if keywords:
        raise TypeError(f"give options or keywords ({', '.join(keywords)}), not both")
    if not isinstance(options, kind):
        raise TypeError(f"options: expected {kind.__name__}, got {type(options).__name__}")
    return options


_names_of: dict[type[Any], tuple[str, ...]] = {}  # mypy takes no type for functools.cache


def option_names(kind: type[Any]) -> tuple[str, ...]:
    """Names of the options of a kind, such as ``Options``, in their order."""
    if kind not in _names_of:
        _names_of[kind] = tuple(kind().__getstate__())
    return _names_of[kind]


def split_options(
    first: type[T], first_options: T | None, options: Options | None, keywords: dict[str, Any]
) -> tuple[T, Options]:
    """Options of two kinds as given, or made from the keywords; no name is in both.

    Raises
    ------
    TypeError
        where the options of a kind and keywords of it are given, or a keyword is unknown.
    """
    names = option_names(first)
    others = {name: value for name, value in keywords.items() if name not in names}
    own = {name: value for name, value in keywords.items() if name in names}
    return as_options(first, first_options, own), as_options(Options, options, others)

"""What users may pass as poses, and as a pose that the answer is near."""

from __future__ import annotations

import math
from numbers import Real
from typing import Any, Protocol

import numpy as np
import numpy.typing as npt

from ._gmcr import InitialPose, Similarity
from ._points import as_array_like


class HasPose(Protocol):
    """Anything with a transform, such as a ``Result`` or a ``SyntheticProblem``."""

    @property
    def target_from_source(self) -> Similarity: ...


PoseLike = Similarity | HasPose | npt.ArrayLike

#: How a rough pose is given.
NEAR = (
    "initial_pose=pose, max_rotation_error=15, max_translation_error=2, which says how near, in "
    "degrees and metres; one of the two is enough"
)


def as_pose(pose: PoseLike, name: str = "target_from_source") -> Similarity:
    """Transform of a ``Similarity``, of a result, or of a homogeneous matrix (4, 4).

    Raises
    ------
    ValueError
        naming the argument, where it is neither of these.
    """
    if isinstance(pose, Similarity):
        return pose
    found = getattr(pose, "target_from_source", None)
    if isinstance(found, Similarity):
        return found
    matrix = np.asarray(as_array_like(pose))
    if matrix.shape == (4, 4):
        try:
            return Similarity.from_matrix(matrix)
        except ValueError as error:  # names the argument of from_matrix
            raise ValueError(str(error).replace("matrix: ", f"{name}: ", 1)) from None
    advice = ""
    if matrix.shape == (3, 4):
        advice = "; write np.vstack([pose, [0, 0, 0, 1]])"
    elif matrix.shape == (3, 3):
        advice = "; of a rotation alone write gmcr.Similarity(rotation=...)"
    elif matrix.ndim == 2 and matrix.shape[1] == 3 and name != "initial_pose":
        advice = "; the pose comes before the points"
    raise ValueError(
        f"{name}: expected a pose, such as a matrix of shape (4, 4), but it is "
        f"{matrix.shape or type(pose).__name__}{advice}"
    )


def is_pose(given: Any) -> bool:
    """Whether something looks like a pose, where something else was expected."""
    try:
        return isinstance(given, Similarity) or np.shape(given) == (4, 4)
    except ValueError:  # rows of unlike length
        return False


def as_initial_pose(
    pose: InitialPose | PoseLike | None,
    max_rotation_error: float | None,
    max_translation_error: float | None,
) -> InitialPose | None:
    """A pose and how near to it the answer is, as the tool's options of these names take them.

    Parameters
    ----------
    pose : InitialPose, Similarity, Result, array_like of shape (4, 4), or None
        An ``InitialPose`` has its bounds; any other pose needs one of those below, or both.
    max_rotation_error : float, optional
        Degrees in [0, 180]; any rotation where only the other is given.
    max_translation_error : float, optional
        Metres, >= 0; any translation where only the other is given.

    Raises
    ------
    TypeError, ValueError
        with what to write.
    """
    bounds = {
        "max_rotation_error": _checked("max_rotation_error", max_rotation_error, 180, "degrees"),
        "max_translation_error": _checked(
            "max_translation_error", max_translation_error, math.inf, "metres"
        ),
    }
    given = [name for name, bound in bounds.items() if bound is not None]
    if pose is None:
        if given:
            raise TypeError(f"{given[0]}: is a bound around initial_pose=pose, which is not given")
        return None
    if isinstance(pose, InitialPose):
        if given:
            raise TypeError(
                f"{given[0]}: a gmcr.InitialPose has bounds of its own; write "
                f"initial_pose=pose, {given[0]}=..., where pose is a matrix (4, 4)"
            )
        return pose
    target_from_source = as_pose(pose, "initial_pose")
    if not given:
        raise TypeError(f"initial_pose: a pose alone is no bound: write {NEAR}")
    rotation, translation = bounds.values()
    return InitialPose(
        target_from_source=target_from_source,
        max_rotation=math.radians(180 if rotation is None else rotation),
        max_translation=math.inf if translation is None else translation,
    )


def _checked(name: str, bound: Any, largest: float, unit: str) -> float | None:
    if bound is None:
        return None
    if not isinstance(bound, Real) or isinstance(bound, bool):
        raise TypeError(f"{name}: {bound!r} is not a number of {unit}")
    number = float(bound)
    if not 0 <= number <= largest:
        limits = f"in [0, {largest}] {unit}" if math.isfinite(largest) else f">= 0 {unit}"
        raise ValueError(f"{name}: {bound} is not {limits}")
    return number

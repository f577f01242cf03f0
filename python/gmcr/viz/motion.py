"""The way of the source from where it is given to where the transform takes it."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

Floats = npt.NDArray[np.float64]


def angle_axis(rotation: Floats) -> tuple[float, Floats]:
    """Angle in [0, pi] and unit axis, (3,), of a rotation, (3, 3).

    The quaternion is an eigenvector of a symmetric matrix (Bar-Itzhack 2000), which is as sure near
    half a turn as anywhere.
    """
    r = rotation
    cross = np.array([r[2, 1] - r[1, 2], r[0, 2] - r[2, 0], r[1, 0] - r[0, 1]])
    matrix = np.empty((4, 4))
    matrix[:3, :3] = r + r.T - np.trace(r) * np.eye(3)
    matrix[:3, 3] = matrix[3, :3] = cross
    matrix[3, 3] = np.trace(r)
    quaternion = np.linalg.eigh(matrix)[1][:, 3]
    quaternion = quaternion if quaternion[3] >= 0 else -quaternion
    sine = float(np.linalg.norm(quaternion[:3]))
    axis = quaternion[:3] / sine if sine > 0 else np.array([0.0, 0.0, 1.0])
    return 2 * float(np.arctan2(sine, quaternion[3])), axis


@dataclass(frozen=True)
class Motion:
    """A similarity, part of the way.

    Attributes
    ----------
    scale, rotation, translation
        The transform, (3, 3) and (3,).
    centre : ndarray, shape (3,)
        The point of the source that travels in a straight line.
    """

    scale: float
    rotation: Floats
    translation: Floats
    centre: Floats

    def apply(self, points: Floats, share: float = 1.0) -> Floats:
        """Points, (N, 3), after ``share`` in [0, 1] of the way: 0 leaves them, 1 arrives."""
        angle, (x, y, z) = angle_axis(self.rotation)
        cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        turn = np.eye(3) + np.sin(share * angle) * cross
        turn += (1 - np.cos(share * angle)) * cross @ cross
        goal = self.scale * self.rotation @ self.centre + self.translation
        start = (1 - share) * self.centre + share * goal
        moved: Floats = self.scale**share * (points - self.centre) @ turn.T + start
        return moved

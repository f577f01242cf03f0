"""How far transforms move the points of a scan."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

Matrix = npt.NDArray[np.float64]


def rms_motion(transforms: Matrix, spread: Matrix) -> Matrix:
    """RMS distance that transforms move the points of a centred scan by.

    Parameters
    ----------
    transforms : ndarray, shape (..., 4, 4)
        In the frame whose origin is the centroid of the scan.
    spread : ndarray, shape (3, 3)
        Covariance of its points, square metres.

    Returns
    -------
    ndarray, shape (...)
        Metres.
    """
    turn, shift = transforms[..., :3, :3] - np.eye(3), transforms[..., :3, 3]
    by_turn = np.einsum("...ij,jk,...ik->...", turn, spread, turn)
    squared: Matrix = np.maximum(by_turn, 0) + (shift**2).sum(axis=-1)
    return np.sqrt(squared)


def move(points: Matrix, pose: Matrix) -> Matrix:
    """Images of (N, 3) points under a pose (4, 4)."""
    return points @ pose[:3, :3].T + pose[:3, 3]


def translation_by(offset: Matrix) -> Matrix:
    """Pose (4, 4) that adds an offset (3,)."""
    pose = np.eye(4)
    pose[:3, 3] = offset
    return pose


def inverse(pose: Matrix) -> Matrix:
    """Inverse of a rigid pose, (4, 4)."""
    result = np.eye(4)
    result[:3, :3] = pose[:3, :3].T
    result[:3, 3] = -pose[:3, :3].T @ pose[:3, 3]
    return result

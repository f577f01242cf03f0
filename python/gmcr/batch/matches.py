"""Files of correspondences, as the tool reads them."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import numpy.typing as npt

from .. import _gmcr

Floats = npt.NDArray[np.float64]


def read_matches(path: str | Path) -> tuple[Floats, Floats, Floats | None]:
    """Correspondences of a CSV, text or .npy file.

    Parameters
    ----------
    path : path
        (N, 6) numbers ax,ay,az,bx,by,bz, or (N, 7) with a noise bound each; metres. A text may have
        a header, which then says which columns these are.

    Returns
    -------
    source, target : ndarray, shape (N, 3)
        Metres.
    noise_bounds : ndarray, shape (N,), or None
        Metres, where the file has them.

    Raises
    ------
    OSError
        where the file cannot be read or is malformed.
    """
    path = Path(path)
    path.stat()  # a missing file is the usual error; opening it would empty a pipe
    source, target, noise_bounds, _ = _gmcr.read_matches(path)
    return source, target, noise_bounds

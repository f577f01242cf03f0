"""Colours that tell apart for most eyes (Okabe and Ito)."""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

SOURCE = "#e69f00"
TARGET = "#0072b2"
INLIER = "#009e73"
OUTLIER = "#cc79a7"
BOUND = "#333333"
WEAK = "#d55e00"


#: Dark blue over green to yellow, as plotly's Viridis.
_SHADES = ("#440154", "#3b528b", "#21918c", "#5ec962", "#fde725")


def shades(values: npt.NDArray[np.float64], most: float) -> npt.NDArray[np.uint8]:
    """Colours, (n, 3), of values from 0 to ``most``, and of larger ones as of ``most``."""
    places = np.clip(values / (most or 1.0), 0, 1) * (len(_SHADES) - 1)
    known = np.array([rgb(shade) for shade in _SHADES])
    mixed = [np.interp(places, range(len(_SHADES)), known[:, channel]) for channel in range(3)]
    return np.stack(mixed, axis=1).astype(np.uint8)


def rgb(colour: str) -> tuple[int, int, int]:
    """Red, green, blue in [0, 255] of '#rrggbb'."""
    red, green, blue = bytes.fromhex(colour[1:])
    return red, green, blue

"""Colours that tell apart for most eyes (Okabe and Ito)."""

SOURCE = "#e69f00"
TARGET = "#0072b2"
INLIER = "#009e73"
OUTLIER = "#cc79a7"
BOUND = "#333333"


def rgb(colour: str) -> tuple[int, int, int]:
    """Red, green, blue in [0, 255] of '#rrggbb'."""
    red, green, blue = bytes.fromhex(colour[1:])
    return red, green, blue

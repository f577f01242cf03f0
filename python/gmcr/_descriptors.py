"""Matches of descriptors of one's own."""

from __future__ import annotations

from typing import Any

import numpy as np
import numpy.typing as npt

from . import _gmcr
from ._gmcr import DescriptorMatches


def match_descriptors(
    source: npt.ArrayLike,
    target: npt.ArrayLike,
    k: int = 1,
    mutual: bool = True,
    ratio: float = 1.0,
    *,
    num_threads: int = 0,
) -> DescriptorMatches:
    """Nearest neighbours of descriptors, such as learned features: matches for a solve.

    All are compared with all. Of those that tie the smaller index is nearer, and the result is the
    same for any number of threads and on every instruction set.

    Parameters
    ----------
    source, target : array_like, shape (N, D) and (M, D)
        A descriptor a row, of any dimension: numbers, which are compared by Euclidean distance in
        float32; bool, or uint8 that holds eight bits each (as of ORB), by Hamming distance. Both of
        the same kind.
    k : int
        Nearest targets of a source that may match it, >= 1.
    mutual : bool
        Keep a match only where the source is among the k nearest of the target.
    ratio : float
        Keep a match only where its distance is at most this share of that to the (k + 1)-th nearest
        target, in (0, 1]; 1 keeps all.
    num_threads : int
        0 uses every core.

    Returns
    -------
    DescriptorMatches
        ``source_indices``, ``target_indices``, ``distances``.

    Raises
    ------
    ValueError
        on a wrong shape or kind, a value that is not finite, or an option out of range.

    Examples
    --------
    >>> matches = gmcr.match_descriptors(source_features, target_features, ratio=0.9)
    >>> result = gmcr.register_correspondences(
    ...     source[matches.source_indices], target[matches.target_indices], noise_bound=0.05
    ... )
    """
    a, b = _as_rows(source, "source"), _as_rows(target, "target")
    if (a.dtype == np.uint8) != (b.dtype == np.uint8):
        raise ValueError(f"descriptors: one of numbers, the other of bits: {a.dtype}, {b.dtype}")
    if a.dtype == np.uint8:
        return _gmcr.match_binary_descriptors(a, b, k, mutual, ratio, num_threads)
    return _gmcr.match_descriptors(a, b, k, mutual, ratio, num_threads)


def _as_rows(descriptors: npt.ArrayLike, name: str) -> npt.NDArray[Any]:
    """As float32, or as bytes of bits."""
    array = np.asarray(descriptors)
    if array.ndim != 2:
        raise ValueError(f"{name}: expected shape (N, D), but it is {array.shape}")
    if array.dtype == np.bool_:
        return np.packbits(array, axis=1)
    if array.dtype.kind not in "fiu":
        raise ValueError(f"{name}: expected numbers or bits, but the dtype is {array.dtype}")
    kind = np.uint8 if array.dtype == np.uint8 else np.float32
    with np.errstate(over="ignore"):  # what is too large is refused below
        return np.ascontiguousarray(array, dtype=kind)

"""x, y, z among the other fields of records, as numpy reads them in place."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np
import numpy.typing as npt


def coordinates_dtype(fields: Mapping[str, tuple[str, int]], size: int) -> np.dtype[np.void]:
    """Type of records of ``size`` bytes with three of their fields, given as (type, offset).

    Raises
    ------
    ValueError
        where x, y or z is missing, or one lies outside of the record.
    """
    if not {"x", "y", "z"} <= fields.keys():
        raise ValueError(f"no x, y and z among the fields {', '.join(fields) or '(none)'}")
    formats, offsets = zip(*(fields[axis] for axis in "xyz"), strict=True)
    return np.dtype(
        {"names": list("xyz"), "formats": formats, "offsets": offsets, "itemsize": size}
    )


def coordinates_of(records: npt.NDArray[np.void]) -> npt.NDArray[np.float64]:
    """(N, 3) coordinates of the records, in order."""
    return np.stack([records[axis].astype(np.float64).ravel() for axis in "xyz"], axis=1)

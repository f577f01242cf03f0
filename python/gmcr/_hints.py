"""Common mistakes in options, answered with what to write instead."""

from __future__ import annotations

import inspect
import re
from collections.abc import Iterable, Mapping
from difflib import SequenceMatcher, get_close_matches
from typing import Any

import numpy as np

from ._gmcr import CloudMatches, CloudResult, GravityPrior, Options, Result
from ._poses import NEAR, is_pose

_BOUND = "noise_bound=0.05, the largest error of a right match in metres"
_TIME = "time_limit=10, seconds"

#: What other libraries, or the tool, call it -> what to write.
ELSEWHERE = {
    "estimate_scale": "scale_mode='estimated'",
    "with_scaling": "scale_mode='estimated'",
    "cbar2": _BOUND,
    "inlier_threshold": _BOUND,
    "max_correspondence_distance": _BOUND,
    "init": NEAR,
    "initial_guess": NEAR,
    "initial_transform": NEAR,
    "init_T_target_source": NEAR,
    "downsampling_resolution": "voxel_size=0.1, metres",
    "voxel": "voxel_size=0.1, metres",
    "timeout": _TIME,
    "budget": _TIME,
    "time_budget": _TIME,
    "max_time": _TIME,
    "noise": _BOUND,
    "sigma": _BOUND,
    "epsilon": _BOUND,
    "max_rotation": NEAR,
    "n_jobs": "num_threads=4; 0 uses every core",
    "workers": "num_threads=4; 0 uses every core",
}

_MEMORY = re.compile(r"\s*(\d+(?:\.\d+)?)\s*((?:[KMGT]i?)?)B?\s*", re.IGNORECASE)
_BYTES = {
    "": 1,
    **{unit: 1000**power for power, unit in enumerate("KMGT", start=1)},
    **{f"{unit}I": 1024**power for power, unit in enumerate("KMGT", start=1)},
}


def refuse_foreign(names: Iterable[str]) -> None:
    """Refuses names of other libraries.

    Raises
    ------
    TypeError
        with the option of this one.
    """
    for name in names:
        if name in ELSEWHERE:
            raise TypeError(f"{name!r} is no option: write {ELSEWHERE[name]}")


#: How objects that have to be made are made.
_MADE = {
    "GravityPrior": "GravityPrior(source=[0, 0, 1], target=[0, 0, 1], max_tilt=0.03), the "
    "direction in both frames and the angle in radians that it may be off",
    "InitialPose": "InitialPose(target_from_source=pose, max_rotation=0.3, max_translation=2), "
    "radians and metres",
    "Similarity": "Similarity.from_matrix(matrix) for a matrix (4, 4), or "
    "gmcr.Similarity(rotation=R, translation=t)",
    "Options": "Options(noise_bound=0.05), metres",
    "FrontendOptions": "FrontendOptions(voxel_size=0.1), metres",
}


def made_like(class_name: str) -> str:
    """How an object of a class of this package is made, as one would write it."""
    return _MADE.get(class_name, f"{class_name}(name=value)")


def advice(name: str, known: Iterable[str]) -> str:
    """What to write instead of a keyword that a class does not know, or nothing."""
    known = list(known)
    instead = ELSEWHERE.get(name, "")
    if instead.partition("=")[0] in known:
        return f": write {instead}"
    close = get_close_matches(name, known, 1)
    return f"; did you mean {close[0]!r}?" if close else ""


def closeness(name: str, known: Iterable[str]) -> float:
    """How like the most similar of the known names a name is, in [0, 1]."""
    return max(SequenceMatcher(None, name, other).ratio() for other in known)


def of_the_function(error: TypeError, kind: type[Any]) -> TypeError:
    """An error of options that a function made of its keywords, as one of that function."""
    return TypeError(str(error).replace(f"{kind.__name__}()", f"{_called_function()}()", 1))


def refuse_near(names: Iterable[str], known: Iterable[str], meant: Iterable[str]) -> None:
    """Refuses unknown names that are likest to some that the options themselves do not know.

    Raises
    ------
    TypeError
        with that name.
    """
    for name in names:
        if name not in known and closeness(name, meant) > closeness(name, known):
            nearest = max(meant, key=lambda other: closeness(name, [other]))
            raise TypeError(
                f"{_called_function()}() got an unexpected keyword argument {name!r}; "
                f"did you mean {nearest!r}?"
            )


def _called_function() -> str:
    """Name of the function of this package that was called from outside of it."""
    frame = inspect.currentframe()
    name = ""
    while frame and frame.f_globals.get("__name__", "").partition(".")[0] == __package__:
        name = frame.f_code.co_name
        frame = frame.f_back
    return name


def refuse_misread(keywords: Mapping[str, Any]) -> None:
    """Refuses values whose meaning is clear but has to be written otherwise.

    Raises
    ------
    TypeError, ValueError
        with what to write.
    """
    if np.ndim(keywords.get("noise_bound", 0)) > 0:
        raise TypeError("noise_bound: is one number; write noise_bounds=... for one a match")
    refuse_memory_in_words(keywords)
    if not isinstance(keywords.get("gravity"), GravityPrior | None):
        raise TypeError(f"gravity: write gravity=gmcr.{made_like('GravityPrior')}")
    scale_range = keywords.get("scale_range")
    if scale_range is not None:
        _check_range(scale_range, keywords)


def refuse_memory_in_words(keywords: Mapping[str, Any]) -> None:
    """Refuses memory such as '4GB'.

    Raises
    ------
    TypeError
        with the same in bytes.
    """
    for name in ("memory_limit", "max_memory"):
        words = keywords.get(name)
        found = _MEMORY.fullmatch(words) if isinstance(words, str) else None
        if found:
            number = round(float(found[1]) * _BYTES[found[2].upper()])
            raise TypeError(f"{name}: {words!r} is no number of bytes; write {name}={number}")


def _check_range(scale_range: Any, keywords: Mapping[str, Any]) -> None:
    if np.shape(scale_range) == (2,) and scale_range[0] > scale_range[1]:
        raise ValueError(f"scale_range: {tuple(scale_range)} is not (smallest, largest)")
    if keywords.get("scale_mode", "known") == "known":
        raise ValueError(
            "scale_range: is given, but the scale is known; write scale_mode='estimated' too"
        )


def require_cloud_result(result: object, call: str, instead: str = "") -> None:
    """Refuses what is no result of clouds, with what to write.

    Parameters
    ----------
    result : object
        What was given.
    call : str
        The call as it is written.
    instead : str
        What to write where there is no result of clouds yet.

    Raises
    ------
    TypeError
        naming the argument.
    """
    if isinstance(result, CloudResult):
        return
    what = "a pose" if is_pose(result) else type(result).__name__
    start = f"result: expected that of gmcr.register_clouds, but it is {what}"
    if isinstance(result, CloudMatches):
        raise TypeError(f"{start}, without a pose: write result = gmcr.register_clouds(...)")
    if isinstance(result, Result) and not instead:
        raise TypeError(
            f"{start}, of matched points: another pose is judged on these by "
            "gmcr.evaluate_consensus(pose, source, target, noise_bound=0.05)"
        )
    raise TypeError(f"{start}: write {call}{instead and f', or {instead}'}")


def require_bound(options: Options) -> Options:
    """The options, where they have a noise bound or have it estimated.

    Raises
    ------
    ValueError
        where no bound was given.
    """
    is_given = options.noise_mode == "given"
    if is_given and options.noise_bound == 0 and len(options.noise_bounds) == 0:
        raise ValueError(
            f"noise_bound: 0 is no bound; write {_BOUND}, or noise_bound='auto', which takes it "
            "from the data"
        )
    return options


def advice_on(kind: type[Any], given: object) -> str:
    """What to write instead of something that is no options of the kind."""
    if isinstance(given, dict):
        return "; write **options"
    if is_pose(given):
        return f"; write {NEAR}"
    if isinstance(given, (int, float)) and kind is Options:
        return f"; write noise_bound={given}"
    if isinstance(given, Options):
        return "; write options=..."
    if type(given).__name__ == "FrontendOptions":
        return "; write frontend=..."
    return ""

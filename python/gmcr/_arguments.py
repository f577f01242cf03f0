"""What users may pass, as what the compiled part takes."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from ._gmcr import FrontendOptions, InstanceOptions, Options
from ._hints import (
    advice_on,
    closeness,
    of_the_function,
    refuse_foreign,
    refuse_misread,
    refuse_near,
    require_bound,
)
from ._points import CloudLike, PointsLike, as_cloud, as_points
from ._poses import HasPose, PoseLike, as_initial_pose, as_pose

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import (
        CloudInstanceKeywords,
        CloudKeywords,
        InstanceKeywords,
        OptionKeywords,
        SolverKeywords,
    )

__all__ = [
    "CloudLike",
    "HasPose",
    "PointsLike",
    "PoseLike",
    "as_cloud",
    "as_options",
    "as_points",
    "as_pose",
    "bounded_options",
    "check_options",
    "cloud_options",
    "instance_options",
    "option_names",
    "solver_options",
]

T = TypeVar("T")

#: Keywords that go into ``Options.initial_pose``.
_NEARNESS = ("max_rotation_error", "max_translation_error")


def as_options(kind: type[T], options: T | None, keywords: dict[str, Any]) -> T:
    """Options as given, or made from the keywords.

    Raises
    ------
    TypeError
        where both are given, or a keyword is unknown.
    """
    check_options(kind, options, keywords)
    try:
        return kind(**keywords) if options is None else options
    except TypeError as error:
        raise of_the_function(error, kind) from None


def check_options(
    kind: type[T], options: T | None, keywords: dict[str, Any], name: str = "options"
) -> None:
    """Checks what is given for options of a kind, but for values, which the kind itself checks."""
    refuse_foreign(keywords)
    if options is None:
        refuse_misread(keywords)
        return
    if keywords:
        raise TypeError(f"give {name} or keywords ({', '.join(keywords)}), not both")
    if not isinstance(options, kind):
        raise TypeError(
            f"{name}: expected {kind.__name__}, got {type(options).__name__}"
            f"{advice_on(kind, options)}"
        )


_names_of: dict[type[Any], tuple[str, ...]] = {}  # mypy takes no type for functools.cache


def option_names(kind: type[Any]) -> tuple[str, ...]:
    """Names of the options of a kind, such as ``Options``, in their order."""
    if kind not in _names_of:
        _names_of[kind] = tuple(kind().__getstate__())
    return _names_of[kind]


# The functions below hand `**keywords` on as they are to the options themselves, because editors
# complete the keywords of a function by following them there.


def solver_options(
    options: Options | None,
    *,
    max_rotation_error: float | None = None,
    max_translation_error: float | None = None,
    **keywords: Unpack[OptionKeywords],
) -> Options:
    """``as_options`` of the solver, whose initial pose may be any with the bounds beside it."""
    nearness = (max_rotation_error, max_translation_error)
    bounds = {name: n for name, n in zip(_NEARNESS, nearness, strict=True) if n is not None}
    check_options(Options, options, {**keywords, **bounds})
    if options is not None:
        return options
    refuse_near(keywords, option_names(Options), _NEARNESS)
    if bounds or "initial_pose" in keywords:
        keywords["initial_pose"] = as_initial_pose(keywords.get("initial_pose"), *nearness)
    try:
        return Options(**keywords)  # type: ignore[arg-type]
    except TypeError as error:
        raise of_the_function(error, Options) from None


def bounded_options(options: Options | None, **keywords: Unpack[SolverKeywords]) -> Options:
    """``as_options`` of the solver, where it needs a noise bound.

    Raises
    ------
    ValueError
        where none is given.
    """
    return require_bound(solver_options(options, **keywords))


def cloud_options(
    frontend: FrontendOptions | None, options: Options | None, **keywords: Unpack[CloudKeywords]
) -> tuple[FrontendOptions, Options]:
    """Options of the front end and of the solver as given, or made from the keywords.

    Raises
    ------
    TypeError
        where the options of a kind and keywords of it are given, or a keyword is unknown.
    """
    matching = _of_frontend(frontend, **keywords)
    return matching, _beside(FrontendOptions, options, **keywords)


def instance_options(
    instances: InstanceOptions | None, options: Options | None, **keywords: Unpack[InstanceKeywords]
) -> tuple[InstanceOptions, Options]:
    """Options of instances and of the solver, as ``cloud_options``."""
    limits = _of_instances(instances, **keywords)
    return limits, require_bound(_beside(InstanceOptions, options, **keywords))


def cloud_instance_options(
    frontend: FrontendOptions | None,
    options: Options | None,
    instances: InstanceOptions | None,
    **keywords: Unpack[CloudInstanceKeywords],
) -> tuple[FrontendOptions, Options, InstanceOptions]:
    """Options of the front end, the solver and instances, as ``cloud_options``."""
    given: dict[str, Any] = dict(keywords)
    names = [name for name in given if name in option_names(InstanceOptions)]
    limits = _of_instances(instances, **{name: given.pop(name) for name in names})
    return *cloud_options(frontend, options, **given), limits


def _of_frontend(frontend: FrontendOptions | None, **keywords: Any) -> FrontendOptions:
    _keep_those_of(FrontendOptions, keywords)
    check_options(FrontendOptions, frontend, keywords, "frontend")
    try:
        return FrontendOptions(**keywords) if frontend is None else frontend
    except TypeError as error:
        raise of_the_function(error, FrontendOptions) from None


def _of_instances(instances: InstanceOptions | None, **keywords: Any) -> InstanceOptions:
    _keep_those_of(InstanceOptions, keywords)
    check_options(InstanceOptions, instances, keywords, "instances")
    try:
        return InstanceOptions(**keywords) if instances is None else instances
    except TypeError as error:
        raise of_the_function(error, InstanceOptions) from None


def _beside(others: type[Any], options: Options | None, **keywords: Any) -> Options:
    """Options of the solver among keywords that are of another kind too."""
    for name in list(keywords):
        if _is_of(others, name):
            del keywords[name]
    return solver_options(options, **keywords)


def _keep_those_of(kind: type[Any], keywords: dict[str, Any]) -> None:
    for name in list(keywords):
        if not _is_of(kind, name):
            del keywords[name]


def _is_of(kind: type[Any], name: str) -> bool:
    """Whether a name, or a misspelt one by its looks, is of a kind rather than of ``Options``."""
    own, solver = option_names(kind), (*option_names(Options), *_NEARNESS)
    if name in own or name in solver:
        return name in own
    return closeness(name, own) > closeness(name, solver)

"""Reproducible problems with their truth."""

from __future__ import annotations

from typing import TYPE_CHECKING

from . import _gmcr
from ._arguments import CloudLike, as_cloud
from ._enums import SyntheticKind
from ._gmcr import SyntheticOptions, SyntheticProblem
from ._hints import of_the_function

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import SyntheticKeywords, SyntheticKindWord

_PRESETS = {
    SyntheticKind.BALL: SyntheticOptions,
    SyntheticKind.RANDOM: _gmcr.paper_random_options,
    SyntheticKind.STRUCTURED: _gmcr.paper_structured_options,
}


def make_synthetic(
    options: SyntheticOptions | None = None,
    *,
    kind: SyntheticKindWord = "ball",
    model: CloudLike | None = None,
    **keywords: Unpack[SyntheticKeywords],
) -> SyntheticProblem:
    """A random registration problem, the same for the same options on every machine.

    Parameters
    ----------
    options : SyntheticOptions, optional
        Every choice; then neither ``kind`` nor keywords.
    kind : {'ball', 'random', 'structured'}
        Random outliers in a ball, or one of the paper's benchmarks with its settings.
    model : array_like, shape (M, 3), optional
        Points to draw the source from, scaled to fit a cube of edge 1 m; uniform in it by default.
    **keywords
        Fields of ``SyntheticOptions`` that differ from those of the kind.

    Returns
    -------
    SyntheticProblem
        Source, target, true transform, inliers, noise bound.

    Examples
    --------
    >>> problem = gmcr.make_synthetic(num_correspondences=10, outlier_rate=0.3, seed=7)
    >>> int(problem.is_inlier.sum())
    7
    """
    if options is None:
        try:
            options = _PRESETS[SyntheticKind(kind)]()
        except ValueError:
            words = ", ".join(repr(word) for word in SyntheticKind)
            raise ValueError(f"kind: {kind!r} is not one of {words}") from None
        try:
            changed = SyntheticOptions(**keywords)
        except TypeError as error:
            raise of_the_function(error, SyntheticOptions) from None
        for name in keywords:
            setattr(options, name, getattr(changed, name))
    elif not isinstance(options, SyntheticOptions):
        advice = f"; write kind={options!r}" if isinstance(options, str) else ""
        raise TypeError(f"options: expected SyntheticOptions, got {type(options).__name__}{advice}")
    elif keywords or kind != "ball":
        raise TypeError("give options, or kind and keywords, not both")
    if model is None:
        return _gmcr.make_synthetic(options)
    return _gmcr.make_synthetic(options, as_cloud(model, "model"))

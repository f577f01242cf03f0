"""Choices of words. Members compare equal to their words, which may be given in their place."""

from __future__ import annotations

import enum


class _Word(str, enum.Enum):
    def __str__(self) -> str:
        return str(self.value)

    def __repr__(self) -> str:
        return repr(self.value)


class Status(_Word):
    """What a registration came to."""

    OK = "ok"
    TOO_FEW_CORRESPONDENCES = "too_few_correspondences"
    NO_CONSENSUS = "no_consensus"
    DEGENERATE = "degenerate"


class Method(_Word):
    """How correspondences are registered."""

    GMCR = "gmcr"
    PAPER = "paper"


class Evidence(_Word):
    """What is maximised."""

    DISTINCT = "distinct"
    COUNT = "count"


class ScaleMode(_Word):
    """Whether the scale is known."""

    KNOWN = "known"
    ESTIMATED = "estimated"


class NoiseMode(_Word):
    """Whether the noise bound is known."""

    GIVEN = "given"
    ESTIMATED = "estimated"


class NormalOrientation(_Word):
    """Which side of the surface the normals point to."""

    AUTOMATIC = "automatic"
    TOWARD_VIEWPOINT = "toward_viewpoint"
    OUTWARD = "outward"


class Refine(_Word):
    """What makes the pose of two clouds finer than the matches do."""

    ICP = "icp"
    NONE = "none"


class Verdict(_Word):
    """How far the pose of two clouds can be relied on."""

    TRUSTED = "trusted"
    DOUBTFUL = "doubtful"
    UNTRUSTED = "untrusted"


class SyntheticKind(_Word):
    """Kinds of synthetic problems."""

    BALL = "ball"
    RANDOM = "random"
    STRUCTURED = "structured"


class NoiseShape(_Word):
    """Distributions of the noise of synthetic problems."""

    BALL = "ball"
    GAUSSIAN = "gaussian"
    CUBE = "cube"

"""The options as typed keywords, for editors and type checkers.

Their values, units and defaults are those of the fields of the same name of ``gmcr.Options`` and
the others; a test holds the two together.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal, TypedDict

import numpy.typing as npt

from ._enums import (
    Evidence,
    Method,
    NoiseMode,
    NoiseShape,
    NormalOrientation,
    Refine,
    ScaleMode,
    SyntheticKind,
)
from ._gmcr import GravityPrior, InitialPose
from ._poses import PoseLike

EvidenceWord = Literal["distinct", "count"] | Evidence
MethodWord = Literal["gmcr", "paper"] | Method
NoiseModeWord = Literal["given", "estimated"] | NoiseMode
NoiseShapeWord = Literal["ball", "gaussian", "cube"] | NoiseShape
OrientationWord = Literal["automatic", "toward_viewpoint", "outward"] | NormalOrientation
RefineWord = Literal["icp", "none"] | Refine
ScaleModeWord = Literal["known", "estimated"] | ScaleMode
SyntheticKindWord = Literal["ball", "random", "structured"] | SyntheticKind


class OptionKeywords(TypedDict, total=False):
    """Fields of ``gmcr.Options``; ``noise_bound='auto'`` is ``noise_mode='estimated'``."""

    noise_mode: NoiseModeWord
    noise_bound: float | Literal["auto"]
    noise_bounds: npt.ArrayLike | None
    scale_mode: ScaleModeWord
    scale: float
    scale_range: Sequence[float] | None
    method: MethodWord
    evidence: EvidenceWord
    gravity: GravityPrior | None
    initial_pose: InitialPose | PoseLike | None
    max_translation: float
    one_to_one: bool
    num_hypotheses: int
    certify: bool
    num_threads: int
    time_limit: float
    memory_limit: int
    progress: Callable[[str, float], bool | None] | None


class SolverKeywords(OptionKeywords, total=False):
    """Those, and how near to an ``initial_pose`` that has no bounds the answer is.

    ``max_rotation_error`` in degrees in [0, 180], ``max_translation_error`` in metres, as in the
    tool; where one alone is given, the other is not bounded.
    """

    max_rotation_error: float
    max_translation_error: float


class FrontendKeywords(TypedDict, total=False):
    """Fields of ``gmcr.FrontendOptions``."""

    voxel_size: float
    source_voxel_size: float
    normal_radius: float
    feature_radius: float
    noise_bound_voxels: float
    orientation: OrientationWord
    source_viewpoint: npt.ArrayLike
    target_viewpoint: npt.ArrayLike
    mutual: bool
    max_ratio: float
    max_attempts: int
    refine: RefineWord


class LimitKeywords(TypedDict, total=False):
    """Fields of ``gmcr.InstanceOptions``."""

    max_instances: int
    min_instance_inliers: int
    min_instance_share: float


class CloudKeywords(SolverKeywords, FrontendKeywords, total=False):
    """Fields of ``gmcr.Options`` and ``gmcr.FrontendOptions``."""


class InstanceKeywords(SolverKeywords, LimitKeywords, total=False):
    """Fields of ``gmcr.Options`` and ``gmcr.InstanceOptions``."""


class CloudInstanceKeywords(CloudKeywords, LimitKeywords, total=False):
    """Fields of ``gmcr.Options``, ``gmcr.FrontendOptions`` and ``gmcr.InstanceOptions``."""


class CliqueKeywords(TypedDict, total=False):
    """Fields of ``gmcr.CliqueOptions``."""

    time_limit: float
    max_nodes: int
    max_work: int
    initial_clique: npt.ArrayLike | None
    must_exceed: int
    num_threads: int
    max_memory: int


class WeightedCliqueKeywords(TypedDict, total=False):
    """Fields of ``gmcr.WeightedCliqueOptions``."""

    time_limit: float
    max_nodes: int
    max_work: int
    max_memory: int
    must_exceed: float
    num_threads: int


class SyntheticKeywords(TypedDict, total=False):
    """Fields of ``gmcr.SyntheticOptions`` but ``kind``, which chooses their defaults."""

    num_correspondences: int
    outlier_rate: float
    seed: int
    noise_shape: NoiseShapeWord
    noise_extent: float
    noise_bound: float
    scale_range: Sequence[float]
    max_translation: float
    num_cloud_points: int
    num_sphere_points: int
    num_bases: int
    source_neighbours: int
    target_neighbours: int
    association_neighbours: int

"""Robust registration of 3-D point sets: graph-based maximum consensus, with a certificate.

>>> import gmcr
>>> result = gmcr.register_correspondences(source, target, noise_bound=0.02)  # (N, 3) each
>>> result.matrix(), result.inliers, result.certificate.upper
"""

from typing import TYPE_CHECKING

from ._arguments import CloudLike, PointsLike, PoseLike
from ._cliques import max_clique, max_weight_clique
from ._clouds import (
    fpfh,
    match,
    refine_clouds,
    register_cloud_instances,
    register_clouds,
    voxel_grid,
    with_pose,
)
from ._descriptors import match_descriptors
from ._enums import (
    Evidence,
    Method,
    NoiseMode,
    NoiseShape,
    NormalOrientation,
    Refine,
    ScaleMode,
    Status,
    SyntheticKind,
    Verdict,
)
from ._gmcr import (
    Alternative,
    Certificate,
    CliqueOptions,
    CliqueResult,
    CloudMatches,
    CloudResult,
    Consensus,
    Covariance,
    DescriptorMatches,
    Diagnostics,
    EvidenceCertificate,
    FrontendOptions,
    GravityPrior,
    InitialPose,
    InstanceOptions,
    JudgedVoxels,
    NoiseEstimate,
    Options,
    PreparedCloud,
    PreparedMap,
    Refinement,
    Result,
    RivalPose,
    Similarity,
    SurfaceFit,
    SyntheticOptions,
    SyntheticProblem,
    Uncertainty,
    WeakDirection,
    WeightedCliqueOptions,
    WeightedCliqueResult,
    hardware_threads,
    instruction_set,
    instruction_sets,
    version,
)
from ._maps import localise_scan, prepare_map
from ._metrics import PoseErrors, evaluate
from ._names import answer_for_results, no_name_of_package
from ._prepared import prepare
from ._registration import (
    consistency_graph,
    evaluate_consensus,
    evaluate_uncertainty,
    register_correspondences,
    register_instances,
)
from ._synthetic import make_synthetic

if TYPE_CHECKING:
    from . import batch as batch
    from . import io as io
    from . import multiview as multiview
    from . import viz as viz
else:  # of a function, type checkers would conclude that every name is there
    _LAZY = ("batch", "io", "multiview", "viz")

    def __getattr__(name):
        """Submodules, imported when they are first used."""
        if name not in _LAZY:
            raise no_name_of_package(name, (*__all__, *_LAZY))
        from importlib import import_module

        return import_module(f".{name}", __name__)

    def __dir__():
        return sorted({*globals(), *_LAZY})


answer_for_results()
__version__ = version()

__all__ = [
    "Alternative",
    "Certificate",
    "CliqueOptions",
    "CliqueResult",
    "CloudLike",
    "CloudMatches",
    "CloudResult",
    "Consensus",
    "Covariance",
    "DescriptorMatches",
    "Diagnostics",
    "Evidence",
    "EvidenceCertificate",
    "FrontendOptions",
    "GravityPrior",
    "InitialPose",
    "InstanceOptions",
    "JudgedVoxels",
    "Method",
    "NoiseEstimate",
    "NoiseMode",
    "NoiseShape",
    "NormalOrientation",
    "Options",
    "PointsLike",
    "PoseErrors",
    "PoseLike",
    "PreparedCloud",
    "PreparedMap",
    "Refine",
    "Refinement",
    "Result",
    "RivalPose",
    "ScaleMode",
    "Similarity",
    "Status",
    "SurfaceFit",
    "SyntheticKind",
    "SyntheticOptions",
    "SyntheticProblem",
    "Uncertainty",
    "Verdict",
    "WeakDirection",
    "WeightedCliqueOptions",
    "WeightedCliqueResult",
    "__version__",
    "consistency_graph",
    "evaluate",
    "evaluate_consensus",
    "evaluate_uncertainty",
    "fpfh",
    "hardware_threads",
    "instruction_set",
    "instruction_sets",
    "localise_scan",
    "make_synthetic",
    "match",
    "match_descriptors",
    "max_clique",
    "max_weight_clique",
    "prepare",
    "prepare_map",
    "refine_clouds",
    "register_cloud_instances",
    "register_clouds",
    "register_correspondences",
    "register_instances",
    "voxel_grid",
    "with_pose",
]

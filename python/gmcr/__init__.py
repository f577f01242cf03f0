"""Robust registration of 3-D point sets: graph-based maximum consensus, with a certificate.

>>> import gmcr
>>> result = gmcr.register_correspondences(source, target, noise_bound=0.02)  # (N, 3) each
>>> result.matrix(), result.inliers, result.certificate.upper
"""

from ._arguments import PoseLike
from ._cliques import max_clique, max_weight_clique
from ._clouds import fpfh, match, register_clouds, voxel_grid, with_pose
from ._enums import (
    Evidence,
    Method,
    NoiseMode,
    NoiseShape,
    NormalOrientation,
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
    Diagnostics,
    EvidenceCertificate,
    FrontendOptions,
    GravityPrior,
    InitialPose,
    InstanceOptions,
    NoiseEstimate,
    Options,
    Result,
    Similarity,
    SyntheticOptions,
    SyntheticProblem,
    Uncertainty,
    WeightedCliqueOptions,
    WeightedCliqueResult,
    hardware_threads,
    instruction_set,
    instruction_sets,
    version,
)
from ._metrics import PoseErrors, evaluate
from ._registration import (
    consistency_graph,
    evaluate_consensus,
    evaluate_uncertainty,
    register_correspondences,
    register_instances,
)
from ._synthetic import make_synthetic

__version__ = version()

__all__ = [
    "Alternative",
    "Certificate",
    "CliqueOptions",
    "CliqueResult",
    "CloudMatches",
    "CloudResult",
    "Consensus",
    "Covariance",
    "Diagnostics",
    "Evidence",
    "EvidenceCertificate",
    "FrontendOptions",
    "GravityPrior",
    "InitialPose",
    "InstanceOptions",
    "Method",
    "NoiseEstimate",
    "NoiseMode",
    "NoiseShape",
    "NormalOrientation",
    "Options",
    "PoseErrors",
    "PoseLike",
    "Result",
    "ScaleMode",
    "Similarity",
    "Status",
    "SyntheticKind",
    "SyntheticOptions",
    "SyntheticProblem",
    "Uncertainty",
    "Verdict",
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
    "make_synthetic",
    "match",
    "max_clique",
    "max_weight_clique",
    "register_clouds",
    "register_correspondences",
    "register_instances",
    "voxel_grid",
    "with_pose",
]

"""Exact maximum consensus, in the role of the paper's MAXCON: this library's certified search."""

from typing import ClassVar

from paper.methods.gmcr_solver import GmcrSolver
from paper.methods.registry import Look, register


@register
class GmcrExact(GmcrSolver):
    name = "gmcr-exact"
    look = Look("gmcr-exact", 22, "#f0b800", "*", (0, (1, 1)))
    is_everywhere = False
    settings = (
        '`evidence="count", certify=True`, at most 2 s a solve; exact where it is certified; '
        "takes the role of the paper's MAXCON"
    )
    options: ClassVar = {"evidence": "count", "certify": True}
    max_time_limit = 2.0

"""What came of many scans."""

from __future__ import annotations

from dataclasses import dataclass
from html import escape

from ._edge import Edge
from ._motion import Matrix


@dataclass(frozen=True, eq=False)
class Component:
    """Scans that edges connect.

    Attributes
    ----------
    scans : tuple of int
        Indices, ascending.
    poses : dict of int to ndarray, shape (4, 4)
        Pose of each, from its own frame to that of the first of them.
    """

    scans: tuple[int, ...]
    poses: dict[int, Matrix]


@dataclass(frozen=True, eq=False)
class JudgedEdge:
    """An edge and what became of it.

    Attributes
    ----------
    edge : Edge
        As it was measured.
    is_accepted : bool
        Whether the pose graph uses it.
    is_confirmed : bool
        Whether it is accepted and other accepted edges lead from its source to its target as well.
    disagreement : float or None
        RMS distance, metres, between the source's points moved by the edge and by the final poses;
        None where these do not connect its scans.
    reason : str
        Why it was not accepted, or what confirms it.
    """

    edge: Edge
    is_accepted: bool
    is_confirmed: bool
    disagreement: float | None
    reason: str


@dataclass(frozen=True, eq=False)
class MultiviewResult:
    """Poses of many scans.

    Attributes
    ----------
    poses : tuple of ndarray, shape (4, 4), or None
        One a scan, from its own frame to that of scan 0; None where nothing connects it to scan 0.
    components : tuple of Component
        Groups of connected scans, by their first scan; the first one holds scan 0.
    edges : tuple of JudgedEdge
        All that was measured, in the order given.
    """

    poses: tuple[Matrix | None, ...]
    components: tuple[Component, ...]
    edges: tuple[JudgedEdge, ...]

    def summary(self) -> str:
        """The edges and the components, a line each."""
        lines = [
            f"{judged.edge.source:3d} -> {judged.edge.target:<3d} {judged.edge.verdict!s:9s} "
            f"{'accepted' if judged.is_accepted else 'rejected'}: {judged.reason}"
            for judged in self.edges
        ]
        for component in self.components:
            names = ", ".join(map(str, component.scans))
            lines.append(f"connected, in the frame of scan {component.scans[0]}: {names}")
        return "\n".join(lines)

    def __str__(self) -> str:
        return self.summary()

    def _repr_html_(self) -> str:
        """A table for notebooks: a row an edge, then the groups."""
        rows = "".join(
            f"<tr><td>{judged.edge.source} \u2192 {judged.edge.target}</td>"
            f"<td>{judged.edge.verdict!s}</td>"
            f"<td>{'accepted' if judged.is_accepted else 'rejected'}</td>"
            f'<td style="text-align: left">{escape(judged.reason)}</td></tr>'
            for judged in self.edges
        )
        groups = "".join(
            f"<li>{', '.join(map(str, component.scans))}</li>" for component in self.components
        )
        head = "<tr><th>scans</th><th>verdict</th><th>edge</th><th>reason</th></tr>"
        return f"<table>{head}{rows}</table>In one frame: <ul>{groups}</ul>"

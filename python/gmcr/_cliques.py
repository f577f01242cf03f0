"""Maximum cliques of graphs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np
import numpy.typing as npt

from . import _gmcr
from ._arguments import check_options
from ._gmcr import CliqueOptions, CliqueResult, WeightedCliqueOptions, WeightedCliqueResult
from ._hints import of_the_function

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from ._keywords import CliqueKeywords, WeightedCliqueKeywords


def _graph_of(graph: Any, num_vertices: int | None) -> _gmcr.Graph:
    if num_vertices is not None:
        edges = np.asarray(graph)
        if edges.size == 0:
            edges = np.empty((0, 2), dtype=np.int64)
        if edges.dtype.kind not in "iu" or edges.ndim != 2 or edges.shape[1] != 2:
            raise ValueError(
                f"graph: expected edges of shape (m, 2) and integer type, but these are "
                f"{edges.shape} of {edges.dtype}"
            )
        return _gmcr.Graph.from_edges(np.ascontiguousarray(edges, dtype=np.int64), num_vertices)
    if hasattr(graph, "tocoo"):
        return _graph_of_sparse(graph.tocoo())
    matrix = np.asarray(graph)
    if matrix.dtype != np.bool_ or matrix.ndim != 2 or matrix.shape[0] != matrix.shape[1]:
        raise ValueError(
            f"graph: expected a bool matrix of shape (n, n), a sparse matrix, or edges with "
            f"num_vertices, but this is {matrix.shape} of {matrix.dtype}"
        )
    return _gmcr.Graph.from_matrix(np.ascontiguousarray(matrix))


def _graph_of_sparse(matrix: Any) -> _gmcr.Graph:
    if matrix.shape[0] != matrix.shape[1]:
        raise ValueError(f"graph: expected shape (n, n), but it is {matrix.shape}")
    if (matrix != matrix.T).nnz:
        raise ValueError("graph: not symmetric")
    is_edge = (matrix.data != 0) & (matrix.row < matrix.col)
    edges = np.column_stack([matrix.row[is_edge], matrix.col[is_edge]])
    return _gmcr.Graph.from_edges(np.ascontiguousarray(edges, dtype=np.int64), matrix.shape[0])


def max_clique(
    graph: Any,
    num_vertices: int | None = None,
    options: CliqueOptions | None = None,
    **keywords: Unpack[CliqueKeywords],
) -> CliqueResult:
    """Maximum clique of a graph, exact unless a limit binds.

    Parameters
    ----------
    graph : array_like of bool, shape (n, n), scipy sparse matrix, or array_like of int, (m, 2)
        Adjacency matrix, symmetric, whose diagonal is ignored; or edges, with ``num_vertices``.
    num_vertices : int, optional
        Vertices of the graph, where it is given by edges.
    options : CliqueOptions, optional
        Limits.
    **keywords
        Fields of ``CliqueOptions``, instead of ``options``.

    Returns
    -------
    CliqueResult
        Vertices, ascending, and the proven upper bound.

    Raises
    ------
    ValueError
        where the graph has a loop or is not symmetric, or an option is out of range.

    Notes
    -----
    The same vertices for any number of threads. Exponential in the worst case: give a
    ``time_limit`` for unknown graphs. Other Python threads run meanwhile, and Ctrl-C stops it.

    Examples
    --------
    >>> gmcr.max_clique([[0, 1], [1, 2], [0, 2], [2, 3]], 4).vertices.tolist()
    [0, 1, 2]
    """
    check_options(CliqueOptions, options, keywords)  # type: ignore[arg-type]
    try:
        limits = CliqueOptions(**keywords) if options is None else options
    except TypeError as error:
        raise of_the_function(error, CliqueOptions) from None
    return _gmcr.max_clique(_graph_of(graph, num_vertices), limits)


def max_weight_clique(
    graph: Any,
    weights: npt.ArrayLike,
    num_vertices: int | None = None,
    options: WeightedCliqueOptions | None = None,
    **keywords: Unpack[WeightedCliqueKeywords],
) -> WeightedCliqueResult:
    """Clique of maximum weight, exact unless a limit binds.

    Parameters
    ----------
    graph, num_vertices
        As for ``max_clique``.
    weights : array_like, shape (n,)
        One a vertex, >= 0, finite. Vertices that weigh 0 are never part of the result.
    options : WeightedCliqueOptions, optional
        Limits.
    **keywords
        Fields of ``WeightedCliqueOptions``, instead of ``options``.

    Returns
    -------
    WeightedCliqueResult
        Vertices, ascending, their weight and the proven upper bound.
    """
    check_options(WeightedCliqueOptions, options, keywords)  # type: ignore[arg-type]
    try:
        limits = WeightedCliqueOptions(**keywords) if options is None else options
    except TypeError as error:
        raise of_the_function(error, WeightedCliqueOptions) from None
    return _gmcr.max_weight_clique(_graph_of(graph, num_vertices), weights, limits)

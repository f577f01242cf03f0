"""Maximum cliques of graphs in each form they may be given."""

from __future__ import annotations

import itertools
import pickle

import gmcr
import numpy as np
import pytest
import scipy.sparse
from hypothesis import given
from hypothesis import strategies as st

#: Two triangles, one of them with a fourth vertex on all of its corners.
EDGES = [[0, 1], [1, 2], [0, 2], [3, 4], [3, 5], [3, 6], [4, 5], [4, 6], [5, 6], [2, 3]]


def matrix_of(edges, n) -> np.ndarray:
    matrix = np.zeros((n, n), dtype=bool)
    for u, v in edges:
        matrix[u, v] = matrix[v, u] = True
    return matrix


def random_graph(n, density, seed) -> np.ndarray:
    upper = np.triu(np.random.default_rng(seed).random((n, n)) < density, 1)
    return upper | upper.T


@pytest.mark.parametrize(
    "graph",
    [
        (EDGES, 7),
        (np.array(EDGES, dtype=np.uint8), 7),
        (matrix_of(EDGES, 7),),
        (np.asfortranarray(matrix_of(EDGES, 7)),),
        (scipy.sparse.csr_matrix(matrix_of(EDGES, 7)),),
        (scipy.sparse.coo_array(matrix_of(EDGES, 7).astype(float)),),
    ],
    ids=["list", "uint8", "dense", "fortran", "csr", "coo"],
)
def test_each_form_of_a_graph_gives_its_clique(graph):
    result = gmcr.max_clique(*graph)
    assert result.vertices.tolist() == [3, 4, 5, 6]
    assert result.upper_bound == 4
    assert result.proven_optimal
    assert repr(result).startswith("CliqueResult(4 vertices")
    assert repr(pickle.loads(pickle.dumps(result))) == repr(result)


def test_the_diagonal_is_ignored():
    assert len(gmcr.max_clique(np.eye(4, dtype=bool)).vertices) == 1


@pytest.mark.parametrize(("edges", "n", "size"), [([], 0, 0), ([], 3, 1), ([[0, 1]], 2, 2)])
def test_small_graphs_have_small_cliques(edges, n, size):
    assert len(gmcr.max_clique(edges, n).vertices) == size


@given(st.integers(1, 12), st.integers(0, 2**20))
def test_the_clique_is_as_large_as_brute_force_says(n, seed):
    graph = random_graph(n, 0.5, seed)
    largest = max(
        size
        for size in range(1, n + 1)
        for vertices in itertools.combinations(range(n), size)
        if all(graph[u, v] for u, v in itertools.combinations(vertices, 2))
    )
    result = gmcr.max_clique(graph)
    assert len(result.vertices) == largest
    assert all(graph[u, v] for u, v in itertools.combinations(result.vertices, 2))


@pytest.mark.parametrize(
    "graph",
    [
        (np.ones((3, 4), dtype=bool),),
        (np.triu(np.ones((3, 3), dtype=bool)),),
        (np.ones((3, 3)),),
        (scipy.sparse.csr_matrix(np.triu(np.ones((3, 3)))),),
        (scipy.sparse.csr_matrix(np.ones((3, 4))),),
        ([[0, 0]], 3),
        ([[0, 3]], 3),
        ([[0.5, 1]], 3),
        ([[0, 1, 2]], 3),
    ],
)
def test_what_is_no_graph_is_a_value_error(graph):
    with pytest.raises(ValueError):
        gmcr.max_clique(*graph)


def test_max_nodes_ends_the_search():
    graph = random_graph(120, 0.8, 1)
    assert gmcr.max_clique(graph, max_nodes=5).nodes <= 5 < gmcr.max_clique(graph).nodes
    assert not gmcr.max_clique(graph, max_nodes=5).proven_optimal


def test_time_limit_ends_the_search():
    result = gmcr.max_clique(random_graph(300, 0.9, 1), time_limit=0.05)
    assert not result.proven_optimal
    assert result.upper_bound > len(result.vertices)


def test_must_exceed_asks_for_a_larger_clique():
    result = gmcr.max_clique(EDGES, 7, must_exceed=6)
    assert result.upper_bound <= 6
    assert result.proven_optimal


def test_initial_clique_must_be_one():
    assert len(gmcr.max_clique(EDGES, 7, initial_clique=[0, 1, 2]).vertices) == 4
    assert gmcr.max_clique(EDGES, 7, max_nodes=0, initial_clique=[3, 4, 5, 6]).upper_bound >= 4
    with pytest.raises(ValueError, match="initial_clique"):
        gmcr.max_clique(EDGES, 7, initial_clique=[0, 5])


def test_num_threads_and_max_memory_do_not_change_the_clique():
    graph = random_graph(150, 0.7, 2)
    expected = gmcr.max_clique(graph, num_threads=1)
    for keywords in ({"num_threads": 2}, {"max_memory": 1}):
        result = gmcr.max_clique(graph, **keywords)
        assert len(result.vertices) == len(expected.vertices)
    with pytest.raises(ValueError, match="num_threads"):
        gmcr.max_clique(graph, num_threads=-1)


VALUES = {
    gmcr.CliqueOptions: {
        "time_limit": 3.0,
        "max_nodes": 7,
        "max_work": 9,
        "initial_clique": [1, 2],
        "must_exceed": 4,
        "num_threads": 2,
        "max_memory": 5,
    },
    gmcr.WeightedCliqueOptions: {
        "time_limit": 3.0,
        "max_nodes": 7,
        "max_work": 9,
        "must_exceed": 4.5,
        "num_threads": 2,
        "max_memory": 5,
    },
}


@pytest.mark.parametrize("kind", VALUES)
def test_options_keep_their_values(kind):
    assert set(VALUES[kind]) == set(kind().__getstate__())
    options = pickle.loads(pickle.dumps(kind(**VALUES[kind])))
    for name, value in VALUES[kind].items():
        assert np.array_equal(getattr(options, name), value)
    options.validate()


def test_weights_decide_between_cliques():
    weights = [9.0, 9, 9, 1, 1, 1, 1]
    result = gmcr.max_weight_clique(EDGES, weights, 7)
    assert result.vertices.tolist() == [0, 1, 2]
    assert result.weight == 27 == result.upper_bound
    assert result.proven_optimal
    assert result.nodes >= 0
    assert repr(pickle.loads(pickle.dumps(result))) == repr(result)
    with pytest.raises(ValueError, match="weights"):
        gmcr.max_weight_clique(EDGES, [1.0], 7)


def test_limits_end_the_weighted_search():
    graph = random_graph(150, 0.8, 3)
    weights = np.random.default_rng(3).random(150)
    for limit in ({"max_nodes": 3}, {"max_work": 1000}, {"time_limit": 0.0}, {"max_memory": 1}):
        result = gmcr.max_weight_clique(graph, weights, **limit)
        assert not result.proven_optimal
        assert result.upper_bound > result.weight
    assert gmcr.max_weight_clique(EDGES, np.ones(7), 7, must_exceed=5).upper_bound <= 5

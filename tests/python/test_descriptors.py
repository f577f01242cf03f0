"""Matches of descriptors of one's own."""

from __future__ import annotations

import pickle

import gmcr
import numpy as np
import pytest


def oracle(distances, k, mutual, ratio):
    """Matches by a table of all distances."""
    there = np.argsort(distances, axis=1, kind="stable")
    back = np.argsort(distances, axis=0, kind="stable")[:k]
    matches = []
    for i in range(len(distances)):
        for j in there[i, :k]:
            limit = ratio * distances[i, there[i, k]] if there.shape[1] > k else np.inf
            if distances[i, j] <= limit and (not mutual or i in back[:, j]):
                matches.append((i, j))
    return np.array(matches).reshape(-1, 2)


def indices(matches):
    return np.column_stack([matches.source_indices, matches.target_indices])


@pytest.mark.parametrize("k", [1, 3])
@pytest.mark.parametrize("mutual", [True, False])
@pytest.mark.parametrize("ratio", [0.8, 1.0])
def test_floats_match_by_euclidean_distance(k, mutual, ratio):
    rng = np.random.default_rng(1)
    source, target = rng.integers(-3, 4, (40, 7)), rng.integers(-3, 4, (60, 7))
    distances = np.linalg.norm(source[:, None] - target[None], axis=2)
    matches = gmcr.match_descriptors(source, target, k, mutual, ratio)
    assert np.array_equal(indices(matches), oracle(distances, k, mutual, ratio))
    expected = distances[matches.source_indices, matches.target_indices]
    np.testing.assert_allclose(matches.distances, expected, rtol=1e-6)
    swapped = gmcr.match_descriptors(
        source[:, ::-1].astype(np.float64), np.asfortranarray(target[:, ::-1]), k, mutual, ratio
    )
    assert np.array_equal(indices(swapped), indices(matches))


@pytest.mark.parametrize("num_bits", [8, 21])
def test_bits_match_by_hamming_distance(num_bits):
    rng = np.random.default_rng(2)
    source, target = rng.random((40, num_bits)) < 0.5, rng.random((60, num_bits)) < 0.5
    distances = (source[:, None] != target[None]).sum(axis=2)
    matches = gmcr.match_descriptors(source, target, 2, ratio=0.9)
    assert np.array_equal(indices(matches), oracle(distances, 2, True, 0.9))
    expected = distances[matches.source_indices, matches.target_indices]
    assert np.array_equal(matches.distances, expected)
    packed = gmcr.match_descriptors(
        np.packbits(source, axis=1), np.packbits(target, axis=1), 2, ratio=0.9, num_threads=1
    )
    assert np.array_equal(indices(packed), indices(matches))


def test_matches_lead_to_a_pose():
    problem = gmcr.make_synthetic(num_correspondences=300, outlier_rate=0.5, seed=3)
    rng = np.random.default_rng(3)
    features = rng.normal(size=(300, 24)).astype(np.float32)
    order = rng.permutation(300)
    matches = gmcr.match_descriptors(
        features, features[order] + 0.1 * rng.normal(size=(300, 24)), ratio=0.9
    )
    assert len(matches.distances) > 250
    assert np.array_equal(order[matches.target_indices], matches.source_indices)
    result = gmcr.register_correspondences(
        problem.source[matches.source_indices],
        problem.target[order][matches.target_indices],
        noise_bound=problem.noise_bound,
    )
    errors = gmcr.evaluate(result, problem.target_from_source, problem.source)
    assert errors.rotation_error_deg < 2


def test_matches_can_be_pickled():
    matches = gmcr.match_descriptors(np.eye(4), np.eye(4))
    again = pickle.loads(pickle.dumps(matches))
    assert np.array_equal(indices(again), indices(matches))
    assert again.distances.tolist() == [0, 0, 0, 0]


def test_mistakes_are_named():
    good = np.zeros((3, 4), np.float32)
    for bad, message in [
        (np.zeros(4), r"target: expected shape \(N, D\)"),
        (np.zeros((3, 5)), "4 and 5 values"),
        (np.full((3, 4), np.nan), "target: descriptor 0 is not finite"),
        (np.full((3, 4), 1e300), "target: descriptor 0 is not finite"),
        (np.zeros((3, 4), np.uint8), "one of numbers, the other of bits"),
        (np.full((3, 4), "a"), "expected numbers or bits"),
    ]:
        with pytest.raises(ValueError, match=message):
            gmcr.match_descriptors(good, bad)
    for options, message in [
        ({"k": 0}, "k: 0 is below 1"),
        ({"ratio": 1.5}, "ratio: 1.5"),
        ({"num_threads": -1}, "num_threads: -1"),
    ]:
        with pytest.raises(ValueError, match=message):
            gmcr.match_descriptors(good, good, **options)

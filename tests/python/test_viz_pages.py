"""The report and the viewer in headless Chromium."""

from __future__ import annotations

import io
import json
import shutil
import socket
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import gmcr
import numpy as np
import pytest

pytest.importorskip("plotly", reason="the extra viz is not installed")
pytest.importorskip("viser", reason="the extra viz is not installed")
sync_api = pytest.importorskip("playwright.sync_api", reason="playwright is not installed")
image = pytest.importorskip("PIL.Image", reason="pillow is not installed")

from gmcr.viz import DrawLimits, plot, report, show, words  # noqa: E402
from gmcr.viz.colours import SOURCE, TARGET, rgb  # noqa: E402
from gmcr.viz.figures import distances_figure  # noqa: E402
from gmcr.viz.outcome import outcome_of_json  # noqa: E402
from gmcr.viz.prepare import scene_of_result  # noqa: E402

CHROMIUM = shutil.which("chromium")
LIMITS = DrawLimits(points=1500, outliers=20)

Cloud = np.ndarray
Clouds = tuple[Cloud, Cloud, gmcr.Similarity]


class Visit:
    """A page, what it complained of, and what it asked of the network."""

    def __init__(self, page: Any) -> None:
        self.page = page
        self.errors: list[str] = []
        self.requests: list[str] = []
        page.on("console", self._note)
        page.on("pageerror", lambda error: self.errors.append(str(error)))
        page.on("request", lambda request: self.requests.append(request.url))

    def _note(self, message: Any) -> None:
        if message.type == "error":
            self.errors.append(message.text)

    def pixels_like(self, selector: str, colour: str) -> np.ndarray:
        """Which pixels of an element have nearly this colour, (height, width) bool."""
        picture = image.open(io.BytesIO(self.page.locator(selector).first.screenshot()))
        pixels = np.asarray(picture.convert("RGB"), dtype=int)
        return np.abs(pixels - rgb(colour)).max(axis=2) < 20

    def wait_for_pixels(
        self, selector: str, colour: str, is_right: Callable[[np.ndarray], bool]
    ) -> np.ndarray:
        """``pixels_like``, as soon as the page has drawn what is right."""
        end = time.monotonic() + 30
        while not is_right(pixels := self.pixels_like(selector, colour)):
            assert time.monotonic() < end, f"{pixels.sum()} pixels"
            self.page.wait_for_timeout(100)
        return pixels


@pytest.fixture(scope="module")
def browser() -> Iterator[Any]:
    if CHROMIUM is None:
        pytest.skip("chromium is not installed")
    with sync_api.sync_playwright() as playwright:
        arguments = ["--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader"]
        browser = playwright.chromium.launch(executable_path=CHROMIUM, args=arguments)
        yield browser
        browser.close()


def new_visit(browser: Any) -> Visit:
    page = browser.new_page(viewport={"width": 1000, "height": 700})
    page.set_default_timeout(180_000)  # drawing without a graphics card, on a busy machine
    return Visit(page)


def open_offline(visit: Visit, path: Path) -> None:
    visit.page.context.set_offline(True)
    visit.page.goto(path.as_uri())
    visit.page.wait_for_selector("#clouds canvas")
    visit.page.wait_for_function("document.getElementById('clouds')._fullData !== undefined")


@pytest.fixture
def visit(browser: Any) -> Iterator[Visit]:
    visit = new_visit(browser)
    yield visit
    visit.page.close()


@pytest.fixture(scope="module")
def result(clouds: Clouds) -> gmcr.CloudResult:
    return gmcr.register_clouds(clouds[0], clouds[1])


@pytest.fixture(scope="module")
def opened(
    browser: Any,
    clouds: Clouds,
    result: gmcr.CloudResult,
    tmp_path_factory: pytest.TempPathFactory,
) -> Visit:
    """The report of two clouds, opened without a network."""
    path = tmp_path_factory.mktemp("report") / "report.html"
    visit = new_visit(browser)
    open_offline(visit, report(result, *clouds[:2], path, title="<A> & B", limits=LIMITS))
    return visit


def test_report_opens_without_a_network_and_says_what_the_result_says(
    opened: Visit, result: gmcr.CloudResult
) -> None:
    page, registration = opened.page, result.registration
    assert page.title() == "gmcr: <A> & B"
    assert page.inner_text("#verdict") == result.verdict
    assert page.inner_text("#reason") == f"{result.verdict_reason.capitalize()}."
    num_matches = len(result.matches.source)
    num_inliers = len(registration.inliers)
    assert page.inner_text("#num_inliers") == f"{num_inliers:,} of {num_matches:,}"
    matrix = np.array([line.split() for line in page.inner_text("#matrix").splitlines()])
    assert matrix.astype(float) == pytest.approx(result.matrix(), abs=1e-8)
    body = page.inner_text("body")
    assert "showing 1,500 of 3,000 points" in body
    assert registration.certificate.certified or (
        f"pose can have more than {registration.certificate.upper}:" in body
    )
    assert f"gmcr {gmcr.__version__}" in body
    for stage in registration.diagnostics.stages:
        assert page.locator("#stages").get_by_text(stage, exact=True).count() == 1
    counts = page.evaluate(
        "document.getElementById('residuals')._fullData.map("
        "trace => Array.from(trace.y).reduce((sum, count) => sum + count, 0))"
    )
    assert counts == [num_inliers, num_matches - num_inliers]
    assert page.locator("#graph .hm image").count() == 1
    for colour in (SOURCE, TARGET):
        opened.wait_for_pixels("#clouds", colour, lambda pixels: pixels.sum() > 150)
    assert opened.errors == []
    assert [url for url in opened.requests if not url.startswith(("file:", "data:"))] == []


def test_slider_of_the_report_moves_the_source_to_where_it_was_given_and_back(
    opened: Visit, clouds: Clouds, result: gmcr.CloudResult
) -> None:
    page, drawn = opened.page, "document.getElementById('clouds')._fullData[0]"

    def source_after_click_on(label: str) -> np.ndarray:
        text = page.get_by_text(label, exact=True)
        text.scroll_into_view_if_needed()
        box = text.bounding_box()
        before = page.evaluate(f"{drawn}.x[0]")
        page.mouse.click(box["x"] + box["width"] / 2, box["y"])
        page.wait_for_function(f"{drawn}.x[0] !== {before}")
        return np.transpose(page.evaluate(f"['x', 'y', 'z'].map(i => Array.from({drawn}[i]))"))

    _, scene = scene_of_result(result, *clouds[:2], gmcr.Options(), LIMITS)
    given = clouds[0][scene.source_points.indices]
    pose = result.registration
    arrived = given @ (pose.scale * pose.rotation).T + pose.translation
    assert source_after_click_on("before") == pytest.approx(given, abs=1e-5)
    assert source_after_click_on("after") == pytest.approx(arrived, abs=1e-5)
    assert opened.errors == []


def test_report_of_data_without_an_answer_opens_and_says_so(visit: Visit, tmp_path: Path) -> None:
    points = np.eye(3)[:2]
    result = gmcr.register_correspondences(points, points, noise_bound=0.1)
    path = report(result, points, points, tmp_path / "none.html", noise_bound=0.1)
    open_offline(visit, path)
    assert visit.page.inner_text("#verdict") == "too few correspondences"
    assert "No pose was found" in visit.page.inner_text("body")
    assert visit.errors == []


def test_report_fits_a_phone_and_says_what_was_in_use(
    browser: Any, clouds: Clouds, tmp_path: Path
) -> None:
    options = gmcr.Options(num_hypotheses=2, time_limit=50)
    result = gmcr.register_clouds(clouds[0], clouds[1], options=options)
    visit = new_visit(browser)
    visit.page.set_viewport_size({"width": 390, "height": 800})
    open_offline(visit, report(result, *clouds[:2], tmp_path / "r.html", options, limits=LIMITS))
    page = visit.page
    assert page.evaluate("document.documentElement.scrollWidth") <= 390
    used = page.locator("section", has=page.get_by_role("heading", name="In use")).inner_text()
    size = f"{result.matches.target_voxel_size:.4g} m"
    for shown in (size, "known: 1", "50", "num_hypotheses"):
        assert shown in used
    for default in ("one_to_one", "memory_limit"):
        assert default not in used, "a default is no choice"
    page.get_by_text("options at their defaults").click()
    assert page.get_by_text("one_to_one", exact=True).is_visible()
    matrix = page.locator("#matrix")
    assert matrix.evaluate("matrix => matrix.scrollWidth <= matrix.clientWidth"), "four columns"
    num_poses = 1 + len(result.registration.alternatives) + len(result.rivals)
    assert page.locator("#poses figure").count() == (num_poses if num_poses > 1 else 0)
    assert visit.errors == []
    page.close()


def corridor(rng: np.random.Generator) -> Cloud:
    """A floor and two walls, 12 m long and alike all along, 1 cm of noise."""
    face, across = rng.integers(0, 3, 8000), rng.uniform(0, 1, 8000)
    y = np.select([face == 0, face == 1], [3 * across - 1.5, -1.5], 1.5)
    points = np.column_stack([rng.uniform(-6, 6, 8000), y, np.where(face, 2.5 * across, 0)])
    return points + rng.normal(0, 0.01, points.shape)


@pytest.mark.parametrize("width", [390, 1000])
def test_boxes_of_long_clouds_are_seen_whole(browser: Any, tmp_path: Path, width: int) -> None:
    cloud = corridor(np.random.default_rng(0))
    visit = new_visit(browser)
    visit.page.set_viewport_size({"width": width, "height": 800})
    result = gmcr.register_clouds(cloud, cloud, num_hypotheses=2)
    open_offline(visit, report(result, cloud, cloud, tmp_path / "r.html", limits=LIMITS))
    for name, colour in (("clouds", TARGET), ("distances", "#440154")):
        assert visit.page.locator(f"#{name}").get_attribute("data-seen")
        pixels = visit.wait_for_pixels(f"#{name}", colour, lambda pixels: pixels.sum() > 100)
        rows, columns = pixels.any(axis=1), pixels.any(axis=0)
        assert not rows[[0, -1]].any() and not columns[[0, -1]].any(), name
        assert np.ptp(np.flatnonzero(columns)) > 0.4 * pixels.shape[1], "and not from afar"
    assert visit.errors == []
    visit.page.close()


def test_distances_after_alignment_are_those_of_the_nearest_points(
    clouds: Clouds, result: gmcr.CloudResult
) -> None:
    outcome, scene = scene_of_result(result, *clouds[:2], None, LIMITS)
    pose = result.registration
    source = clouds[0][scene.source_points.indices][scene.measured.indices]
    moved = source @ (pose.scale * pose.rotation).T + pose.translation
    nearest = [np.linalg.norm(clouds[1] - point, axis=1).min() for point in moved[:50]]
    assert scene.distances is not None
    assert scene.distances[:50] == pytest.approx(nearest, abs=1e-9)
    assert f"{len(scene.distances):,} points" in words.distances(scene)
    figure = distances_figure(scene)
    assert figure is not None and len(figure.data[0].x) == len(scene.distances)
    assert words.weak_rows(outcome) == [("determined", "all motions: the surfaces leave none open")]


def test_what_the_surfaces_leave_open_is_drawn(
    visit: Visit, clouds: Clouds, tmp_path: Path
) -> None:
    rng, motion = np.random.default_rng(0), clouds[2]
    source = corridor(rng)
    target = corridor(rng) @ motion.rotation.T + motion.translation
    result = gmcr.register_clouds(source, target)
    weak = json.loads(result.to_json())["surfaces"]["weak_directions"]
    assert [direction["kind"] for direction in weak] == ["shift"], "along the corridor"
    assert abs(weak[0]["direction"] @ motion.rotation[:, 0]) > 0.99
    said = "a shift along ({:.2f}, {:.2f}, {:.2f})".format(*weak[0]["direction"])
    open_offline(visit, report(result, source, target, tmp_path / "r.html", limits=LIMITS))
    assert said in visit.page.inner_text("body")
    drawn = visit.page.evaluate(
        "document.getElementById('clouds')._fullData.slice(4)"
        ".map(trace => [trace.name, Array.from(trace.x), Array.from(trace.y), Array.from(trace.z)])"
    )
    assert [name for name, *_ in drawn] == [f"left open: {said}"]
    ends = np.transpose(drawn[0][1:])
    assert np.cross(ends[1] - ends[0], weak[0]["direction"]) == pytest.approx(0, abs=1e-4)
    assert np.linalg.norm(ends[1] - ends[0]) > 6
    assert visit.errors == []


@pytest.mark.parametrize("kind, said", [("turn", "a turn about"), ("shift", "a shift along")])
def test_weak_directions_are_read_as_the_schema_names_them(
    result: gmcr.CloudResult, kind: str, said: str
) -> None:
    schema = json.loads((Path(__file__).parents[2] / "docs/result.schema.json").read_text())
    surfaces = schema["$defs"]["clouds"]["properties"]["surfaces"]["properties"]
    entry = {"kind": kind, "direction": [0, 0, 1], "stiffness": 0.002}
    assert entry.keys() == surfaces["weak_directions"]["items"]["properties"].keys()
    fields = json.loads(result.to_json())
    fields["surfaces"]["weak_directions"] = [entry]
    fields["report"][0]["later"] = fields["certificate"]["evidence"]["later"] = 1  # may be added
    (direction,) = outcome_of_json(fields).weak_directions
    assert direction.words == f"{said} (0.00, 0.00, 1.00)"
    assert direction.axis.tolist() == [0, 0, 1]


def test_plot_names_what_it_draws(problem: gmcr.SyntheticProblem) -> None:
    result = gmcr.register_correspondences(problem.source, problem.target, noise_bound=0.02)
    figure = plot(result, problem.source, problem.target, noise_bound=0.02, limits=LIMITS)
    assert [trace.name for trace in figure.data] == [
        "source: 100 points",
        "target: 100 points",
        "40 inliers",
        "20 of 60 outliers",
    ]
    assert len(figure.data[2].x) == 3 * 40
    assert [step.label for step in figure.layout.sliders[0].steps][::5] == ["before", "after"]


@pytest.fixture
def server(clouds: Clouds, result: gmcr.CloudResult) -> Iterator[Any]:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    server = show(result, clouds[0], clouds[1], port=port, limits=LIMITS)
    yield server
    server.stop()


def type_into(box: Any, text: str) -> None:
    box.fill(text)
    box.press("Enter")


def test_viewer_shows_the_nodes_moves_the_source_and_hides_what_is_unchecked(
    visit: Visit, server: Any, clouds: Clouds, result: gmcr.CloudResult
) -> None:
    page = visit.page
    page.goto(f"http://127.0.0.1:{server.get_port()}")
    page.get_by_text("before / after").wait_for()
    body = page.inner_text("body")
    assert f"inliers {len(result.registration.inliers)} of {len(result.matches.source)}" in body
    assert "showing 1,500 of 3,000 points" in body
    for name in ("source", "target", "inliers", "outliers", "consensus graph", "point size"):
        assert page.get_by_text(name, exact=True).count() >= 1, name
    position, point_size = sorted(  # over the scene, and beside it
        page.locator("input[inputmode=decimal]").all(), key=lambda box: box.bounding_box()["x"]
    )
    type_into(point_size, "4")
    after = visit.wait_for_pixels("canvas", SOURCE, lambda pixels: pixels.sum() > 300)
    visit.wait_for_pixels("canvas", TARGET, lambda pixels: pixels.sum() > 300)
    type_into(position, "0")
    visit.wait_for_pixels(
        "canvas",
        SOURCE,
        lambda before: before.sum() > 100 and (before & after).sum() < 0.5 * after.sum(),
    )
    for known in (result.verdict, "all motions", "voxel_size", "of the source lies within"):
        assert known in body
    page.get_by_label("distances", exact=True).check()
    visit.wait_for_pixels("canvas", SOURCE, lambda pixels: pixels.sum() < 20)
    page.get_by_label("distances", exact=True).uncheck()
    visit.wait_for_pixels("canvas", SOURCE, lambda pixels: pixels.sum() > 100)
    page.get_by_label("source", exact=True).uncheck()
    visit.wait_for_pixels("canvas", SOURCE, lambda pixels: pixels.sum() < 20)
    assert visit.errors == []
    assert [url for url in visit.requests if "127.0.0.1" not in url and "blob:" not in url] == []


def test_viewer_leaves_most_of_a_phone_to_the_clouds(visit: Visit, server: Any) -> None:
    page = visit.page
    page.set_viewport_size({"width": 390, "height": 800})
    page.goto(f"http://127.0.0.1:{server.get_port()}")
    page.get_by_text("before / after").wait_for()
    head = page.get_by_text("gmcr", exact=True)  # of the sheet, which shrinks as it is filled
    end = time.monotonic() + 30
    while head.bounding_box()["y"] < 0.6 * 800:
        assert time.monotonic() < end, head.bounding_box()
        page.wait_for_timeout(100)
    assert not page.get_by_text("point size", exact=True).is_visible()
    pixels = visit.wait_for_pixels("canvas", TARGET, lambda pixels: pixels.sum() > 30)
    columns = np.flatnonzero(pixels.any(axis=0))
    assert columns.min() > 10 and columns.max() < pixels.shape[1] - 10
    page.get_by_text("Details", exact=True).click()
    page.get_by_text("point size", exact=True).wait_for()
    assert visit.errors == []

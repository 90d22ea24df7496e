# SPDX-License-Identifier: BSD-3-Clause
"""Promises of scripts/view.py: a solution becomes one page that plays without a network; bad input becomes one
line."""

import re
from collections.abc import Iterator

import numpy as np
import pytest
from browser import Page, chromium, wait_until
from matplotlib.colors import rgb_to_hsv, to_rgb
from matplotlib.image import imread
from scene_fixtures import placement_task, planar_task, spatial_task

from b4p_figures.spatial import GOAL, START, TRACE
from b4p_files.motion import replay, rest
from b4p_files.subject import read_subject

TIME = "Number(document.querySelector('[role=slider]').getAttribute('aria-valuenow'))"
PLAY, SLIDER = "button.mantine-ActionIcon-root", ".mantine-Slider-root"
CANVAS = "document.querySelector('canvas')"
LARGEST_BYTES = 15e6
DURATION_S = 12.0
SOME_PIXELS = 60
SOME_WAY, NO_WAY = 10.0, 3.0  # in pixels; the client's camera settles within one


@pytest.fixture(scope="module")
def page(tmp_path_factory) -> Iterator[Page]:
    with chromium(tmp_path_factory.mktemp("profile")) as page:
        yield page


@pytest.fixture
def html(tmp_path):
    return tmp_path / "pages" / "out.html"


def canvas(page: Page) -> np.ndarray:
    """The part of the window that shows the scene and neither title nor controls, nor the client's remark that there
    is no graphics card."""
    page.evaluate(
        "document.querySelectorAll('.mantine-Notification-root').forEach(note => note.style.opacity = 0)"
    )
    page.wait_for_frames(3)  # then what was asked for last is on the screen
    top, bottom = page.evaluate(
        "[document.getElementById('b4p').getBoundingClientRect().bottom,"
        f" {CANVAS}.getBoundingClientRect().bottom]"
    )
    return page.picture()[int(top) + 1 : int(bottom)]


def of_hue(picture: np.ndarray, color: str) -> np.ndarray:
    """Row and column of the pixels that have the colour's hue, however bright."""
    hue, saturation, _ = np.moveaxis(rgb_to_hsv(picture), 2, 0)
    return np.argwhere((np.abs(hue - rgb_to_hsv(to_rgb(color))[0]) < 0.04) & (saturation > 0.15))


def moved(one: np.ndarray, other: np.ndarray) -> float:
    """How many pixels the object has moved; less than that, as its trace has the same hue and does not move."""
    return float(np.linalg.norm(of_hue(one, TRACE).mean(axis=0) - of_hue(other, TRACE).mean(axis=0)))


def scrub(page: Page, share: float) -> np.ndarray:
    page.click(SLIDER, share)
    page.wait_for(f"Math.abs({TIME} / {DURATION_S} - {share}) < 0.02")  # the slider has a margin
    return canvas(page)


@pytest.mark.parametrize("task", [planar_task, spatial_task])
def test_the_page_plays_and_scrubs_without_a_network(script, tmp_path, html, page, task):
    task(tmp_path)
    result = script("view.py", tmp_path / "result.json", "-o", html)
    assert result.returncode == 0, result.stderr
    assert result.stdout == f"{html}\n"
    page.requests.clear()
    page.open(html)
    page.wait_for(f"{CANVAS} && document.querySelector('[role=slider]') && {TIME} > 0.1")
    page.click(PLAY)  # it plays from the start on, and stops
    wait_until(lambda: len(of_hue(canvas(page), START)) > SOME_PIXELS, "the scene is drawn")

    begin, middle = scrub(page, 0.1), scrub(page, 0.5)
    assert begin.std() > 0.02
    assert all(len(of_hue(middle, color)) > SOME_PIXELS for color in (START, GOAL, TRACE))
    assert moved(begin, middle) > SOME_WAY
    assert moved(begin, scrub(page, 0.1)) < NO_WAY  # backwards too

    page.click(PLAY)
    page.wait_for(f"{TIME} > {0.2 * DURATION_S}")
    page.click(PLAY)
    paused, time = canvas(page), page.evaluate(TIME)
    assert moved(begin, paused) > SOME_WAY
    assert moved(paused, canvas(page)) < NO_WAY
    assert page.evaluate(TIME) == time

    assert page.evaluate("document.querySelector('#b4p').innerText").startswith(
        "task: b4p, seed 1, 2 threads"
    )
    assert page.errors == []
    assert page.requests and all(url.split(":")[0] in ("file", "data", "blob") for url in page.requests)


def test_the_page_names_no_address_and_is_small(script, tmp_path, html):
    spatial_task(tmp_path)
    assert script("view.py", tmp_path / "result.json", "-o", html).returncode == 0
    hosts = set(re.findall(r"(?:https?|wss?)://([^/\"'\s]*)", html.read_text()))
    assert hosts <= {"www.w3.org"}  # names of XML dialects, which are not fetched
    assert html.stat().st_size < LARGEST_BYTES


@pytest.mark.parametrize("verified, word", [(True, "verified"), (False, "not verified")])
def test_the_title_tells_scene_planner_seed_status_and_verdict(script, tmp_path, html, verified, word):
    task = planar_task(tmp_path)
    task.result |= {"planner": "<i>own</i>", "seed": 42, "verification": {"passed": verified}}
    task.write()
    assert script("view.py", tmp_path / "result.json", "-o", html).returncode == 0
    text = html.read_text()
    assert "<h1>task: &lt;i&gt;own&lt;/i&gt;, seed 42, 2 threads</h1>" in text
    assert f"<p>Exact solution in 1.5 s, {word}, grasp 0</p>" in text


def test_an_unsolved_result_shows_the_scene_and_says_so(script, tmp_path, html, page):
    task = planar_task(tmp_path)
    task.result |= {"solved": False, "path": [], "joint_names": [], "status": "Timeout", "grasp_id": -1}
    task.write()
    assert script("view.py", tmp_path / "result.json", "-o", html).returncode == 0
    assert "Timeout after 1.5 s, no path" in html.read_text()
    page.open(html)
    page.wait_for(f"{CANVAS} && document.querySelector('[aria-label=\"Show scene tree\"]') && true")
    wait_until(lambda: len(of_hue(canvas(page), START)) > SOME_PIXELS, "the object is drawn")
    assert len(of_hue(canvas(page), GOAL)) == 0
    assert page.errors == []


def test_a_picture_comes_with_the_page(script, tmp_path, html):
    png = tmp_path / "pictures" / "out.png"
    planar_task(tmp_path)
    result = script("view.py", tmp_path / "result.json", "-o", html, "--png", png)
    assert result.returncode == 0, result.stderr
    assert result.stdout == f"{html}\n{png}\n"
    assert imread(png).std() > 0.05


def test_the_best_placement_is_shown_with_its_arm_and_objective(script, tmp_path, html, page):
    placement_task(tmp_path)
    result = script("view.py", tmp_path / "result.json", "-o", html, "--png", tmp_path / "out.png")
    assert result.returncode == 0, result.stderr
    text = html.read_text()
    assert "<h1>task: placement by tree, seed 7, 1 thread, max_clearance 0.125 m</h1>" in text
    assert "<p>Exact solution in 0.5 s, verified, arm right</p>" in text
    page.open(html)
    page.wait_for(f"{CANVAS} && document.querySelector('[role=slider]') && {TIME} > 0.1")
    page.click(PLAY)
    wait_until(lambda: len(of_hue(canvas(page), START)) > SOME_PIXELS, "the scene is drawn")
    begin, middle = scrub(page, 0.1), scrub(page, 0.5)
    assert all(len(of_hue(middle, color)) > SOME_PIXELS for color in (START, GOAL, TRACE))
    assert moved(begin, middle) > SOME_WAY
    assert page.errors == []


def test_the_object_is_in_the_hand_of_the_arm_that_places_it(tmp_path):
    task = placement_task(tmp_path)
    scene, result = read_subject(str(tmp_path / "result.json"))
    motion = replay(scene, result, 3)
    q = np.array(task.result["improvements"][-1]["path"][-1])
    reach = 0.4 * np.array([np.cos(q[0] + np.pi), np.sin(q[0] + np.pi)])
    assert np.allclose(motion.tcp[-1][:2, 3], reach)  # the arm is turned round, and its path is the last one
    assert np.allclose(motion.object[-1] @ [0, 0, 0.05, 1], motion.tcp[-1][:, 3])
    alone, _ = read_subject(str(tmp_path / "scene.yaml"))
    assert np.allclose(rest(alone).object[0] @ [0, 0, 0.05, 1], rest(alone).tcp[0][:, 3])
    assert np.allclose(rest(alone).tcp[0][:2, 3], 0.4 * np.array([np.cos(0.5), np.sin(0.5)]))  # the first arm


def test_a_result_without_placement_shows_the_scene_and_says_so(script, refuses, tmp_path, html):
    task = placement_task(tmp_path)
    best = task.result["improvements"]
    task.result |= {"improvements": [], "status": "Timeout"}
    task.write()
    assert script("view.py", tmp_path / "result.json", "-o", html).returncode == 0
    assert "Timeout after 2 s, no path" in html.read_text()
    task.result |= {"improvements": [best[0] | {"arm": "third"}], "arms": [{"name": "third", "joint_names": ["pan", "lift"]}]}
    task.write()
    refuses("third is no arm of", "view.py", tmp_path / "result.json", "-o", tmp_path / "other.html")


BAD_RESULTS = {
    "wrong schema": ({"schema": 2}, "result.json: schema: 2 is not 1"),
    "missing key": ({"grasp": None}, "result.json: not a result file"),
    "not finite": ({"path": [[0, 0, 0], [1, float("nan"), 0]]}, "path: nan is not a finite number"),
    "other joints": ({"joint_names": ["a", "b", "c"]}, "joint_names are not those of"),
    "unknown scene": ({"scene": "nowhere"}, "result.json: scene: nowhere: "),
}


@pytest.mark.parametrize("change, words", BAD_RESULTS.values(), ids=BAD_RESULTS.keys())
def test_a_bad_result_is_refused_and_nothing_written(refuses, tmp_path, html, change, words):
    task = planar_task(tmp_path)
    task.result |= change
    task.write()
    refuses(words, "view.py", tmp_path / "result.json", "-o", html, "--png", tmp_path / "out.png")
    assert not html.exists() and not (tmp_path / "out.png").exists()


def test_missing_files_and_unwritable_places_are_refused(refuses, tmp_path, html):
    planar_task(tmp_path)
    refuses("none.json: No such file", "view.py", tmp_path / "none.json", "-o", html)
    refuses("result.json: ", "view.py", tmp_path / "result.json", "-o", tmp_path / "result.json" / "x.html")

# SPDX-License-Identifier: BSD-3-Clause
"""A scene, and the motion in it, as one HTML page that needs nothing else: viser's client and data inside."""

from collections.abc import Iterator
from contextlib import contextmanager, redirect_stdout
from html import escape
from io import StringIO
from pathlib import Path

import numpy as np
from matplotlib.colors import to_rgb
from viser import MeshHandle, SceneApi, ViserServer
from viser.transforms import SO3
from vtkmodules.vtkCommonDataModel import vtkPolyData

from b4p_figures.planar import GRADIENT, PICK_TO_PLACE
from b4p_figures.sight import CAMERA_DISTANCE, Screens, fitting_distance
from b4p_figures.spatial import GOAL, OBSTACLE, REGION, START, TRACE
from b4p_figures.spatial import diagonal, directions, subject
from b4p_figures.surfaces import segments, triangles, union
from b4p_files.motion import (
    Motion,
    goal_points,
    motion_title,
    object_points,
    obstacle_points,
    replay,
    rest,
    robot_points,
)
from b4p_files.output import replacing
from b4p_files.poses import Pose, transform
from b4p_files.result import Result
from b4p_files.scene import Scene
from b4p_files.shapes import PlacedShape

FRAMES = 301
DURATION_S = 12.0  # a path has no speed of its own
TRACE_POINTS = 1000
TRACE_PIXELS, EDGE_PIXELS = 3.0, 1.5
ROBOT = "#d9dce1"
OBSTACLE_OPACITY, REGION_OPACITY, GHOST_OPACITY = 0.22, 0.45, 0.4
GHOST_INSET = 5e-4  # over the size of what is shown: a ghost hides inside the robot that is at its place
FIELD_OF_VIEW_RAD = 2 * np.arctan(0.34)  # of the window's height
SHOWN_SLOPE = np.array([0.45, 0.29])  # half of what is shown, width and height, over its distance
RAISED = 0.05  # how far the camera looks above the middle, over its distance: the title needs room
SKY, GROUND, BRIGHTNESS = (255, 255, 255), (150, 150, 160), 1.6
NEAREST_M = 0.05  # what the camera still sees
GAMMA = 2.2  # of sRGB, roughly

CARD = """<style>
#b4p {{ position: fixed; top: 12px; left: 0; right: 0; margin: auto; z-index: 5; pointer-events: none;
  width: fit-content; max-width: min(94vw, 640px); box-sizing: border-box; padding: 8px 16px;
  border-radius: 8px; text-align: center;
  background: rgba(255, 255, 255, 0.85); box-shadow: 0 1px 6px rgba(0, 0, 0, 0.15);
  font: 14px/1.45 system-ui, sans-serif; color: #222; }}
#b4p h1 {{ margin: 0; font-size: 16px; }}
#b4p p {{ margin: 0; }}
#b4p ul {{ margin: 4px 0 0; padding: 0; list-style: none; font-size: 12px; }}
#b4p li {{ display: inline-block; margin: 0 8px; }}
#b4p i {{ display: inline-block; width: 14px; height: 10px; margin-right: 5px; border-radius: 2px;
  border: 1px solid rgba(0, 0, 0, 0.25); }}
@media (max-height: 560px) {{ #b4p ul {{ display: none; }} }}
</style>
<div id="b4p"><h1>{title}</h1><p>{outcome}</p><ul>{legend}</ul></div>
"""


def write_page(scene: Scene, result: Result | None, file: Path) -> None:
    """Without a path the page shows the scene with its robot at rest."""
    with _server() as server:
        _light(server.scene)
        legend = _add_scene(server.scene, scene)
        if result is not None and len(result.path):
            motion = replay(scene, result, FRAMES)
            trace = replay(scene, result, TRACE_POINTS).tcp[:, :3, 3]
            legend |= _add_ghosts(server.scene, scene, motion) | _add_trace(server.scene, scene, trace)
        else:
            motion = rest(scene)
            legend |= {f"object at the {scene.words.first}": START} if scene.object else {}
        _aim(server, scene, motion)
        html = _record(server, scene, motion)
    with replacing(file) as temporary:
        temporary.write_text(_with_card(html, motion_title(scene, result), legend), encoding="utf-8")


@contextmanager
def _server() -> Iterator[ViserServer]:
    """viser keeps its scenes in a server; this one is heard on this machine alone, and says nothing."""
    with redirect_stdout(StringIO()):
        server = ViserServer(host="127.0.0.1", port=0, verbose=False)
        try:
            yield server
        finally:
            server.stop()


def _add(
    api: SceneApi,
    name: str,
    surface: vtkPolyData,
    color: str,
    opacity: float | None = None,
    inset_m: float = 0.0,
) -> MeshHandle:
    points, corners = triangles(surface, inset_m)
    return api.add_mesh_simple(
        name, points, corners, color=to_rgb(color), opacity=opacity, cast_shadow=False, receive_shadow=False
    )


def _add_edges(api: SceneApi, name: str, surface: vtkPolyData, color: str) -> None:
    edges = segments(surface)
    if len(edges):
        api.add_line_segments(name, edges, to_rgb(color), thickness=EDGE_PIXELS, thickness_units="screen")


def _light(api: SceneApi) -> None:
    """Instead of viser's picture of a room, which takes software renderers many seconds to prepare."""
    api.configure_environment_map(None)
    api.configure_default_lights(True, cast_shadow=False)
    api.add_light_hemisphere("/light", sky_color=SKY, ground_color=GROUND, intensity=BRIGHTNESS)


def _add_scene(api: SceneApi, scene: Scene) -> dict[str, str]:
    for name, placed in scene.obstacles.items():
        surface = union([transform(placed.X_BS, placed.shape.points())])
        _add(api, f"/obstacles/{name}", surface, OBSTACLE, OBSTACLE_OPACITY)
        _add_edges(api, f"/obstacles/{name}/edges", surface, OBSTACLE)
    goal = union(goal_points(scene))
    _add(api, "/goal", goal, REGION, REGION_OPACITY * scene.words.goal_opacity)
    _add_edges(api, "/goal/edges", goal, REGION)
    return {"obstacles": OBSTACLE, scene.words.goal: REGION}


def _add_ghosts(api: SceneApi, scene: Scene, motion: Motion) -> dict[str, str]:
    ends = {scene.words.first: (0, -1, START), scene.words.last: (-1, 0, GOAL)}
    inset_m = GHOST_INSET * diagonal(subject(scene, motion, (0, -1))[0])
    for name, (moment, other, color) in ends.items():
        solids = {
            "robot": robot_points(scene, motion, moment, unless_as_at=other),
            "object": object_points(scene, motion.object[moment]),
        }
        for part, points in solids.items():
            if points:
                _add(api, f"/{name}/{part}", union(points), color, GHOST_OPACITY, inset_m)
    shown = "robot and object" if scene.object else "robot"
    return {f"{shown} at the {name}": color for name, (*_, color) in ends.items()}


def _add_trace(api: SceneApi, scene: Scene, trace: np.ndarray) -> dict[str, str]:
    # The client takes colours of single points as linear ones.
    colors = GRADIENT(np.linspace(0.0, 1.0, len(trace)))[:, :3] ** GAMMA
    ends, end_colors = (np.stack([rows[:-1], rows[1:]], axis=1) for rows in (trace, colors))
    api.add_line_segments("/TCP trace", ends, end_colors, thickness=TRACE_PIXELS, thickness_units="screen")
    way = f"TCP from {scene.words.first} to {scene.words.last}"
    legend = {"object on its way": TRACE} if scene.object else {}
    return legend | {way: f"linear-gradient(90deg, {', '.join(PICK_TO_PLACE)})"}


def _aim(server: ViserServer, scene: Scene, motion: Motion) -> None:
    last = len(motion.tcp) - 1
    inside, wanted = subject(scene, motion, (0, last // 2, last))
    centre = (inside.min(axis=0) + inside.max(axis=0)) / 2
    screens = _screens(scene, motion, (last // 2, last))
    direction = screens.clearest(directions(scene), centre, CAMERA_DISTANCE * diagonal(inside), wanted)
    direction = direction / np.linalg.norm(direction)
    distance = fitting_distance(inside, centre, direction, SHOWN_SLOPE)
    target = centre + (0, 0, RAISED * distance)
    server.initial_camera.position = target + distance * direction
    server.initial_camera.look_at = target
    server.initial_camera.near = NEAREST_M
    server.initial_camera.fov = FIELD_OF_VIEW_RAD


def _screens(scene: Scene, motion: Motion, moments: tuple[int, ...]) -> Screens:
    screens = Screens()
    for points in obstacle_points(scene):
        screens.add(union([points]), OBSTACLE_OPACITY)
    for moment in moments:
        screens.add(union(robot_points(scene, motion, moment)), GHOST_OPACITY)
    return screens


def _record(server: ViserServer, scene: Scene, motion: Motion) -> str:
    """The page, in which the robot and the object move as told."""
    bodies = {
        f"/robot/{link}": (shapes, ROBOT, motion.links[link]) for link, shapes in scene.robot.shapes.items()
    }
    bodies["/object"] = (scene.object, TRACE if len(motion.object) > 1 else START, motion.object)
    moving = []
    for name, (shapes, color, poses) in bodies.items():
        if shapes:
            handle = _add(server.scene, name, union(_own_points(shapes)), color)
            _place(handle, poses[0])
            if not np.allclose(poses, poses[0]):
                moving.append((handle, poses))
    recorder = server.get_scene_serializer()
    for moment in range(1, len(motion.object)):
        recorder.insert_sleep(DURATION_S / (len(motion.object) - 1))
        for handle, poses in moving:
            _place(handle, poses[moment])
    return recorder.as_html()


def _own_points(shapes: list[PlacedShape]) -> list[np.ndarray]:
    return [transform(placed.X_BS, placed.shape.points()) for placed in shapes]


def _place(handle: MeshHandle, X: Pose) -> None:
    handle.position = X[:3, 3]
    handle.wxyz = SO3.from_matrix(X[:3, :3]).wxyz


def _with_card(html: str, title: str, legend: dict[str, str]) -> str:
    query, _, outcome = title.partition("\n")
    items = "".join(
        f'<li><i style="background:{color}"></i>{escape(label)}</li>' for label, color in legend.items()
    )
    card = CARD.format(title=escape(query), outcome=escape(outcome), legend=items)
    html = html.replace("<title>Viser</title>", f"<title>{escape(query)}</title>", 1)
    body, end, rest_of_page = html.rpartition("</body>")
    return body + card + end + rest_of_page

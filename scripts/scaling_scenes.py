#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes scenes in which the work grows: the task of SCENE with 1 to 10000 grasps to choose from, one of them known to
work, and with up to 10000 obstacles, in files AXIS_SERIES_INSTANCE_AMOUNT.yaml."""

import argparse
from pathlib import Path

from b4p_files.errors import FileError, run
from b4p_files.output import make_folder, replacing
from b4p_files.scaling_scenes import (
    AMOUNTS,
    exported_grasps,
    offered,
    only_obstacles,
    read_yaml,
    solved_grasp,
    table_text,
    with_boxes,
    with_grasps,
    write_yaml,
)

PLACES = ("far", "near")
OPEN, LEFT = "open", {"floor"}


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("scene", metavar="SCENE", type=Path, help="scene file of pick and place")
    parser.add_argument(
        "--queries", metavar="FILE", type=Path, required=True, help="its `b4p export`: the grasps"
    )
    parser.add_argument(
        "--result", metavar="FILE", type=Path, required=True, help="its `b4p plan`: the grasp that works"
    )
    parser.add_argument(
        "--instance", metavar="N", type=int, required=True, help="in names of scenes, and seed"
    )
    parser.add_argument(
        "--most", metavar="N", type=int, default=AMOUNTS[-1], help="largest amount [%(default)s]"
    )
    parser.add_argument("-o", "--out", metavar="FOLDER", type=Path, required=True, help="where scenes go")
    arguments = parser.parse_args()
    amounts = [amount for amount in AMOUNTS if amount <= arguments.most]
    make_folder(arguments.out)
    scene, family = read_yaml(arguments.scene), arguments.scene.stem.split("_")[0]
    try:
        write_grasp_scenes(scene, family, amounts, arguments)
        for series, task in {family: scene, OPEN: only_obstacles(scene, LEFT)}.items():
            write_obstacle_scenes(task, series, amounts, arguments)
    except (KeyError, TypeError, ValueError) as error:
        raise FileError(arguments.scene, str(error)) from None


def write_grasp_scenes(scene: dict, family: str, amounts: list[int], arguments: argparse.Namespace) -> None:
    compatible, others = solved_grasp(arguments.result), exported_grasps(arguments.queries)
    for amount in amounts:
        name = f"grasps_{family}_{arguments.instance}_{amount}"
        with replacing(arguments.out / f"{name}.grasps.csv") as temporary:
            temporary.write_text(table_text(offered(compatible, others, amount, arguments.instance)))
        write(with_grasps(scene, name, f"{name}.grasps.csv"), arguments.out)


def write_obstacle_scenes(task: dict, series: str, amounts: list[int], arguments: argparse.Namespace) -> None:
    own = len(task["obstacles"])
    for where in PLACES:
        for amount in [own, *(amount for amount in amounts if amount > own)]:
            name = f"obstacles_{series}_{where}_{arguments.instance}_{amount}"
            write(with_boxes(task, name, amount, where, arguments.instance), arguments.out)


def write(scene: dict, folder: Path) -> None:
    write_yaml(folder / f"{scene['name']}.yaml", scene)
    print(folder / f"{scene['name']}.yaml")


if __name__ == "__main__":
    run(main)

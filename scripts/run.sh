#!/usr/bin/env bash
# Installs, builds (preset release), runs the demonstration benchmark, and draws its plots and one solution
# of each scene, verified.
#
# Usage: scripts/run.sh [--no-install] [--out FOLDER] [--help]
#   --no-install  take what is installed
#   --out FOLDER  where results go (default: out/demo in the source tree)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install=yes
out="$root/out/demo"
while (($#)); do
  case "$1" in
    --help | -h) print_help "$0" && exit ;;
    --no-install) install=no ;;
    --out)
      [[ -n ${2:-} ]] || fail "--out needs a folder"
      out="$(realpath -m "$2")"
      shift
      ;;
    *) fail "unknown option $1 (see --help)" ;;
  esac
  shift
done

mkdir -p "$out"
[[ $install == no ]] || "$root/scripts/install.sh"
build_release b4p
cd "$out"

b4p="$root/build/release/experiments/b4p"
scenes=(maze stick grocery)

heading "Benchmark experiments/demo.yaml"
"$b4p" bench "$root/experiments/demo.yaml" --out "$out" --overwrite

heading "Database and plots"
"$python" "$root/scripts/database.py" "${scenes[@]/%/.log}" -o demo.db
"$python" "$root/scripts/plot.py" demo.db -o plots

# A scene that stays unsolved within its budget is drawn all the same, and makes this script end with 1.
unsolved=()
for scene in "${scenes[@]}"; do
  heading "One solution of $scene, verified and drawn"
  "$b4p" plan "$scene" --planner b4p --seed 1 --threads 2 --out "$scene.json" --forests "${scene}_forests.json" ||
    (($? == 1)) || fail "planning $scene failed"
  "$b4p" verify "$scene.json" || (($? == 1)) || fail "$scene.json fails its verification"
  grep -q '"solved": true' "$scene.json" || unsolved+=("$scene")
  "$python" "$root/scripts/draw.py" "$scene.json" --forests "${scene}_forests.json" -o "$scene.png"
  "$python" "$root/scripts/draw.py" "$scene" -o "${scene}_scene.png"
  "$python" "$root/scripts/view.py" "$scene.json" -o "$scene.html"
done

# RRTConnect draws its picks before it plans: a second of it shows the grasps there are.
heading "Scenes and sampled grasps"
for scene in "${scenes[@]}"; do
  "$b4p" plan "$scene" --planner rrtconnect --time-limit-s 1 --out "${scene}_picks.json" \
    --forests "${scene}_picks_forests.json" >/dev/null || (($? == 1)) || fail "drawing picks of $scene failed"
done
"$python" "$root/scripts/figure4.py" "${scenes[@]/%/_picks_forests.json}" -o figure4.png

heading "Done: look at"
cat <<END
  $out/summary.md     solved, verified and times of every planner
  $out/plots/         overview.png, success.png, times.png, progress.png
  $out/maze.png       a solution of the maze and the trees that found it
  $out/stick.png      the stick on its shelf
  $out/grocery.png    a solution of the grocery shelf
  $out/*.html         the same in 3-D, to play and scrub; opens offline
  $out/figure4.png    the scenes and their grasps side by side
  $out/demo.db        all runs, for Planner Arena and one's own queries
END
((${#unsolved[@]} == 0)) || fail "unsolved within the budget: ${unsolved[*]}"

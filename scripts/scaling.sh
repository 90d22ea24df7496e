#!/usr/bin/env bash
# How cost grows with the work: installs, builds (preset release), draws grocery instances, writes scenes of them with
# 1 to 10000 grasps and obstacles, runs B4P on these, simulates 1 to 32 workers, measures the nearest node and a
# worker's step in trees of up to a million nodes, and makes a plot and tables. Whatever ends it, the same command goes
# on from there.
#
# Usage: scripts/scaling.sh [--no-install] [--out FOLDER] [--instances N] [--first-seed SEED] [--runs N]
#                           [--most N] [--time-limit-s S] [--help]
#   --no-install         take what is installed
#   --out FOLDER         where results go (default: out/scaling in the source tree)
#   --instances N        grocery instances (default: 3)
#   --first-seed SEED    seed of the first one; the others follow, those left out that B4P does not solve in 10 s
#                        (default: 401)
#   --runs N             runs per scene with obstacles; four times as many with grasps, and per number of workers
#                        (default: 3)
#   --most N             largest number of grasps and obstacles: 1, 10, 100, 1000 or 10000 (default: 10000)
#   --time-limit-s S     time limit of a run (default: 10)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install=yes
out="$root/out/scaling"
instances=3
first_seed=401
runs=3
most=10000
limit_s=10
while (($#)); do
  case "$1" in
    --help | -h) print_help "$0" && exit ;;
    --no-install) install=no ;;
    --out | --instances | --first-seed | --runs | --most | --time-limit-s)
      [[ -n ${2:-} ]] || fail "$1 needs a value"
      case "$1" in
        --out) out="$(realpath -m "$2")" ;;
        --instances) instances="$2" ;;
        --first-seed) first_seed="$2" ;;
        --runs) runs="$2" ;;
        --most) most="$2" ;;
        --time-limit-s) limit_s="$2" ;;
      esac
      shift
      ;;
    *) fail "unknown option $1 (see --help)" ;;
  esac
  shift
done
for number in "$instances" "$first_seed" "$runs" "$most"; do
  [[ $number =~ ^[1-9][0-9]{0,8}$ ]] || fail "$number is not a positive whole number"
done

[[ $install == no ]] || "$root/scripts/install.sh"
build_release b4p nearest_benchmark worker_benchmark
b4p="$root/build/release/experiments/b4p"
benchmarks="$root/build/release/experiments/benchmarks"

heading "Drawing $instances instances, and scenes of each"
mkdir -p "$out/instances" "$out/scenes"
seeds=()
for ((seed = first_seed; ${#seeds[@]} < instances; ++seed)); do
  scene="$out/instances/grocery_$seed"
  [[ -f $scene.yaml ]] || "$b4p" generate grocery --seed "$seed" --out "$scene.yaml"
  code=0
  [[ -f $scene.json ]] || "$b4p" plan "$scene.yaml" --time-limit-s 10 --out "$scene.json" || code=$?
  ((code <= 1)) || exit "$code"
  if ! grep -q '"solved": true' "$scene.json"; then
    echo "grocery_$seed is left out: it is not known which of its grasps work"
    continue
  fi
  seeds+=("$seed")
  [[ ! -f $out/scenes/$seed.$most.list ]] || continue
  "$b4p" export "$scene.yaml" --grasps "$most" --placements 1 --place-roots 0 --seed "$seed" --out "$scene.jsonl"
  "$python" "$root/scripts/scaling_scenes.py" "$scene.yaml" --queries "$scene.jsonl" --result "$scene.json" \
    --instance "$seed" --most "$most" -o "$out/scenes" >"$out/scenes/$seed.$most.list.part"
  mv "$out/scenes/$seed.$most.list.part" "$out/scenes/$seed.$most.list"
done

# Usage: measure_axis AXIS RUNS
measure_axis() {
  local list
  list=$(for seed in "${seeds[@]}"; do sed 's|.*/||' "$out/scenes/$seed.$most.list"; done | grep "^$1_" | sed 's|^|, scenes/|' | tr -d '\n')
  sed "s|^scenes:.*|scenes: [${list:2}]|" "$root/experiments/scaling/scaling.yaml" >"$out/$1.yaml"
  heading "${1^}"
  resume_bench "$out/$1.yaml" "$out/$1" --runs "$2" --time-limit-s "$limit_s"
  require_sound_runs "$out/$1"
}
measure_axis grasps "$((4 * runs))"
measure_axis obstacles "$runs"

heading "Workers"
for ways in "--workers 1,2,4,8,16,32" "--workers 1,2 --real-threads"; do
  code=0
  # shellcheck disable=SC2086
  "$b4p" simulate "$out/instances/grocery_${seeds[0]}.yaml" $ways --runs "$((4 * runs))" \
    --time-limit-s "$limit_s" --out "$out/workers.jsonl" || code=$?
  ((code <= 1)) || exit "$code"
done

heading "Nodes"
measure() { # FILE PROGRAM [OPTION...]
  [[ ! -f $1 ]] || return 0
  "$benchmarks/$2" "${@:3}" --benchmark_out="$1.part" --benchmark_out_format=json
  mv "$1.part" "$1"
}
measure "$out/nearest.json" nearest_benchmark '--benchmark_filter=^query/tree/7/(10|100|1000|10000|100000)/(0|512)$|^query/tree/7/(10|100)/128$|^query/tree/7/1000000/512$'
measure "$out/steps.json" worker_benchmark '--benchmark_filter=/step/'

heading "Plot and tables"
"$python" "$root/scripts/scaling.py" "$out/grasps" "$out/obstacles" --speedup "$out/workers.jsonl" \
  --nodes "$out/nearest.json" "$out/steps.json" -o "$out"
heading "Done: look at $out/scaling.png and $out/scaling.md"

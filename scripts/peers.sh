#!/usr/bin/env bash
# B4P beside its peers on instances drawn from the scene families: installs, builds (preset release), draws the
# instances, runs experiments/peers/peers.yaml on them, and makes database, plots and a table of ratios. Whatever
# ends it, the same command goes on from there.
#
# Usage: scripts/peers.sh [--no-install] [--out FOLDER] [--instances N] [--first-seed SEED]
#                         [--families "grocery stick"] [--runs N] [--time-limit-s S] [--help]
#   --no-install              take what is installed
#   --out FOLDER              where results go (default: out/peers in the source tree)
#   --instances N             instances per family (default: 20)
#   --first-seed SEED         seed of the first one; the others follow (default: 301)
#   --families "grocery"      families (default: grocery stick)
#   --runs N                  runs per instance and planner (default: the experiment's, 2)
#   --time-limit-s S          time limit of a run (default: the experiment's, 2)
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install=yes
out="$root/out/peers"
instances=20
first_seed=301
families="grocery stick"
options=()
while (($#)); do
  case "$1" in
    --help | -h) print_help "$0" && exit ;;
    --no-install) install=no ;;
    --out | --instances | --first-seed | --families | --runs | --time-limit-s)
      [[ -n ${2:-} ]] || fail "$1 needs a value"
      case "$1" in
        --out) out="$(realpath -m "$2")" ;;
        --instances) instances="$2" ;;
        --first-seed) first_seed="$2" ;;
        --families) families="$2" ;;
        *) options+=("$1" "$2") ;;
      esac
      shift
      ;;
    *) fail "unknown option $1 (see --help)" ;;
  esac
  shift
done
for number in "$instances" "$first_seed"; do
  [[ $number =~ ^[1-9][0-9]{0,8}$ ]] || fail "$number is not a positive whole number"
done

[[ $install == no ]] || "$root/scripts/install.sh"
build_release b4p
b4p="$root/build/release/experiments/b4p"

heading "Drawing $instances instances of each of: $families"
mkdir -p "$out/instances"
scenes=()
for ((seed = first_seed; seed < first_seed + instances; ++seed)); do
  for family in $families; do
    scene="$out/instances/${family}_$seed.yaml"
    [[ -f $scene ]] || "$b4p" generate "$family" --seed "$seed" --out "$scene"
    scenes+=("instances/${family}_$seed.yaml")
  done
done
list=$(printf ', %s' "${scenes[@]}")
sed "s|^scenes:.*|scenes: [${list:2}]|" "$root/experiments/peers/peers.yaml" >"$out/peers.yaml"

heading "Benchmark"
resume_bench "$out/peers.yaml" "$out/runs" "${options[@]}"

heading "Database, plots and table"
"$python" "$root/scripts/database.py" "$out/runs"/*.log -o "$out/peers.db"
"$python" "$root/scripts/plot.py" "$out/peers.db" -o "$out/plots"
"$python" "$root/scripts/peers.py" "$out/runs" -o "$out"

heading "Done: look at"
cat <<END
  $out/peers.md            rates, times, ratios
  $out/plots/              success over time, time of every run
  $out/peers.db            all runs, for Planner Arena and one's own queries
END
require_sound_runs "$out/runs"

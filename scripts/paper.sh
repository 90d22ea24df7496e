#!/usr/bin/env bash
# Reproduces the tables of the B4P paper as far as this machine has the cores: installs, builds (preset release),
# runs experiments/paper/tables.yaml, and makes database, plots and tables, the paper's figures beside ours. All
# of it takes a day or more; whatever ends it, the same command goes on from there.
#
# Usage: scripts/paper.sh [--no-install] [--out FOLDER] [--runs N] [--threads "1 2"] [--scenes "maze grocery"]
#                         [--time-limit-s S] [--experiment FILE] [--help]
#   --no-install        take what is installed
#   --out FOLDER        where results go (default: out/paper in the source tree)
#   --runs N            runs per planner and scene (default: the experiment's, 10, of b4p 20)
#   --threads "1 2"     thread counts (default: 1 2 4 8 16 30, as far as there are cores)
#   --scenes "maze"     some of the scenes (default: maze stick grocery)
#   --time-limit-s S    time limit of a run (default: the paper's)
#   --experiment FILE   another experiment file
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install=yes
out="$root/out/paper"
experiment="$root/experiments/paper/tables.yaml"
options=()
while (($#)); do
  case "$1" in
    --help | -h) print_help "$0" && exit ;;
    --no-install) install=no ;;
    --out | --runs | --threads | --scenes | --time-limit-s | --experiment)
      [[ -n ${2:-} ]] || fail "$1 needs a value"
      case "$1" in
        --out) out="$(realpath -m "$2")" ;;
        --experiment) experiment="$(realpath -m "$2")" ;;
        --threads | --scenes) options+=("$1" "${2// /,}") ;;
        *) options+=("$1" "$2") ;;
      esac
      shift
      ;;
    *) fail "unknown option $1 (see --help)" ;;
  esac
  shift
done

[[ $install == no ]] || "$root/scripts/install.sh"
build_release b4p

heading "Benchmark $experiment"
resume_bench "$experiment" "$out" "${options[@]}"

heading "Database, plots and tables"
cd "$out"
"$python" "$root/scripts/database.py" ./*.log -o paper.db
"$python" "$root/scripts/plot.py" paper.db -o plots
"$python" "$root/scripts/tables.py" . -o .

heading "Done: look at"
cat <<END
  $out/tables.md           the paper's tables, ours beside it
  $out/threads_*.png       time and speed-up over threads, ours beside the paper's
  $out/plots/              success over time, time of every run, progress
  $out/paper.db, *.log     all runs, for Planner Arena and one's own queries
  $out/runs.jsonl          one line per run
END
require_sound_runs "$out"

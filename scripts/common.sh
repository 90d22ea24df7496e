# shellcheck shell=bash
# Shared by the scripts in this folder, which source it.

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
# shellcheck disable=SC2034
python="$root/.venv/bin/python"

heading() {
  printf '\n== %s (%s)\n' "$*" "$(date +%H:%M:%S)"
}

fail() {
  printf '%s: %s\n' "$(basename "$0")" "$*" >&2
  exit 1
}

# The comment at the top of a script is its help.
print_help() {
  sed -n '2,/^[^#]/{s/^# \{0,1\}//p}' "$1"
}

# Parallel compilations: one per core, as far as memory carries them.
build_jobs() {
  local kib_per_job=1572864 available jobs cores # 1.5 GiB
  available=$(awk '/^MemAvailable:/ {print $2}' /proc/meminfo)
  cores=$(nproc)
  jobs=$((available / kib_per_job))
  ((jobs <= cores)) || jobs=$cores
  ((jobs >= 1)) || jobs=1
  echo "$jobs"
}

# Usage: build_release TARGET...
build_release() {
  local launcher=()
  if command -v ccache >/dev/null; then
    launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cd "$root" || return
  heading "Configuring (preset release)"
  cmake --preset release "${launcher[@]}"
  heading "Building with $(build_jobs) jobs"
  cmake --build --preset release --parallel "$(build_jobs)" --target "$@"
}

# Runs what is missing of an experiment; ends the script on bad input and interrupts. `bench_code` is its exit code.
# Usage: resume_bench EXPERIMENT FOLDER [OPTION...]
resume_bench() {
  bench_code=0
  "$root/build/release/experiments/b4p" bench "$1" --out "$2" --resume "${@:3}" || bench_code=$?
  case $bench_code in
    2) exit 2 ;;
    130) fail "interrupted; the same command goes on from here" ;;
  esac
}

# Unsolved runs are what baselines and peers are expected to leave; crashes and failed verifications are not.
# Usage: require_sound_runs FOLDER
require_sound_runs() {
  ((bench_code <= 1)) || fail "runs crashed or failed their verification, see $1/summary.md"
}

#!/usr/bin/env bash
# Installs, builds (preset release), runs the demonstration benchmark, and draws its plots and one solution
# of each scene, verified.
#
# Usage: scripts/run.sh [--no-install] [--out FOLDER] [--help]
#   --no-install  take what is installed
#   --out FOLDER  where results go (default: out/demo in the source tree)
set -euo pipefail
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

[[ $install == no ]] || "$root/scripts/install.sh"
build_release
b4p="$root/build/release/b4p"
mkdir -p "$out"

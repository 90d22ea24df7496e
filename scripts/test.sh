#!/usr/bin/env bash
# Installs, builds (preset release) and runs all tests; ends with ctest's summary. Exit code 0: all passed.
#
# Usage: scripts/test.sh [--no-install] [--help]
#   --no-install  take what is installed
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

install=yes
for option in "$@"; do
  case "$option" in
    --help | -h) print_help "$0" && exit ;;
    --no-install) install=no ;;
    *) fail "unknown option $option (see --help)" ;;
  esac
done

[[ $install == no ]] || "$root/scripts/install.sh"
build_release all

heading "Testing"
ctest --preset release

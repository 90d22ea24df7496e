#!/usr/bin/env bash
# Runs the tests of scripts/ in the tree's Python environment. Usage: run_pytest.sh EXIT_CODE_WHEN_SKIPPED
set -euo pipefail
here="$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)"
python="$here/../../.venv/bin/python"
if [[ ! -x $python ]]; then
  echo "skipped: no .venv in the source tree; scripts/install.sh makes it"
  exit "$1"
fi
exec "$python" -m pytest -q -p no:cacheprovider "$here"

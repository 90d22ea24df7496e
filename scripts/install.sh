#!/usr/bin/env bash
# Installs what b4p needs: the packages of scripts/debian-packages.txt with apt-get (through sudo when not
# root), and a Python environment for the scripts in .venv/. Does nothing that is done already.
#
# Usage: scripts/install.sh [--check] [--help]
#   --check  install nothing; list what is missing and exit with 1 if anything is
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"

check_only=no
for option in "$@"; do
  case "$option" in
    --help | -h) print_help "$0" && exit ;;
    --check) check_only=yes ;;
    *) fail "unknown option $option (see --help)" ;;
  esac
done

missing_packages() {
  local package
  sed 's/#.*//' "$root/scripts/debian-packages.txt" | xargs -n1 | while read -r package; do
    [[ "$(dpkg-query -W -f '${db:Status-Status}' "$package" 2>/dev/null)" == installed ]] || echo "$package"
  done
}

may_install() {
  ((EUID == 0)) && return
  command -v sudo >/dev/null || return 1
  # Without a terminal sudo cannot ask for a password.
  [[ -t 0 ]] || sudo -n true 2>/dev/null
}

apt() {
  local as_root=()
  ((EUID == 0)) || as_root=(sudo)
  "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y "$@"
}

install_packages() {
  may_install || fail "may not install packages; as root: apt-get install $*"
  apt update
  apt install --no-install-recommends "$@"
}

stamp="$root/.venv/requirements.sha256"
wanted_stamp() { sha256sum <"$root/scripts/requirements.txt"; }

python_is_complete() {
  [[ -x $python && -f $stamp && "$(<"$stamp")" == "$(wanted_stamp)" ]]
}

install_python_packages() {
  /usr/bin/python3 -m venv --clear "$root/.venv"
  "$python" -m pip install --quiet --disable-pip-version-check --no-deps -r "$root/scripts/requirements.txt"
  "$python" -m pip check
  wanted_stamp >"$stamp"
}

command -v dpkg-query >/dev/null || fail "no dpkg-query: this script knows Debian only"
complete=yes

heading "Debian packages"
mapfile -t missing < <(missing_packages)
if ((${#missing[@]})); then
  echo "Missing Debian packages: ${missing[*]}"
  if [[ $check_only == yes ]]; then complete=no; else install_packages "${missing[@]}"; fi
else
  echo "All Debian packages are there."
fi

heading "Python environment"
if python_is_complete; then
  echo "$root/.venv is up to date."
else
  echo "$root/.venv is not what scripts/requirements.txt asks for."
  if [[ $check_only == yes ]]; then complete=no; else install_python_packages; fi
fi

[[ $complete == yes ]]

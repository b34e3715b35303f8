#!/usr/bin/env bash
# Installs the Debian packages of tools/packages.txt that are missing.
# usage: tools/install_packages.sh [--list] demo|test
set -euo pipefail
list_file="$(dirname "${BASH_SOURCE[0]}")/packages.txt"

usage() {
    echo "usage: tools/install_packages.sh [--list] demo|test   (--list: print the missing ones only)"
}

# packages_of SECTION: the packages of this section and of those before it.
packages_of() {
    awk -v wanted="[$1]" '
        /^#/ || NF == 0 { next }
        /^\[/ { if (found) exit; if ($1 == wanted) found = 1; next }
        { print $1 }
    ' "$list_file"
}

is_installed() {
    [[ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" == installed ]]
}

# stop REASON: what cannot be done here, and what to install by hand.
stop() {
    echo "install_packages: $1" >&2
    echo "Install these packages (Debian 12 names) by hand, then run the script again with" >&2
    echo "--no-install:" >&2
    printf '%s\n' "${missing[*]}" | fold -s -w 96 | sed 's/^/  /' >&2
    exit 1
}

list_only=no
if [[ "${1:-}" == --list ]]; then
    list_only=yes
    shift
fi
section="${1:-}"
if [[ $# -ne 1 || ! "$section" =~ ^(demo|test)$ ]]; then
    usage >&2
    exit 2
fi

mapfile -t wanted < <(packages_of "$section")
missing=()
if command -v dpkg-query >/dev/null && command -v apt-get >/dev/null; then
    for package in "${wanted[@]}"; do
        is_installed "$package" || missing+=("$package")
    done
else
    missing=("${wanted[@]}")
    [[ $list_only == yes ]] || stop "this system has no apt-get: zonegrid is set up for Debian 12"
fi

if [[ $list_only == yes ]]; then
    [[ ${#missing[@]} -eq 0 ]] || printf '%s\n' "${missing[@]}"
    exit 0
fi
[[ ${#missing[@]} -gt 0 ]] || exit 0

as_root=()
if [[ "$(id -u)" -ne 0 ]]; then
    command -v sudo >/dev/null || stop "installing needs root, and there is no sudo here"
    as_root=(sudo)
    if [[ ! -t 0 ]]; then
        as_root=(sudo -n)
        sudo -n true 2>/dev/null || stop "installing needs root, and sudo asks for a password"
    fi
fi

echo "Installing ${#missing[@]} Debian packages and what they depend on:"
printf '%s\n' "${missing[*]}" | fold -s -w 96 | sed 's/^/  /'
log="$(mktemp)"
trap 'rm -f "$log"' EXIT
apt() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y \
        -o DPkg::Lock::Timeout=300 -o Acquire::Retries=3 "$@" >>"$log" 2>&1 </dev/null
}
# An outdated package list is the usual reason for a failure, so it is renewed first; a foreign source
# that cannot be reached does no harm as long as the packages are found.
apt update || true
if ! apt install --no-install-recommends "${missing[@]}"; then
    tail -n 20 "$log" >&2
    stop "apt-get failed, see above"
fi

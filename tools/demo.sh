#!/usr/bin/env bash
# From a fresh Debian 12 to pictures: installs what is missing, builds the command and maps the
# shipped recording. Safe to run again: a second run only maps.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

recording=data/rgbd_dataset_freiburg1_xyz_cut
output=out/demo
build=build/release

usage() {
    echo "usage: tools/demo.sh [--no-install]"
    echo "Installs the Debian packages that are missing, builds $build/zonegrid, maps"
    echo "$recording and draws the map's height profile."
    echo "  --no-install   take the machine as it is"
}

# quietly WHAT COMMAND...: says WHAT, and shows what COMMAND printed only if it fails.
quietly() {
    local what="$1" log
    shift
    log="$(mktemp)"
    echo "$what"
    if ! "$@" >"$log" 2>&1 </dev/null; then
        cat "$log" >&2
        rm -f "$log"
        echo "demo: failed while $what; see above" >&2
        exit 1
    fi
    rm -f "$log"
}

case "${1:-}" in
    "") tools/install_packages.sh demo ;;
    --no-install) ;;
    -h | --help)
        usage
        exit 0
        ;;
    *)
        echo "demo: unknown option $1" >&2
        usage >&2
        exit 2
        ;;
esac

if [[ ! -d "$recording" ]]; then
    echo "demo: $recording is missing; take a complete copy of the repository" >&2
    exit 1
fi

# A build folder that exists keeps its settings; a new one is set up for the command alone, so that
# the test libraries need not be there. `cmake --preset release` turns tests and benchmarks on again.
if [[ ! -f "$build/build.ninja" ]]; then
    quietly "configuring $build" \
        cmake --preset release -DZONEGRID_TESTS=OFF -DZONEGRID_BENCH=OFF
fi
quietly "building $build/zonegrid (a few minutes the first time)" \
    cmake --build "$build" --target zonegrid_command
mkdir -p "$(dirname "$output")"

"$build/zonegrid" map "$recording" --cell 0.05 -o "$output" --overwrite

echo "The height profile of the map:"
for picture in profile.png profile_3d.png; do
    if [[ ! -s "$output/$picture" ]]; then
        echo "demo: zonegrid wrote no $output/$picture" >&2
        exit 1
    fi
    echo "  $output/$picture"
done

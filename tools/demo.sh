#!/usr/bin/env bash
# From a fresh Debian 12 to pictures: installs what is missing, builds the command, maps the shipped
# recordings and judges the map of the simulated one. Safe to run again: a second run only maps.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

desk=data/rgbd_dataset_freiburg1_xyz_cut
slalom=data/slalom
output=out/demo
build=build/release

usage() {
    echo "usage: tools/demo.sh [--no-install]"
    echo "Installs the Debian packages that are missing, builds $build/zonegrid, maps"
    echo "$desk and $slalom, draws the maps' height"
    echo "profiles, and judges the second map against the truth."
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

for recording in "$desk" "$slalom"; do
    if [[ ! -d "$recording" ]]; then
        echo "demo: $recording is missing; take a complete copy of the repository" >&2
        exit 1
    fi
done

# A build folder that exists keeps its settings; a new one is set up for the command alone, so that
# the test libraries need not be there. `cmake --preset release` turns tests and benchmarks on again.
if [[ ! -f "$build/build.ninja" ]]; then
    quietly "configuring $build" \
        cmake --preset release -DZONEGRID_TESTS=OFF -DZONEGRID_BENCH=OFF
fi
quietly "building $build/zonegrid (a few minutes the first time)" \
    cmake --build "$build" --target zonegrid_command
mkdir -p "$output"

# show PICTURE...: names pictures, which must be there.
show() {
    for picture in "$@"; do
        if [[ ! -s "$output/$picture" ]]; then
            echo "demo: zonegrid wrote no $output/$picture" >&2
            exit 1
        fi
        echo "  $output/$picture"
    done
}

"$build/zonegrid" map "$desk" --cell 0.05 -o "$output/desk" --overwrite
echo
"$build/zonegrid" map "$slalom" --cell 1 --model span --history -o "$output/slalom" --overwrite --quiet
"$build/zonegrid" evaluate "$output/slalom" --truth "$slalom/truth" -o "$output/slalom_judged" --overwrite

echo
echo "A desk in 5 cm cells, its height profile:"
show desk/profile.png desk/profile_3d.png
echo "A flight through a line of trees in 1 m cells, map and truth side by side:"
show slalom_judged/profiles.png slalom_judged/profiles_3d.png slalom_judged/measures.png

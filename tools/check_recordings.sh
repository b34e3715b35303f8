#!/usr/bin/env bash
# Maps every recording with every backend and compares the digests.
set -uo pipefail

usage() {
    cat <<'END_OF_USAGE'
usage: tools/check_recordings.sh BUILD DATA [BACKEND...]
Maps each recording of DATA, and the shipped slalom, whose camera alone has a baseline and so a `span` of its own, with
BUILD/zonegrid: both sensor models, three cell sizes, all images, with the reference and with each BACKEND (default:
opencl vulkan), and prints a line a map. For opencl and vulkan a quarter of an hour on two cores.
Exit status: 0 if all digests are those of the reference, 1 if one differs or a map fails, 2 for wrong usage.
END_OF_USAGE
}

if [[ $# -lt 2 ]]; then
    usage >&2
    exit 2
fi
build="$1" data="$2"
shift 2
backends=("$@")
[[ $# -gt 0 ]] || backends=(opencl vulkan)
for tool in "$build/zonegrid" jq; do
    command -v "$tool" >/dev/null || {
        echo "check_recordings: $tool is missing; build zonegrid, and install jq" >&2
        exit 1
    }
done
shipped="$(dirname "${BASH_SOURCE[0]}")/../data/slalom"
rooms=("$data/rgbd_dataset_freiburg1_xyz" "$data/7scenes_redkitchen/data")
outside=("$data/rgbd_dataset_freiburg2_pioneer_slam2" "$data/2011_09_26_drive_0005_sync"
    "$data/gtsam_points_lidar/kitti_07_dump" "$shipped")
for recording in "${rooms[@]}" "${outside[@]}"; do
    [[ -d "$recording" ]] || {
        echo "check_recordings: $recording is missing; name the folder that holds the recordings" >&2
        exit 1
    }
done
scratch="$(mktemp -d)"
trap 'rm -rf "$scratch"' EXIT

# digests BACKEND RECORDING OPTION...: number of images, digests of cells and of objects.
digests() {
    local backend="$1" recording="$2"
    shift 2
    "$build/zonegrid" map "$recording" -o "$scratch/map" --overwrite --quiet --backend "$backend" "$@" >/dev/null &&
        jq -r '"\(.recording.frames) \(.digest.cells) \(.digest.objects)"' "$scratch/map/report.json"
}

maps=0 wrong=0

# compare RECORDING CELL MODEL: one line for the reference and all backends.
compare() {
    local recording="$1" cell="$2" model="$3" backend expected actual images cells objects
    expected="$(digests reference "$recording" --cell "$cell" --model "$model")"
    read -r images cells objects <<<"$expected"
    printf '%-38s %5s m %s %4s images  cells %.12s  objects %.12s ' \
        "$(basename "${recording%/data}")" "$cell" "$model" "$images" "$cells" "$objects"
    for backend in "${backends[@]}"; do
        maps=$((maps + 1))
        actual="$(digests "$backend" "$recording" --cell "$cell" --model "$model")"
        if [[ -n "$expected" && "$actual" == "$expected" ]]; then
            printf ' %s equal' "$backend"
        else
            wrong=$((wrong + 1))
            printf ' %s DIFFERS (%s)' "$backend" "${actual:-no map}"
        fi
    done
    echo
}

for model in line span; do
    for cell in 0.2 0.1 0.05; do
        for recording in "${rooms[@]}"; do compare "$recording" "$cell" "$model"; done
    done
    for cell in 1.0 0.5 0.25; do
        for recording in "${outside[@]}"; do compare "$recording" "$cell" "$model"; done
    done
done
echo "$maps maps compared with the reference's, $wrong differ or failed"
[[ $wrong -eq 0 ]]

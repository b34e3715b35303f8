#!/usr/bin/env bash
# Runs a few cases of each kernel in the simulator oclgrind, as on a device with work-groups of 64 items
# and 16 KiB of local memory: any data race, access outside a buffer or wrong call is a failure.
# usage: tools/check_opencl_kernels.sh BUILD_FOLDER
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
build="${1:?usage: tools/check_opencl_kernels.sh BUILD_FOLDER}"
export ZONEGRID_OPENCL_LIBRARY="${ZONEGRID_OCLGRIND_LIBRARY:-/usr/lib/oclgrind/liboclgrind-rt.so}"
export ZONEGRID_TEST_CASES="${ZONEGRID_TEST_CASES:-8}"
export ZONEGRID_CACHE_DIR= # the simulator compiles each time
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT

if ! command -v oclgrind >/dev/null; then
    echo "check_opencl_kernels: oclgrind is missing (Debian: oclgrind)" >&2
    exit 1
fi

# simulate BUILD_OPTIONS FILTER: its messages are in $folder/messages.
simulate() {
    oclgrind --local-mem-size 16384 --max-wgsize 64 --data-races --check-api --max-errors 20 \
        --log "$folder/messages" --build-options "$1" \
        "$build/tests/ops_tests" --gtest_filter="$2" >"$folder/output" 2>&1
}

# The simulator must see the race that is known, or its silence means nothing.
simulate "" '*IntegrateScanOn*/opencl'
if ! grep -q 'data race' "$folder/messages"; then
    tail -n 20 "$folder/output"
    echo "check_opencl_kernels: oclgrind overlooks the race that mark() is known for" >&2
    exit 1
fi

passed=0
for kernels in DrawObjectsOn FuseLocalMapOn IntegrateScanOn IntegrateImageOn LabelComponentsOn \
    MeasureObjectsOn EncodeOctreeOn EncodePrismOn ProfileHeightsOn; do
    simulate "-D ZG_ATOMIC_READS" "*${kernels}*/opencl:-*AtRealSizes*"
    status=$?
    grep '^\[==========\] .* ran\.' "$folder/output"
    if [[ $status -ne 0 || -s "$folder/messages" ]]; then
        tail -n 20 "$folder/output"
        head -n 60 "$folder/messages"
        echo "check_opencl_kernels: $kernels" >&2
        passed=1
    fi
done
exit "$passed"

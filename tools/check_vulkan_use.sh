#!/usr/bin/env bash
# Runs Vulkan's tests under its validation layer: core checks, synchronisation, and shaders that reach
# outside their buffers. Any message is a failure; so is a layer that overlooks a mistake made on purpose.
# usage: tools/check_vulkan_use.sh BUILD_FOLDER [--all]   (--all: every case, not only the short ones)
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1
build="${1:?usage: tools/check_vulkan_use.sh BUILD_FOLDER [--all]}"

folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
export VK_INSTANCE_LAYERS=VK_LAYER_KHRONOS_validation VK_LAYER_SETTINGS_PATH="$folder"

# write_to FILE: where the layer writes; it begins a file anew for each instance, but stdout goes on.
write_to() {
    cat >"$folder/vk_layer_settings.txt" <<END_OF_SETTINGS
khronos_validation.enables = VK_VALIDATION_FEATURE_ENABLE_SYNCHRONIZATION_VALIDATION_EXT,VK_VALIDATION_FEATURE_ENABLE_GPU_ASSISTED_EXT
khronos_validation.report_flags = error,warn,perf
khronos_validation.debug_action = VK_DBG_LAYER_ACTION_LOG_MSG
khronos_validation.log_filename = $1
END_OF_SETTINGS
}

write_to "$folder/messages"
if ! ZONEGRID_VALIDATION_LOG="$folder/messages" "$build/tests/device_tests" \
    --gtest_filter='ValidationLayer.*' >"$folder/layer" 2>&1; then
    cat "$folder/layer"
    echo "check_vulkan_use: the validation layer is missing or does not check (Debian: vulkan-validationlayers)" >&2
    exit 1
fi

# run_quietly PROGRAM FILTER: fails if a test fails or the layer says anything.
run_quietly() {
    local output="$folder/$1" messages
    "$build/tests/$1" --gtest_filter="$2" >"$output" 2>&1 || { tail -n 40 "$output" && return 1; }
    grep '^\[==========\] .* ran\.' "$output"
    messages="$(grep -cE 'VUID-|UNASSIGNED-|SYNC-HAZARD|Validation (Error|Warning|Performance)' "$output")"
    if [[ "$messages" -ne 0 ]]; then
        grep -E 'VUID-|UNASSIGNED-|SYNC-HAZARD|Validation (Error|Warning|Performance)' "$output" |
            cut -c 1-1000 | sort | uniq -c | sort -rn | head -n 10
        echo "check_vulkan_use: $messages messages from $1" >&2
        return 1
    fi
}

write_to stdout
passed=0
if [[ "${2:-}" != --all ]]; then
    export ZONEGRID_TEST_CASES=20
fi
for program in device_tests ops_tests pipeline_tests; do
    run_quietly "$program" '*/vulkan:-*AtRealSizes*' || passed=1
done
if [[ "${2:-}" == --all ]]; then
    run_quietly ops_tests '*AtRealSizes*/vulkan' || passed=1
fi
exit "$passed"

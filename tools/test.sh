#!/usr/bin/env bash
# Everything that must hold before a change lands; CI runs this script and nothing else.
set -uo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.." || exit 1

usage() {
    cat <<'END'
usage: tools/test.sh [--quick | --all] [--long] [--tidy | --tidy-all] [--no-install]
Installs the Debian packages that are missing, then builds with warnings as errors and runs the
tests; runs Vulkan's under its validation layer; builds and runs those of the model, the operations and
the pipeline again with the address and undefined-behaviour sanitizers; checks the formatting and the scripts.
  --quick        build and test only, without sanitizers and checks of the sources
  --all          every test with those sanitizers, and the pipeline's with the thread sanitizer; every
                 case of Vulkan's; OpenCL's kernels, a few cases each, in the simulator oclgrind
  --long         fifty times as many generated cases on devices: 100,000 images each, half an hour
  --tidy         run clang-tidy too, over what decides cells: some ten minutes
  --tidy-all     the same over all of host/ and tools/: about an hour
  --no-install   take the machine as it is
Exit status: 0 if every stage passed, 1 if one failed, 2 for a wrong option.
END
}

quick=no all=no tidy=no install=yes
tidy_folders='^\./host/(model|reference|pipeline|device|ops)/'
for option in "$@"; do
    case "$option" in
        --quick) quick=yes ;;
        --all) all=yes ;;
        --long) export ZONEGRID_LONG_TESTS=1 ;;
        --tidy) tidy=yes ;;
        --tidy-all) tidy=yes tidy_folders='^\./(host|tools)/' ;;
        --no-install) install=no ;;
        -h | --help)
            usage
            exit 0
            ;;
        *)
            echo "test: unknown option $option" >&2
            usage >&2
            exit 2
            ;;
    esac
done

jobs=2 # as many as CI has cores
summary=()
failed=()

# stage NAME COMMAND...: runs COMMAND, notes how long it took and whether it passed.
stage() {
    local name="$1" started=$SECONDS verdict=passed
    shift
    printf '\n== %s\n' "$name"
    if ! "$@" </dev/null; then
        verdict=FAILED
        failed+=("$name")
    fi
    summary+=("$(printf '%-24s %-7s %4d s' "$name" "$verdict" $((SECONDS - started)))")
    [[ $verdict == passed ]]
}

# omit NAME REASON: notes a stage that was not run.
omit() {
    summary+=("$(printf '%-24s not run: %s' "$1" "$2")")
}

launcher=() # what starts builds, which run the test programs to list their tests, and test runs

# build PRESET [BUILD OPTION...]
build() {
    rm -f "build/$1/ctest.log"
    cmake --preset "$1" &&
        "${launcher[@]}" cmake --build --preset "$1" --parallel "$jobs" "${@:2}"
}

# run_tests PRESET [CTEST OPTION...]: the log stays in the build folder for the summary.
run_tests() {
    "${launcher[@]}" ctest --preset "$1" --parallel "$jobs" --no-tests=error "${@:2}" 2>&1 |
        tee "build/$1/ctest.log"
}

build_and_test() {
    if stage "build $1" build "$1"; then
        stage "test $1" run_tests "$1"
    else
        omit "test $1" "its build failed"
    fi
}

# What decides cells; the rest of the suite takes twice the time to build with sanitizers.
test_core_with_sanitizers() {
    build asan --target model_tests ops_tests pipeline_tests &&
        run_tests asan -R '^(model|ops|pipeline)\.'
}

# The pipeline is what an application may drive from threads of its own. The thread sanitizer cannot
# place its shadow memory under some kernels' address randomisation, so that is turned off if allowed.
test_threads() {
    local launcher=()
    if setarch "$(uname -m)" -R true 2>/dev/null; then
        launcher=(setarch "$(uname -m)" -R)
    fi
    build tsan --target pipeline_tests && run_tests tsan -R '^pipeline\.'
}

# sources PATTERN...: the project's files whose names match, one a line.
sources() {
    local names=()
    for pattern in "$@"; do
        names+=(-o -name "$pattern")
    done
    find . \( -name '.?*' -o -path ./build -o -path ./out \) -prune -o \
        -type f \( "${names[@]:1}" \) -print | sort
}

check_format() {
    sources '*.h' '*.cpp' '*.cl' '*.comp' '*.glsl' |
        xargs --no-run-if-empty -n 16 -P "$jobs" clang-format --dry-run --Werror
}

check_scripts() {
    sources '*.sh' | xargs shellcheck .ci/run
}

# Large headers (Eigen, CLI11, JSON) take clang-tidy half a minute and more a file. It cannot read the
# compiler's precompiled headers, so its commands go without.
check_tidy() {
    mkdir -p build/ci/tidy
    sed -E 's/ -Winvalid-pch//; s/ -include [^ ]*cmake_pch\.hxx//' build/ci/compile_commands.json \
        >build/ci/tidy/compile_commands.json
    sources '*.cpp' | grep -E "$tidy_folders" |
        xargs -n 1 -P "$jobs" clang-tidy-16 -p build/ci/tidy --quiet 2>&1 |
        sed '/^[0-9]* warnings* generated\.$/d'
}

export UBSAN_OPTIONS=print_stacktrace=1
if command -v ccache >/dev/null; then
    export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi

# skipped_tests PRESET: how many tests did not run, and the reasons they gave.
skipped_tests() {
    local count
    count="$(grep -c '\*\*\*Skipped' "build/$1/ctest.log")"
    [[ "$count" -gt 0 ]] || return 0
    echo "$count tests skipped themselves:"
    awk '/: Skipped$/ { getline; print }' "build/$1/Testing/Temporary/LastTest.log" |
        sort | uniq -c | sed 's/^ */  /; s/ / x /3'
}

if [[ $install == yes ]]; then
    stage "install packages" tools/install_packages.sh test || exit 1
fi
if [[ $quick == no ]]; then
    stage "format" check_format
    if command -v shellcheck >/dev/null; then
        stage "scripts" check_scripts
    else
        omit "scripts" "shellcheck is not installed"
    fi
fi
build_and_test ci
if [[ $quick == no ]]; then
    if [[ $all == yes ]]; then
        stage "use of Vulkan, all" tools/check_vulkan_use.sh build/ci --all
        stage "OpenCL in oclgrind" tools/check_opencl_kernels.sh build/ci
    else
        stage "use of Vulkan" tools/check_vulkan_use.sh build/ci
        omit "OpenCL in oclgrind" "give --all"
    fi
    if [[ $tidy == yes ]]; then
        stage "clang-tidy" check_tidy
    else
        omit "clang-tidy" "give --tidy or --tidy-all"
    fi
    if [[ $all == yes ]]; then
        build_and_test asan
        stage "build and test tsan" test_threads
    else
        stage "build and test asan" test_core_with_sanitizers
        omit "build and test tsan" "give --all"
    fi
fi

printf '\n== Summary\n'
printf '%s\n' "${summary[@]}"
[[ -f build/ci/ctest.log ]] && skipped_tests ci
if [[ ${#failed[@]} -gt 0 ]]; then
    printf 'test: failed: %s\n' "${failed[@]}"
    exit 1
fi
echo "Every stage passed in $SECONDS s; the tests of the ci build:"
grep -E 'tests passed, .* tests failed' build/ci/ctest.log

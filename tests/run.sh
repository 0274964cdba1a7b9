#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Installs what is missing, builds, and runs tests; says how long each phase took. BUILD_DIR chooses the folder (default:
# build).
#   run.sh                    all tests; those whose programs are missing (a browser, Slurm, POV-Ray ...) are skipped
#   run.sh --all              installs those programs as well; a test that is skipped counts as failed. The program as
#                             WebAssembly is built and tested if build-wasm has it from before, or em++ is there
#   run.sh --quick MODULE...  builds and runs the tests of these modules of src/ and of the modules that use them
set -euo pipefail
cd "$(dirname "$0")/.."

build=${BUILD_DIR:-build}
phases=()
begin=$(date +%s%N)
phase_began=$begin
# Ends a phase: its name.
done_with() {
    local now
    now=$(date +%s%N)
    phases+=("$(printf '%-22s %6.1f s' "$1" "$(((now - phase_began) / 1000000))e-3")")
    phase_began=$now
}
report() {
    done_with "${1:-}"
    echo
    printf '%s\n' "${phases[@]}"
    printf '%-22s %6.1f s\n' total "$((($(date +%s%N) - begin) / 1000000))e-3"
}

# The modules that are named, and those whose line in CMakeLists.txt uses one of them.
users_of() {
    local module
    for module in "$@"; do
        [ -d "src/$module" ] || { echo "run.sh: src/ has no module \`$module\`" >&2; exit 2; }
        echo "$module"
        sed -n "s/^add_module(\([a-z]*\) .*USES\([^)]*\).*/\1 \2 /p" CMakeLists.txt | sed 's/ WITH .*/ /' |
            awk -v used="$module" 'index($0 " ", " " used " ") { print $1 }'
    done | sort -u
}

quick() {
    [ $# -gt 0 ] || { echo "run.sh: --quick needs the name of a module" >&2; exit 2; }
    local chosen targets=() label=
    chosen=$(users_of "$@")
    for module in $chosen; do
        [ -d "tests/$module" ] && targets+=("test_$module") label="$label|$module"
    done
    [ -e "$build/build.ninja" ] || cmake -S . -B "$build" -G Ninja -DCANDELABRA_TESTS=ON
    cmake --build "$build" --target "${targets[@]}"
    done_with build
    ctest --test-dir "$build" --output-on-failure --parallel "$(nproc)" --label-regex "^(${label#|})\$" || failed=1
    report tests
    exit "${failed:-0}"
}

case ${1:-} in
    "" | --all) ;;
    --quick) quick "${@:2}" ;;
    *) echo "run.sh: there is no \`$1\`; see the head of the script" >&2; exit 2 ;;
esac

tests/install_packages.sh "$@"
done_with install
wasm=
if [ "${1:-}" = --all ] && { [ -e build-wasm/candelabra.wasm ] || command -v em++ > /dev/null; }; then
    wasm=$PWD/build-wasm
fi
cmake -S . -B "$build" -G Ninja -DCANDELABRA_TESTS=ON -DCANDELABRA_WASM_BUILD="$wasm"
done_with configure
cmake --build "$build" --target candelabra
done_with "build of the program"
cmake --build "$build"
done_with "build of the tests"
if [ -n "$wasm" ]; then
    { src/packaging/wasm/build.sh "$wasm" && src/packaging/npm/pack.sh "$wasm" && src/playground/pack.py "$wasm"; } || failed=1
    done_with "WebAssembly"
fi
said=$build/tests.log
# One more than processors: some tests wait for others' programs.
ctest --test-dir "$build" --output-on-failure --parallel "$(($(nproc) + 1))" 2>&1 | tee "$said" || failed=1

echo
echo "slowest tests (seconds):"
sed -n 's/^ *[0-9]*\/[0-9]* Test *#[0-9]*: \(.*[^ .]\) \.\.\.*.* \([0-9.]*\) sec.*/\2 \1/p' "$said" | sort -rn | head -20 || true
echo "slowest sources (seconds):"
awk -F'\t' '$4 ~ /\.o$/ { printf "%.1f %s\n", ($2 - $1) / 1000, $4 }' "$build/.ninja_log" | sort -rn | head -20 || true
report tests

if [ "${1:-}" = --all ] && [ -z "$wasm" ]; then
    echo "not tested: WebAssembly, which src/packaging/wasm/build.sh builds"
fi
if [ "${1:-}" = --all ] && grep -q '\*\*\*Skipped' "$said"; then
    echo "tests were skipped:"
    grep '\*\*\*Skipped' "$said"
    failed=1
fi
exit "${failed:-0}"

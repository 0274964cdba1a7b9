#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes all that reads with clang's libFuzzer and sanitizers, each for some seconds: tests/fuzz/run.sh [SECONDS [TARGET...]].
# What was found lies in build-fuzz/found, what was learnt in build-fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/../.."

seconds=${1:-60}
all=(lexer parser evaluate scene http lsp data photometry road ini options relight picture mesh model density font state develop)
targets=("${@:2}")
[ ${#targets[@]} -gt 0 ] || targets=("${all[@]}")
build=${BUILD_DIR:-build-fuzz}
cmake -S . -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
      -DCANDELABRA_TESTS=OFF -DCANDELABRA_FUZZ=ON
cmake --build "$build" --target "${targets[@]/%/_fuzz}" fuzz_dictionary fuzz_seed_files
mkdir -p "$build/found"
for target in "${targets[@]}"; do
    corpus=$build/corpus/$target
    mkdir -p "$corpus"
    case $target in
        lexer | parser | evaluate) seeds=(tests/diagnostics examples/lights) ;;
        photometry) seeds=(tests/photometry/files) ;;
        road) seeds=(tests/meter/files) ;;
        picture | mesh | model | density | font | state | develop) seeds=("$build/tests/fuzz/seeds/$target") ;;
        *) seeds=("tests/fuzz/$target") ;;
    esac
    case $target in
        lexer | parser | evaluate | scene) words=$build/tests/fuzz/words.dict ;;
        picture | mesh | model | density | font | state) words=tests/fuzz/files.dict ;;
        road) words=tests/fuzz/data.dict ;;
        *) words=tests/fuzz/$target.dict ;;
    esac
    # The program itself leaks nothing that grows; looking for leaks costs half of the speed, and keeping the stacks of all
    # allocations a quarter.
    ASAN_OPTIONS=detect_leaks=0:malloc_context_size=3:quarantine_size_mb=32 \
        "$build/tests/fuzz/${target}_fuzz" "$corpus" "${seeds[@]}" \
        -dict="$words" -max_total_time="$seconds" -max_len=4000 -timeout=20 \
        -rss_limit_mb=2500 -artifact_prefix="$build/found/$target-" -print_final_stats=1
done

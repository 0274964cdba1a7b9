#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Fuzzes all that reads with clang's libFuzzer and sanitizers, each for some seconds: tests/fuzz/run.sh [SECONDS]. What was
# found lies in build-fuzz/found, what was learnt in build-fuzz/corpus.
set -euo pipefail
cd "$(dirname "$0")/../.."

seconds=${1:-60}
build=${BUILD_DIR:-build-fuzz}
cmake -S . -B "$build" -G Ninja -DCMAKE_CXX_COMPILER=clang++ -DCMAKE_BUILD_TYPE=RelWithDebInfo \
      -DCANDELABRA_TESTS=OFF -DCANDELABRA_FUZZ=ON
cmake --build "$build" --target lexer_fuzz parser_fuzz evaluate_fuzz fuzz_dictionary http_fuzz lsp_fuzz data_fuzz \
      ini_fuzz scene_fuzz picture_fuzz mesh_fuzz density_fuzz font_fuzz state_fuzz fuzz_seed_files
mkdir -p "$build/found"
for target in lexer parser evaluate http lsp data ini scene; do
    corpus=$build/corpus/$target
    seeds=(tests/diagnostics examples/lights)
    words=$build/tests/fuzz/words.dict
    if [ -d "tests/fuzz/$target" ]; then
        seeds=("tests/fuzz/$target")
        [ -f "tests/fuzz/$target.dict" ] && words=tests/fuzz/$target.dict
    fi
    mkdir -p "$corpus"
    # The program itself leaks nothing that grows; looking for leaks costs half of the speed.
    ASAN_OPTIONS=detect_leaks=0 "$build/tests/fuzz/${target}_fuzz" "$corpus" "${seeds[@]}" \
        -dict="$words" -max_total_time="$seconds" -max_len=4000 -timeout=20 \
        -rss_limit_mb=2500 -artifact_prefix="$build/found/$target-" -print_final_stats=1
done
for target in picture mesh density font state; do
    corpus=$build/corpus/$target
    mkdir -p "$corpus"
    ASAN_OPTIONS=detect_leaks=0 "$build/tests/fuzz/${target}_fuzz" "$corpus" "$build/tests/fuzz/seeds/$target" \
        -dict=tests/fuzz/files.dict -max_total_time="$seconds" -max_len=4000 -timeout=20 \
        -rss_limit_mb=2500 -artifact_prefix="$build/found/$target-" -print_final_stats=1
done

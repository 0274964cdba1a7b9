// SPDX-License-Identifier: GPL-3.0-or-later
// The function runs where it is called: the engine sets the size of the stack when it starts a
// worker, and the worker tells it (library.js). What the engine keeps on its own stack cannot be
// measured, so a part of the stack in memory stands for it.
#include "base/deep_stack.h"

#include <emscripten/stack.h>

#include <algorithm>

extern "C" std::size_t candelabra_stack_bytes();

namespace candelabra {

void on_deep_stack(std::size_t bytes, FunctionRef<void(std::size_t)> function) {
    // A byte here comes with up to five on the engine's stack, as trials of nested macros, blocks
    // and expressions have shown.
    constexpr std::size_t engine_share = 6;
    const std::size_t used = emscripten_stack_get_base() - emscripten_stack_get_current();
    const std::size_t most = std::min(candelabra_stack_bytes() / engine_share,
                                      emscripten_stack_get_base() - emscripten_stack_get_end());
    function(std::min(bytes, most - std::min(used, most)));
}

std::uint64_t memory_of_deep_stack(std::size_t) { return 0; }  // it is there from the beginning

}  // namespace candelabra

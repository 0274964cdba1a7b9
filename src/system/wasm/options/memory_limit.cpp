// SPDX-License-Identifier: GPL-3.0-or-later
// The memory grows only through emscripten_resize_heap(), which asks for the limit here.
#include "options/memory_limit.h"

#include <emscripten/heap.h>

#include <algorithm>
#include <cstddef>

extern "C" {
/// Returns the free memory of the machine in bytes, or 0 if the engine does not tell.
double candelabra_free_memory();
/// Keep and return the limit in bytes.
void candelabra_limit_memory(double bytes);
double candelabra_memory_limit();

// In the place of the library's function (-Wl,--wrap).
int __real_emscripten_resize_heap(std::size_t bytes);
int __wrap_emscripten_resize_heap(std::size_t bytes) {
    return static_cast<double>(bytes) <= candelabra_memory_limit() &&
           __real_emscripten_resize_heap(bytes) != 0;
}
}

namespace candelabra {

std::optional<std::uint64_t> physical_memory() { return emscripten_get_heap_max(); }

std::optional<std::uint64_t> usual_memory_limit(const std::string&) {
    const auto free = static_cast<std::uint64_t>(candelabra_free_memory());
    if (free == 0) return std::nullopt;
    return std::min<std::uint64_t>(free / 2, emscripten_get_heap_max());
}

std::uint64_t memory_in_use() { return emscripten_get_heap_size(); }

bool may_double(std::uint64_t, std::optional<std::uint64_t>) {
    return false;  // nothing runs beside anything
}

void limit_memory(std::uint64_t bytes) { candelabra_limit_memory(static_cast<double>(bytes)); }

}  // namespace candelabra

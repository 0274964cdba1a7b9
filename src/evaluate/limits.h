// SPDX-License-Identifier: GPL-3.0-or-later
// How far evaluation goes before it takes a scene for a mistake. Each limit has a diagnostic that
// names it.
#pragma once

#include <cstddef>
#include <cstdint>

struct Limits {
    std::size_t call_depth = 200'000;          ///< macro calls inside each other
    std::size_t include_depth = 100;           ///< include files inside each other
    std::uint64_t loop_passes = 100'000'000;   ///< of one loop
    std::size_t array_elements = 100'000'000;  ///< of one array
    std::size_t stack_bytes = std::size_t{1} << 30;
};

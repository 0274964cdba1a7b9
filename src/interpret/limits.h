// SPDX-License-Identifier: GPL-3.0-or-later
// Limits of evaluation, beyond which a scene is taken for a mistake. Each limit has a diagnostic
// that names it and the option that raises it.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace candelabra {

struct Limits {
    std::size_t call_depth = 200'000;          ///< nested macro calls
    std::size_t nesting = 10'000;              ///< nested objects
    std::size_t include_depth = 100;           ///< nested include files
    std::uint64_t steps = 100'000'000;         ///< passes of loops and calls of macros, in total
    std::size_t array_elements = 100'000'000;  ///< of one array
    std::uint64_t objects = 20'000'000;        ///< in total, including parts of unions
    std::uint64_t written_bytes = std::uint64_t{1} << 30;  ///< by #write, in all files together
    std::uint64_t files = 100'000;                       ///< included or opened, counted each time
    std::uint64_t said_bytes = std::uint64_t{64} << 20;  ///< by #debug and other messages
    std::uint64_t text_bytes = std::uint64_t{64} << 20;  ///< of one string
    std::uint64_t function_steps = 10'000'000;           ///< of one call, each loop run once
    /// Steps of work of any kind, in total; some nanoseconds each.
    std::uint64_t work = 4'000'000'000;
    /// Size of the reserved stack, which is hardly ever used up.
    std::size_t stack_bytes = std::size_t{1} << 30;

    /// Whether no limit is higher than in `most`.
    bool within(const Limits& most) const {
        return call_depth <= most.call_depth && nesting <= most.nesting &&
               include_depth <= most.include_depth && steps <= most.steps &&
               array_elements <= most.array_elements && objects <= most.objects &&
               written_bytes <= most.written_bytes && files <= most.files &&
               said_bytes <= most.said_bytes && text_bytes <= most.text_bytes &&
               function_steps <= most.function_steps && work <= most.work &&
               stack_bytes <= most.stack_bytes;
    }

    /// Makes the stack big enough for the allowed depths.
    void make_room() {
        constexpr std::size_t each_call = 5'000, each_object = 10'000;
        stack_bytes = std::max(stack_bytes, call_depth * each_call + nesting * each_object);
    }
};

}  // namespace candelabra

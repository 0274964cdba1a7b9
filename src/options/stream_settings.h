// SPDX-License-Identifier: GPL-3.0-or-later
// The program's output by kind, as POV-Ray divides it, and where each kind goes.
#pragma once

#include <array>
#include <cstddef>
#include <string>

namespace candelabra {

enum class Stream {
    debug,       ///< output of the scene
    fatal,       ///< errors
    render,      ///< progress
    statistics,  ///< the summary
    warning,
};
inline constexpr std::size_t stream_count = 5;

struct StreamSettings {
    struct One {
        bool shown = true;  ///< on the console
        std::string file;   ///< empty: none
    };
    std::array<One, stream_count> all;

    One& operator[](Stream stream) { return all[static_cast<std::size_t>(stream)]; }
    const One& operator[](Stream stream) const { return all[static_cast<std::size_t>(stream)]; }
};

}  // namespace candelabra

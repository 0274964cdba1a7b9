// SPDX-License-Identifier: GPL-3.0-or-later
// What a run says, by kind, for front ends other than the terminal. All messages of diagnostics and
// of the scene go through say() (console/console.h), which passes them on to Console::heard.
#pragma once

#include "options/stream_settings.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

struct Heard {
    std::string errors;                 ///< one behind the other
    std::vector<std::string> warnings;  ///< each with its excerpt; the first most_warnings
    std::size_t more_warnings = 0;      ///< beyond these
    std::string said;                   ///< by the scene; the last most_said bytes

    /// `plain`: without colours. Progress and statistics are passed over.
    void take(Stream, std::string_view plain);
};

inline constexpr std::size_t most_warnings = 100;
inline constexpr std::size_t most_said = std::size_t{1} << 16;

}  // namespace candelabra

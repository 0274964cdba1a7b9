// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a scene that is being edited in a separate process: a scene that takes too long or too
// much memory, or crashes, ends that process and not the language server.
#pragma once

#include "editor/problems.h"

#include <cstdint>

namespace candelabra {

struct CheckLimits {
    int milliseconds = 10'000;
    std::uint64_t bytes = std::uint64_t{1} << 31;  ///< besides the stack
};

/// Returns the problems of an open file in the form of problems(). An exceeded limit is a problem
/// at the top of the file.
std::map<std::string, std::vector<Json>> check(const Workspace&, const std::string& path,
                                               const std::string& folder_for_writing,
                                               const CheckLimits&);

}  // namespace candelabra

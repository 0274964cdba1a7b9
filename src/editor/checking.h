// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a scene that is being edited in a separate process: a scene that takes too long or too
// much memory, or crashes, ends that process and not the language server.
#pragma once

#include "editor/problems.h"

#include <cstdint>
#include <functional>

namespace candelabra {

struct CheckLimits {
    int milliseconds = 10'000;
    std::uint64_t bytes = std::uint64_t{1} << 31;  ///< besides the stack
};

/// What is done while a check runs: serve() is called when the file descriptor (below 0: none) can
/// be read. The check ends without a result if it returns false.
struct Meanwhile {
    int descriptor = -1;
    std::function<bool()> serve;
};

/// Returns the problems of an open file in the form of problems(). An exceeded limit is a problem
/// at the top of the file.
std::map<std::string, std::vector<Json>> check(const Workspace&, const std::string& path,
                                               const std::string& folder_for_writing,
                                               const CheckLimits&, const Meanwhile& = {});

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// Checks a scene that is being edited in a process of its own: a scene that takes too long or too
// much memory, or brings the program down, ends that process and not the editor's help.
#pragma once

#include "editor/problems.h"

#include <cstdint>

namespace candelabra {

struct CheckLimits {
    int milliseconds = 10'000;
    std::uint64_t bytes = std::uint64_t{1} << 31;  ///< beside the room of the stack
};

/// The problems of an open file, as problems() has them. A limit that was broken is one at the top
/// of the file.
std::map<std::string, std::vector<Json>> check(const Workspace&, const std::string& path,
                                               const std::string& folder_for_writing,
                                               const CheckLimits&);

}  // namespace candelabra

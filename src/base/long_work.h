// SPDX-License-Identifier: GPL-3.0-or-later
// Counts work whose number of steps is computed beforehand, such as that of all faces of a mesh.
#pragma once

#include "base/work_watch.h"

#include <algorithm>

namespace candelabra {

/// count_work() for any number of steps. More than any work has count as many.
inline void count_long_work(std::uint64_t steps) {
    constexpr std::uint64_t most = std::uint64_t{1} << 40, at_once = std::uint64_t{1} << 31;
    steps = std::min(steps, most);
    for (; steps > at_once; steps -= at_once) count_work(at_once);
    count_work(static_cast<std::uint32_t>(steps));
}

}  // namespace candelabra

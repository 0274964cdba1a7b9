// SPDX-License-Identifier: GPL-3.0-or-later
// A scene compiled twice: with unions that are stored once, and with all of them taken apart.
#pragma once

#include "support/scripts.h"
#include "world/compile.h"

#include <limits>

namespace candelabra {

struct Twins {
    SharedWorld shared, apart;
};

inline SharedWorld world_with(const std::string& script, const InstanceLimits& limits) {
    CompileOptions options;
    options.instances = limits;
    Diagnostics diagnostics;
    return compile(scene_of(script), options, diagnostics);
}

inline Twins twins_of(const std::string& script) {
    constexpr std::size_t most = std::numeric_limits<std::size_t>::max();
    return {world_with(script, {2, most, 2}), world_with(script, {most, most, most})};
}

}  // namespace candelabra

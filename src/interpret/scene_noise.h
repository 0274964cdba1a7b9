// SPDX-License-Identifier: GPL-3.0-or-later
// The noise generator of functions that name none (f_noise3d, patterns and pigments in functions).
// It is the scene's at the time of the call: what `global_settings` has said by then, else what
// the language version in force has. Shared by the evaluator, which changes it while it reads, and
// by the functions, which also live while the picture is made.
#pragma once

#include "base/noise.h"

#include <optional>

namespace candelabra {

struct SceneNoise {
    double version = 3.7;
    std::optional<NoiseGenerator> given;

    NoiseGenerator generator() const {
        if (given) return *given;
        return version < 3.5 ? NoiseGenerator::original : NoiseGenerator::full_range;
    }
};

}  // namespace candelabra

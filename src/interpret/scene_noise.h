// SPDX-License-Identifier: GPL-3.0-or-later
// The noise generator of functions that name none (f_noise3d, patterns and pigments in functions).
// It is the scene's at the time of the call: the one that `global_settings` has set by then, else
// that of the current language version. Shared by the evaluator, which changes it while it reads,
// and by the functions, which are also called during rendering.
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

// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes and worlds from the text of a script or an example's file, for tests and benchmarks.
#pragma once

#include "interpret/value.h"
#include "lighting/settings.h"
#include "scene/scene.h"
#include "text/diagnostic.h"
#include "world/shot.h"

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

using Declares = std::vector<std::pair<std::string, std::variant<double, std::string, Numbers>>>;

/// The scene of a script, with its diagnostics as one text (empty when there are none).
struct Evaluated {
    Scene scene;
    std::string diagnostics;
    bool failed = false;
    std::string printed;  ///< what #debug said
};
Evaluated evaluated(const std::string& script, const Declares& = {});

/// Throw std::runtime_error with the diagnostics when the script has an error.
Scene scene_of(const std::string& script);
SharedWorld world_of(const std::string& script, const std::optional<RayIndex>& = {});
SharedWorld world_of(const Scene&, const LightSampler&);
/// The view that the scene states.
Shot shot_of(const std::string& script);
Scene scene_of_file(const std::string& path_below_source, const Declares&);
SharedWorld world_of_file(const std::string& path_below_source, const Declares&,
                          const std::optional<LightSampler>&);
/// For a square picture of that size.
Shot shot_of_file(const std::string& path_below_source, const Declares&,
                  const std::optional<LightSampler>&, int size = 320);
/// The view that the scene states, in a square picture of that size.
Shot square_shot(SharedWorld, int size);

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// The places in a cell from which its survey looks around: where light may arrive that the viewer
// sees. Deterministic.
#pragma once

#include "base/box.h"
#include "lighting/probe.h"
#include "luminaire/luminaire.h"

#include <optional>
#include <span>
#include <vector>

namespace candelabra {

/// A place in a cell where light may arrive.
struct SurveyPlace {
    Receiver point;
    double tolerance = 0;
};

/// From where most points to be lit are seen; neither: not known.
struct Viewer {
    std::optional<Vec3> eye = {};
    std::optional<Ray> axis = {};  ///< see LightScene

    /// The ray of the camera that leads to a place.
    std::optional<Ray> ray_to(const Vec3& place) const;
};

/// Returns places on the surfaces in a cell or, if none are found, anywhere in it. If the viewer
/// sees some of these places, only those: there may be sunshine on the other side of a wall.
std::vector<SurveyPlace> survey_places_in(const Box& cell, const Viewer&, const LightProbe&);

/// Returns places anywhere in a cell, between surfaces.
std::vector<SurveyPlace> air_places_in(const Box& cell, const Viewer&, const LightProbe&);

/// Returns factors on the light that arrives at several places, for averages over these: none
/// counts much more than the place with the least light. Otherwise light on a few places would
/// attract the rays of all.
std::vector<double> balanced(std::span<const double> arriving);

}  // namespace candelabra

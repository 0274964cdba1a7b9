// SPDX-License-Identifier: GPL-3.0-or-later
// The light of the sky in a cell, as rays that are traced when the cell is made find it, and the
// choice between the sky and all other lights.
#pragma once

#include "lighting/choosable_lights.h"

#include <array>
#include <optional>
#include <span>
#include <vector>

namespace candelabra {

/// Light of some origin at a point, as draws of it find it: the mean irradiance, and the root of
/// the mean square of one draw.
struct DrawnLight {
    double mean = 0, root = 0;
};

/// A ray from a place of a survey, past all surfaces, to the sky.
struct SkyRay {
    const SurveyPlace* from;
    Vec3 direction;
    double luminance;  ///< that arrives
    double chance;     ///< density of its direction per steradian, times the number of all rays
};

/// The light of the sky in a cell.
class SkySurvey {
public:
    SkySurvey() = default;
    /// Made of rays, those without light left out.
    SkySurvey(const ChoosableSky&, std::span<const SkyRay>);

    DrawnLight at(const Receiver&) const;
    /// At the places of the survey.
    DrawnLight there() const { return {mean_, root_}; }

    /// The brighter one of both, as either may have missed most of the light.
    friend SkySurvey brighter(const SkySurvey&, const SkySurvey&);

private:
    /// Irradiance of surfaces that face along x, against x, and so on for y and z.
    std::array<double, 6> facing_{};
    double mean_ = 0, root_ = 0;
};

/// Rays that are drawn as direct light draws directions to the sky: as one draw among all light
/// does, once it goes to the sky.
std::vector<SkyRay> rays_to_sky(const ChoosableSky&, std::span<const SurveyPlace>,
                                const LightProbe&);

/// One draw among all light.
struct SharedDraw {
    double sky = 0;    ///< fraction of the draws that go to the sky
    double mean = 0;   ///< irradiance
    double noise = 0;  ///< variance over squared mean
};

/// The fractions that make the least noise, within bounds. `lamps`: other lights, if any may light
/// the point.
SharedDraw shared_draw(const DrawnLight& sky, const std::optional<DrawnLight>& lamps);

}  // namespace candelabra

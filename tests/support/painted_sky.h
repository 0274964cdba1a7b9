// SPDX-License-Identifier: GPL-3.0-or-later
// A sky that is brighter above, and lights for a strategy to choose among besides it.
#pragma once

#include "base/circle.h"
#include "world/luminaire_choices.h"

#include <memory>
#include <numbers>
#include <span>

namespace candelabra {

class PaintedSky final : public ChoosableSky {
public:
    double luminance(const Vec3& direction) const override { return 2 + direction.y; }
    double brightest() const override { return 3; }
    Vec3 draw(const Vec2& u) const override { return at_height(1 - 2 * u.x, u.y); }
    double density(const Vec3&) const override { return 1 / (4 * std::numbers::pi); }
};

/// The luminaires must outlive the result.
inline std::shared_ptr<const ChoosableLights> choices_under_sky(
    std::span<const Luminaire> luminaires) {
    return std::make_shared<LuminaireChoices>(luminaires, std::span<const Vec3>(),
                                              std::make_unique<PaintedSky>());
}

}  // namespace candelabra

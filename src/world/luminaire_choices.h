// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires as a light strategy chooses among them.
#pragma once

#include "lighting/choosable_lights.h"
#include "luminaire/luminaire.h"

#include <span>

namespace candelabra {

/// The luminaires must outlive this.
class LuminaireChoices final : public ChoosableLights {
public:
    explicit LuminaireChoices(std::span<const Luminaire> luminaires) : luminaires_(luminaires) {}

    std::size_t size() const override { return luminaires_.size(); }
    LightBounds bounds(LightIndex light) const override {
        return candelabra::bounds(luminaires_[light]);
    }
    bool has_surface(LightIndex light) const override { return !luminaires_[light].is_volume(); }
    bool exact_nearby(LightIndex) const override;
    double unoccluded(LightIndex light, const Receiver& point) const override {
        return candelabra::unoccluded(luminaires_[light], point);
    }
    double arriving(LightIndex, const SurveyPlace&, const Vec2& u,
                    const LightProbe&) const override;

private:
    std::span<const Luminaire> luminaires_;
};

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires, and the sky beside them, as a light strategy chooses among them.
#pragma once

#include "lighting/choosable_lights.h"
#include "luminaire/luminaire.h"

#include <memory>
#include <span>
#include <utility>

namespace candelabra {

/// The luminaires and their bent normals must outlive this.
class LuminaireChoices final : public ChoosableLights {
public:
    /// `bent_normals`: of each luminaire (world/bent_normals.h); empty: none has one. `sky`: chosen
    /// besides; null: none.
    explicit LuminaireChoices(std::span<const Luminaire> luminaires,
                              std::span<const Vec3> bent_normals = {},
                              std::unique_ptr<const ChoosableSky> sky = nullptr)
        : luminaires_(luminaires), bent_normals_(bent_normals), sky_(std::move(sky)) {}

    std::size_t size() const override { return luminaires_.size(); }
    LightBounds bounds(LightIndex light) const override {
        LightBounds result = candelabra::bounds(luminaires_[light]);
        if (!bent_normals_.empty()) result.bent_normal = bent_normals_[light];
        return result;
    }
    const ChoosableSky* sky() const override { return sky_.get(); }
    bool exact_nearby(LightIndex) const override;
    double unoccluded(LightIndex light, const Receiver& point) const override {
        return candelabra::unoccluded(luminaires_[light], point);
    }
    double arriving(LightIndex, const SurveyPlace&, const Vec2& u,
                    const LightProbe&) const override;

private:
    std::span<const Luminaire> luminaires_;
    std::span<const Vec3> bent_normals_;
    std::unique_ptr<const ChoosableSky> sky_;
};

}  // namespace candelabra

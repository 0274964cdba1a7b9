// SPDX-License-Identifier: GPL-3.0-or-later
// Luminaires, and the sky beside them, as a light strategy chooses among them.
#pragma once

#include "lighting/choosable_lights.h"
#include "world/luminaire_list.h"

#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace candelabra {

/// The luminaires and their bent normals must outlive this.
class LuminaireChoices final : public ChoosableLights {
public:
    /// `bent_normals`: of each luminaire (world/bent_normals.h); empty: none has one. `sky`: chosen
    /// besides; null: none.
    explicit LuminaireChoices(const LuminaireList& luminaires,
                              std::span<const Vec3> bent_normals = {},
                              std::unique_ptr<const ChoosableSky> sky = nullptr);
    /// The same of luminaires without instances.
    explicit LuminaireChoices(std::span<const Luminaire> luminaires,
                              std::span<const Vec3> bent_normals = {},
                              std::unique_ptr<const ChoosableSky> sky = nullptr)
        : own_(luminaires), bent_normals_(bent_normals), sky_(std::move(sky)) {}

    std::size_t size() const override { return list_ ? list_->size() : own_.size(); }
    LightBounds bounds(LightIndex light) const override {
        LightBounds result = candelabra::bounds(*at(light));
        if (!bent_normals_.empty()) result.bent_normal = bent_normals_[light];
        return result;
    }
    const ChoosableSky* sky() const override { return sky_.get(); }
    std::span<const LightCopy> copies() const override { return copies_; }
    bool exact_nearby(LightIndex) const override;
    double unoccluded(LightIndex light, const Receiver& point) const override {
        return candelabra::unoccluded(*at(light), point);
    }
    void fetch(LightIndex light) const override {
        if (light < own_.size()) candelabra::fetch(own_[light]);
    }
    double arriving(LightIndex, const SurveyPlace&, const Vec2& u,
                    const LightProbe&) const override;

private:
    LuminaireAt at(LightIndex light) const {
        return light < own_.size() ? LuminaireAt(own_[light]) : (*list_)[light];
    }

    std::span<const Luminaire> own_;
    const LuminaireList* list_ = nullptr;  ///< null: there are no others
    std::vector<LightCopy> copies_;
    std::span<const Vec3> bent_normals_;
    std::unique_ptr<const ChoosableSky> sky_;
};

}  // namespace candelabra

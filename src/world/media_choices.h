// SPDX-License-Identifier: GPL-3.0-or-later
// Boxes of glowing media as a light strategy chooses among them.
#pragma once

#include "lighting/choosable_lights.h"
#include "luminaire/volume.h"

#include <cstddef>
#include <span>

namespace candelabra {

/// The boxes and their bent normals must outlive this.
class MediaChoices final : public ChoosableLights {
public:
    /// `bent_normals`: of each box (world/bent_normals.h); empty: none has one.
    explicit MediaChoices(std::span<const MediaBox> boxes, std::span<const Vec3> bent_normals = {})
        : boxes_(boxes), bent_normals_(bent_normals) {}

    std::size_t size() const override { return boxes_.size(); }
    LightBounds bounds(LightIndex light) const override {
        LightBounds result = candelabra::bounds(boxes_[light]);
        if (!bent_normals_.empty()) result.bent_normal = bent_normals_[light];
        return result;
    }
    bool has_surface(LightIndex) const override { return false; }
    double unoccluded(LightIndex light, const Receiver& point) const override {
        return candelabra::unoccluded(boxes_[light], point);
    }
    double arriving(LightIndex, const SurveyPlace&, const Vec2& u,
                    const LightProbe&) const override;

private:
    std::span<const MediaBox> boxes_;
    std::span<const Vec3> bent_normals_;
};

}  // namespace candelabra

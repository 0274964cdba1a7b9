// SPDX-License-Identifier: GPL-3.0-or-later
// POV-Ray's light sources as a light strategy chooses among them: all light of one passes through a
// ball around it.
#pragma once

#include "lighting/choosable_lights.h"

#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

struct ChoosableSource {
    Vec3 centre;
    double radius = 0;
    Falloff falloff = {};
    double luminance = 1;  ///< of light of its colour
};

class SourceChoices final : public ChoosableLights {
public:
    explicit SourceChoices(std::vector<ChoosableSource> sources) : sources_(std::move(sources)) {}

    std::size_t size() const override { return sources_.size(); }
    LightBounds bounds(LightIndex) const override;
    bool falls_off() const override { return !sources_.empty(); }
    std::optional<Falloff> falloff(LightIndex light) const override {
        return sources_[light].falloff;
    }
    bool has_surface(LightIndex) const override { return false; }
    double unoccluded(LightIndex, const Receiver&) const override;
    double arriving(LightIndex, const SurveyPlace&, const Vec2& u,
                    const LightProbe&) const override;

private:
    std::vector<ChoosableSource> sources_;
};

}  // namespace candelabra

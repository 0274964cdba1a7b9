// SPDX-License-Identifier: GPL-3.0-or-later
// The sky as a light strategy chooses it.
#pragma once

#include "lighting/choosable_lights.h"
#include "world/world.h"

namespace candelabra {

/// The world must outlive this. Precondition: its sky is a luminaire.
class SkyChoice final : public ChoosableSky {
public:
    explicit SkyChoice(const World&);

    /// Whether most of its light may come from a small part, such as a sun. Surveys of cells would
    /// miss it at places, and directions that they know would not find it: so such a sky is better
    /// sampled apart from other lights.
    bool glares() const { return brightest_ > most_glare * mean_; }

    double luminance(const Vec3& direction) const override;
    double brightest() const override { return brightest_; }
    Vec3 draw(const Vec2& u) const override { return world_.sky.light.draw(u).direction; }
    double density(const Vec3& direction) const override {
        return world_.sky.light.density(direction);
    }

private:
    /// Maximum ratio of the brightest part to the mean: "The sky" in tests/bench/README.md.
    static constexpr double most_glare = 16;

    const World& world_;
    double brightest_ = 0, mean_ = 0;
};

}  // namespace candelabra

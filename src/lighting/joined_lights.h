// SPDX-License-Identifier: GPL-3.0-or-later
// Lights of two kinds as one set, so that a strategy makes one draw among all of them.
#pragma once

#include "lighting/choosable_lights.h"

#include <memory>
#include <utility>

namespace candelabra {

/// All of the first kind, and after them all of the second. The sky is that of the first.
class JoinedLights final : public ChoosableLights {
public:
    /// Neither is null; the second one has no sky.
    JoinedLights(std::shared_ptr<const ChoosableLights> first,
                 std::shared_ptr<const ChoosableLights> second)
        : first_(std::move(first)),
          second_(std::move(second)),
          count_(static_cast<LightIndex>(first_->size())) {}

    std::size_t size() const override { return count_ + second_->size(); }
    LightBounds bounds(LightIndex light) const override {
        return kind(light).bounds(within(light));
    }
    const ChoosableSky* sky() const override { return first_->sky(); }
    /// The second kind has none.
    std::span<const LightCopy> copies() const override { return first_->copies(); }
    bool falls_off() const override { return first_->falls_off() || second_->falls_off(); }
    std::optional<Falloff> falloff(LightIndex light) const override {
        return kind(light).falloff(within(light));
    }
    bool has_surface(LightIndex light) const override {
        return kind(light).has_surface(within(light));
    }
    bool exact_nearby(LightIndex light) const override {
        return kind(light).exact_nearby(within(light));
    }
    double unoccluded(LightIndex light, const Receiver& point) const override {
        return kind(light).unoccluded(within(light), point);
    }
    void fetch(LightIndex light) const override { kind(light).fetch(within(light)); }
    double arriving(LightIndex light, const SurveyPlace& place, const Vec2& u,
                    const LightProbe& probe) const override {
        return kind(light).arriving(within(light), place, u, probe);
    }

private:
    const ChoosableLights& kind(LightIndex light) const {
        return light < count_ ? *first_ : *second_;
    }
    LightIndex within(LightIndex light) const { return light < count_ ? light : light - count_; }

    std::shared_ptr<const ChoosableLights> first_, second_;
    LightIndex count_;  ///< of the first kind
};

}  // namespace candelabra

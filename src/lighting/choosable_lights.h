// SPDX-License-Identifier: GPL-3.0-or-later
// The lights among which a strategy chooses, as far as strategies know them: their bounds, and the
// light that a point gets from them. Whether they are luminaires, light sources or reflected light
// is known to those who make the choices and ask for the light of what was chosen: world/ and
// transport/.
#pragma once

#include "base/transform.h"
#include "lighting/survey_places.h"
#include "luminaire/light_proxy.h"

#include <cstddef>
#include <optional>
#include <span>

namespace candelabra {

/// Light from all around the scene: it has no bounds, and arrives at every point that a ray from
/// outside of the scene reaches. Never changes.
class ChoosableSky {
public:
    ChoosableSky() = default;
    ChoosableSky(const ChoosableSky&) = delete;
    ChoosableSky& operator=(const ChoosableSky&) = delete;
    virtual ~ChoosableSky() = default;

    /// From a unit direction; 0 or more.
    virtual double luminance(const Vec3& direction) const = 0;
    /// About the greatest luminance.
    virtual double brightest() const = 0;
    /// Draws a direction, more often where the sky is bright. u is in [0, 1)^2.
    virtual Vec3 draw(const Vec2& u) const = 0;
    /// Density of draw() per steradian; above 0.
    virtual double density(const Vec3& direction) const = 0;
};

class LightTree;

/// Some of the lights that are the same as others elsewhere: those of an instance. They have
/// consecutive numbers, surfaces, and no bent normals; they fall off with the square of the
/// distance.
struct LightCopy {
    LightIndex first = 0;               ///< of its lights
    const LightTree* lights = nullptr;  ///< before they are placed; at least one
    const Transform* place = nullptr;   ///< a similarity
    double scale = 1;                   ///< factor of its lengths
    double luminance = 0;               ///< of the brightest light
};

/// Never changes, so that it may be asked by any number of threads.
class ChoosableLights {
public:
    ChoosableLights() = default;
    ChoosableLights(const ChoosableLights&) = delete;
    ChoosableLights& operator=(const ChoosableLights&) = delete;
    virtual ~ChoosableLights() = default;

    virtual std::size_t size() const = 0;
    virtual LightBounds bounds(LightIndex) const = 0;

    /// The sky, if it is one of the lights, besides those with bounds; its index is sky_light.
    virtual const ChoosableSky* sky() const { return nullptr; }

    /// Whether any light falls off otherwise than with the square of the distance.
    virtual bool falls_off() const { return false; }
    /// How a light falls off; nothing: with the square of the distance.
    virtual std::optional<Falloff> falloff(LightIndex) const { return {}; }

    /// The lights that are stored once for several places, in ascending order.
    virtual std::span<const LightCopy> copies() const { return {}; }

    /// Whether a sampled direction may hit the light.
    virtual bool has_surface(LightIndex) const { return true; }

    /// Whether unoccluded() is exact where the light is near, unlike the estimate from its bounds.
    virtual bool exact_nearby(LightIndex) const { return false; }
    /// Unoccluded irradiance at the point, as luminance: see luminaire.h.
    virtual double unoccluded(LightIndex light, const Receiver& point) const {
        return irradiance(light_proxy(bounds(light)), point);
    }

    /// Has what arriving() reads of the light fetched from memory.
    virtual void fetch(LightIndex) const {}
    /// Irradiance that one shadow ray brings to a place, by a point of the light that u in [0, 1)^2
    /// chooses; an unbiased estimate. Called if cells are surveyed.
    virtual double arriving(LightIndex light, const SurveyPlace& place, const Vec2&,
                            const LightProbe&) const {
        return unoccluded(light, place.point);
    }
};

}  // namespace candelabra

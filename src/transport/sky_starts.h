// SPDX-License-Identifier: GPL-3.0-or-later
// Where rays from the sky should start so that their light, once it is reflected, gets to what the
// camera sees: as rays from there have found the sky.
#pragma once

#include "base/random.h"
#include "base/weighted_index.h"
#include "transport/lit_region.h"
#include "world/world.h"

#include <cstddef>
#include <span>
#include <vector>

namespace candelabra {

/// A place that the sky lights, and that lights what the camera sees, maybe by way of others.
struct SkyStart {
    Vec2 direction;  ///< place of SkyLight::draw(), by which the place sees the sky
    Vec3 place;
    double worth;
};
/// Some of them, found from places that the camera sees. Precondition: the sky is a luminaire.
std::vector<SkyStart> sky_starts(const World&, std::span<const SeenPlace>);

/// Draws rays of the sky in nearly the directions of such starts, and to about their places.
class SkyGuide {
public:
    SkyGuide() = default;  ///< empty
    /// Directions are drawn anew within one of `across` by `across` cells of the unit square, and
    /// places within `width` of a start, in radii of the region, or in its distance from the middle
    /// of the region where that is more.
    SkyGuide(std::span<const SkyStart>, const LitRegion&, std::uint32_t across, double width);

    bool empty() const { return starts_.empty(); }

    struct Drawn {
        Vec2 direction;      ///< place of SkyLight::draw()
        std::uint32_t near;  ///< number of the start
    };
    /// u is in [0, 1)^2. Precondition: not empty().
    Drawn draw(const Vec2& u) const;
    /// Offset from the middle of the region, perpendicular to the direction, of a ray about that
    /// start. u is in [0, 1)^2.
    Vec3 aside(std::uint32_t near, const Vec3& direction, const Vec2& u) const;
    /// Density of both, per unit of the square and of area. `towards`: that direction.
    double density(const Vec2& direction, const Vec3& towards, const Vec3& aside) const;

private:
    struct Start {
        Vec3 offset;  ///< from the middle of the region
        double radius;
    };
    std::uint32_t cell_of(const Vec2& direction) const;

    std::uint32_t across_ = 0;
    std::vector<Start> starts_;         ///< by their cells
    std::vector<std::uint32_t> cells_;  ///< first start of each, and the number of all
    WeightedIndex weights_;             ///< of starts
};

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// A sky as a luminaire: draws directions in proportion to their light. Built when a world is
// compiled; immutable.
#pragma once

#include "base/function_ref.h"
#include "base/rgb.h"
#include "base/vector.h"

#include <cstddef>
#include <vector>

namespace candelabra {

class SkyLight {
public:
    /// Makes a sky without light.
    SkyLight() = default;
    /// `radiance` is evaluated at two points of each cell of a map of longitudes and latitudes.
    /// Directions in which the map misses light are drawn too, but rarely.
    explicit SkyLight(FunctionRef<Rgb(const Vec3& direction)> radiance);

    bool empty() const { return rows_.empty(); }

    struct Drawn {
        Vec3 direction;
        double density;  ///< per steradian, above 0
    };
    /// `place` is uniform in [0, 1)^2.
    Drawn draw(Vec2 place) const;
    /// Density with which draw() returns a unit direction.
    double density(const Vec3& direction) const;

    std::size_t memory_bytes() const {
        return (rows_.capacity() + columns_.capacity()) * sizeof(float);
    }

private:
    // Prefix sums of the weights: of the rows, and of the cells of each row.
    std::vector<float> rows_;
    std::vector<float> columns_;
};

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// A sky as a luminaire: which directions light comes from, to be drawn in proportion. Built when a
// world is compiled; immutable.
#pragma once

#include "base/function_ref.h"
#include "base/vector.h"

#include <vector>

namespace candelabra {

class SkyLight {
public:
    /// Gives no light.
    SkyLight() = default;
    /// `radiance` is asked once in each cell of a map of longitudes and latitudes. Where the map
    /// misses light, directions are drawn as well, though rarely.
    explicit SkyLight(FunctionRef<Vec3(const Vec3& direction)> radiance);

    bool empty() const { return rows_.empty(); }

    struct Drawn {
        Vec3 direction;
        double density;  ///< per steradian, above 0
    };
    /// `place` is uniform in [0, 1)^2.
    Drawn draw(Vec2 place) const;
    /// The density of a unit direction in draw().
    double density(const Vec3& direction) const;

    std::size_t memory_bytes() const {
        return (rows_.capacity() + columns_.capacity()) * sizeof(float);
    }

private:
    // Sums of the shares, so that they can be searched: of the rows up to each, and of the cells of
    // each row.
    std::vector<float> rows_;
    std::vector<float> columns_;
};

}  // namespace candelabra

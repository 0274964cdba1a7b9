// SPDX-License-Identifier: GPL-3.0-or-later
#include "scattering/facet_albedo.h"

#include "scattering/ggx.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace candelabra {

namespace {

FacetAlbedo mix(const FacetAlbedo& a, const FacetAlbedo& b, double share) {
    return {a.all + share * (b.all - a.all), a.grazing + share * (b.grazing - a.grazing)};
}

/// Mean over the facets that are visible from a direction, at the midpoints of a grid that is finer
/// towards the facets on the rim, which reflect light down. The half of the facets on one side of
/// the plane of incidence is like the other.
FacetAlbedo integrated(double width, double cosine) {
    constexpr int rings = 16, sectors = 12;
    const Vec3 viewer(std::sqrt(1 - cosine * cosine), 0, cosine);
    FacetAlbedo sum{0, 0};
    for (int i = 0; i < rings; ++i)
        for (int j = 0; j < sectors; ++j) {
            const double from_rim = 1 - (i + 0.5) / rings;
            const Vec2 place(1 - from_rim * from_rim, 0.25 + 0.5 * (j + 0.5) / sectors);
            const Vec3 facet = visible_facet(viewer, width, place);
            const double between = dot(viewer, facet);
            const double light = 2 * between * facet.z - viewer.z;
            if (light <= 0 || between <= 0) continue;
            const double reflected = 4 * from_rim * light * unhidden(width, light);
            sum.all += reflected;
            sum.grazing += reflected * grazing_share(between);
        }
    return {sum.all / (rings * sectors), sum.grazing / (rings * sectors)};
}

/// Albedos over roughness and over the square root of the cosine: they change fastest at grazing
/// directions.
class FacetAlbedoTable {
public:
    FacetAlbedoTable() {
        for (std::size_t i = 0; i < rows; ++i) {
            const double width = facet_width(static_cast<double>(i) / (rows - 1));
            for (std::size_t j = 0; j < columns; ++j) {
                const double root = static_cast<double>(j) / (columns - 1);
                at_[i][j] = integrated(width, root * root);
            }
            mean_[i] = mean(at_[i]);
        }
    }

    FacetAlbedo at(double roughness, double cosine) const {
        const Place row(roughness, rows), column(std::sqrt(std::clamp(cosine, 0.0, 1.0)), columns);
        const auto in = [&](const Row& r) {
            return mix(r[column.first], r[column.first + 1], column.share);
        };
        return mix(in(at_[row.first]), in(at_[row.first + 1]), row.share);
    }
    FacetAlbedo mean(double roughness) const {
        const Place row(roughness, rows);
        return mix(mean_[row.first], mean_[row.first + 1], row.share);
    }

private:
    static constexpr std::size_t rows = 24, columns = 32;
    using Row = std::array<FacetAlbedo, columns>;

    struct Place {
        Place(double x, std::size_t steps) {
            const double along = std::clamp(x, 0.0, 1.0) * static_cast<double>(steps - 1);
            first = std::min(static_cast<std::size_t>(along), steps - 2);
            share = along - static_cast<double>(first);
        }
        std::size_t first;
        double share;
    };

    /// The integral over the cosine c of 2 c times the albedo, which is linear between the columns
    /// in r, the root of c: of 4 r^3 times the albedo over r.
    static FacetAlbedo mean(const Row& row) {
        constexpr double step = 1.0 / (columns - 1);
        // Gauss's rule with three points, which is exact here.
        constexpr std::array<double, 3> offsets = {0.112701665379258311, 0.5, 0.887298334620741689},
                                        weights = {5.0 / 18, 8.0 / 18, 5.0 / 18};
        FacetAlbedo sum{0, 0};
        for (std::size_t j = 0; j + 1 < columns; ++j)
            for (std::size_t k = 0; k < offsets.size(); ++k) {
                const double root = (static_cast<double>(j) + offsets[k]) * step;
                const double weight = 4 * root * root * root * weights[k] * step;
                const FacetAlbedo there = mix(row[j], row[j + 1], offsets[k]);
                sum.all += weight * there.all;
                sum.grazing += weight * there.grazing;
            }
        return sum;
    }

    std::array<Row, rows> at_;
    std::array<FacetAlbedo, rows> mean_;
};

const FacetAlbedoTable& table() {
    static const FacetAlbedoTable made;
    return made;
}

}  // namespace

FacetAlbedo facet_albedo(double roughness, double cosine) { return table().at(roughness, cosine); }

FacetAlbedo mean_facet_albedo(double roughness) { return table().mean(roughness); }

}  // namespace candelabra

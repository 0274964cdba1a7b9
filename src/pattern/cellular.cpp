// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/cellular.h"

#include "vocabulary/schema.h"

#include <algorithm>

const ItemInfo Cells::vocabulary =
    described<Cells>([] { return schema<Cells>("cells", "Unit cubes with a random value each."); });

const ItemInfo Crackle::vocabulary = described<Crackle>([] {
    using F = Field<Crackle>;
    return schema<Crackle>(
        "crackle", "Cells around random nuclei: by default 0 on their borders.",
        F{"form", &Crackle::form, item,
          "weights of the distances to the nearest, second and third nucleus"},
        F{"metric", &Crackle::metric, item,
          "what distance is: 1 along the axes, 2 straight, more: nearly by the longest axis"},
        F{"offset", &Crackle::offset, item, "is added to the distances, by the metric's power"},
        F{"solid", &Crackle::solid, flag, "one random value for each cell"});
});

const ItemInfo Facets::vocabulary = described<Facets>([] {
    using F = Field<Facets>;
    return schema<Facets>(
        "facets", "Flat faces in random directions, for normals only.",
        F{"size", &Facets::size, item, "size of the faces"},
        F{"coords", &Facets::coords, item,
          "0: faces by the surface's direction; above: by the point, tilted by this much"},
        F{"metric", &Facets::metric, item, "what distance is: 1 along the axes, 2 straight"});
});

namespace {

constexpr double tolerance = 1e-10;

struct Cell {
    std::int64_t x, y, z;
};

Cell cell_of(const Vec3& p) {
    return {static_cast<std::int64_t>(std::floor(p.x)), static_cast<std::int64_t>(std::floor(p.y)),
            static_cast<std::int64_t>(std::floor(p.z))};
}

/// Calls use(offset of the nucleus from the point) for the 81 cells around: all neighbours, and
/// those two steps away along one axis.
template <class Use>
void for_nuclei(const Vec3& point, Use use) {
    const Cell home = cell_of(point - Vec3(tolerance));
    const std::span<const double> random = random_table();
    const Vec3 corner = Vec3(static_cast<double>(home.x), static_cast<double>(home.y),
                             static_cast<double>(home.z)) -
                        point;
    for (int i = -2; i <= 2; ++i)
        for (int j = -2; j <= 2; ++j)
            for (int k = -2; k <= 2; ++k) {
                if ((std::abs(i) == 2) + (std::abs(j) == 2) + (std::abs(k) == 2) > 1) continue;
                const std::size_t hash = cell_hash(home.x + i, home.y + j, home.z + k);
                use(corner + Vec3(i + random[hash], j + random[hash + 1], k + random[hash + 2]));
            }
}

double power(double base, double exponent) {
    return exponent == 2 ? base * base : exponent == 1 ? base : std::pow(base, exponent);
}

/// Distance to the power of the metric.
double raised_distance(const Vec3& v, double metric) {
    return power(std::abs(v.x), metric) + power(std::abs(v.y), metric) +
           power(std::abs(v.z), metric);
}

double root(double raised, double metric) {
    if (metric == 2) return std::sqrt(raised);
    return metric == 1 ? raised : std::pow(raised, 1 / metric);
}

}  // namespace

double evaluate(const Cells&, const Vec3& point) {
    const Cell cell = cell_of(point + Vec3(tolerance));
    return random_table()[cell_hash(cell.x, cell.y, cell.z)];
}

double evaluate(const Crackle& crackle, const PatternPoint& at) {
    const double metric = crackle.metric.x;
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::array<double, 3> nearest = {infinite, infinite, infinite};
    Vec3 to_nucleus(0);
    for_nuclei(at.position, [&](const Vec3& offset) {
        const double distance = raised_distance(offset, metric);
        if (!(distance < nearest[2])) return;
        if (distance < nearest[0]) {
            to_nucleus = offset;
            nearest = {distance, nearest[0], nearest[1]};
        } else if (distance < nearest[1]) {
            nearest = {nearest[0], distance, nearest[1]};
        } else {
            nearest[2] = distance;
        }
    });
    if (crackle.solid) return noise(at.position + to_nucleus, at.noise_generator());
    const double more = crackle.offset == 0 ? 0 : power(crackle.offset, metric);
    double value = 0;
    for (std::size_t i = 0; i < nearest.size(); ++i)
        if (const double weight = crackle.form[static_cast<int>(i)]; weight != 0)
            value += weight * root(nearest[i] + more, metric);
    return std::clamp(value, 0.0, 1.0);
}

double evaluate(const Facets&, const Vec3&) { return 0; }

Vec3 nearest_nucleus(const Vec3& point, double metric) {
    double least = std::numeric_limits<double>::infinity();
    Vec3 result(0);
    for_nuclei(point, [&](const Vec3& offset) {
        const double distance =
            metric == 1 ? offset.x + offset.y + offset.z : raised_distance(offset, metric);
        if (!(distance < least)) return;
        least = distance;
        result = offset;
    });
    return point + result;
}

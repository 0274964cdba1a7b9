// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/cellular.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

const ItemInfo Cells::vocabulary = described<Cells>([] {
    return schema<Cells>("cells",
                         {"Unit cubes with a random value each.", "pigment { cells scale 0.3 }"});
});

const ItemInfo Crackle::vocabulary = described<Crackle>([] {
    using F = Field<Crackle>;
    return schema<Crackle>(
        "crackle",
        {"Cells around random nuclei: by default 0 on their borders.",
         "pigment { crackle scale 0.25 }", "pigment { crackle form <1, 0, 0> scale 0.3 }",
         "pigment { crackle metric 1 scale 0.3 }", "pigment { crackle solid scale 0.25 }",
         "pigment { crackle offset 0.3 repeat <4, 4, 0> scale 0.25 }"},
        F{"form", &Crackle::form, item,
          "weights of the distances to the nearest, second and third nucleus"},
        F{"metric", &Crackle::metric, item,
          "what distance is: 1 along the axes, 2 straight, more: nearly by the longest axis"},
        F{"offset", &Crackle::offset, item, "is added to the distances, by the metric's power"},
        F{"solid", &Crackle::solid, flag, "one random value for each cell"},
        F{"repeat", &Crackle::repeat, item,
          "whole numbers: along each axis the cells repeat after so many; 0: never",
          between(0, 1e6)});
});

const ItemInfo Facets::vocabulary = described<Facets>([] {
    using F = Field<Facets>;
    return schema<Facets>(
        "facets",
        {"Flat faces in random directions, for normals only.", "normal { facets size 0.2 }",
         "normal { facets coords 0.4 size 0.3 metric 1 }"},
        F{"size", &Facets::size, item, "size of the faces"},
        F{"coords", &Facets::coords, item,
          "0: faces by the surface's direction; above: by the point, tilted by this much"},
        F{"metric", &Facets::metric, item, "what distance is: 1 along the axes, 2 straight"});
});

namespace {

constexpr double cell_margin = 1e-10;
constexpr double infinite = std::numeric_limits<double>::infinity();

struct Cell {
    std::int64_t x, y, z;
};

Cell cell_of(const Vec3& p) {
    return {static_cast<std::int64_t>(std::floor(p.x)), static_cast<std::int64_t>(std::floor(p.y)),
            static_cast<std::int64_t>(std::floor(p.z))};
}

double power(double base, double exponent) {
    return exponent == 2 ? base * base : exponent == 1 ? base : math::pow(base, exponent);
}

/// Returns the distance raised to the power of the metric.
double raised_distance(const Vec3& v, double metric) {
    return power(std::abs(v.x), metric) + power(std::abs(v.y), metric) +
           power(std::abs(v.z), metric);
}

double root(double raised, double metric) {
    if (metric == 2) return std::sqrt(raised);
    return metric == 1 ? raised : math::pow(raised, 1 / metric);
}

/// Steps along the axes, each -2 to 2.
struct CellStep {
    int x, y, z;
};

/// Returns the steps to all neighbours of a cell and to those two steps away along one axis,
/// nearest first.
constexpr auto make_steps() {
    std::array<CellStep, 81> steps{};
    std::size_t count = 0;
    for (int x = -2; x <= 2; ++x)
        for (int y = -2; y <= 2; ++y)
            for (int z = -2; z <= 2; ++z)
                if ((x * x == 4) + (y * y == 4) + (z * z == 4) <= 1) steps[count++] = {x, y, z};
    std::ranges::sort(steps, {}, [](const CellStep& s) {
        return 125 * (s.x * s.x + s.y * s.y + s.z * s.z) + 25 * s.x + 5 * s.y + s.z;
    });
    return steps;
}

/// Distances along one axis from a point to the cells -2 to 2 steps away, raised to the power of
/// the metric.
struct Gaps {
    Gaps(double corner, double metric) {
        for (int step = -2; step <= 2; ++step) {
            const double gap = std::max({corner + step, -(corner + step + 1), 0.0});
            raised[static_cast<std::size_t>(step + 2)] = metric > 0 ? power(gap, metric) : 0;
        }
    }
    double at(int step) const { return raised[static_cast<std::size_t>(step + 2)]; }

    std::array<double, 5> raised;
};

/// Cells after which the nuclei repeat along each axis; 0: they do not.
struct Period {
    std::int64_t x = 0, y = 0, z = 0;

    static std::int64_t wrapped(std::int64_t cell, std::int64_t period) {
        return period > 0 ? (cell % period + period) % period : cell;
    }
    std::size_t hash(const Cell& cell) const {
        return cell_hash(wrapped(cell.x, x), wrapped(cell.y, y), wrapped(cell.z, z));
    }
    /// The place of the first period that is as this one.
    Vec3 first(const Vec3& place) const {
        const auto in_first = [](double at, std::int64_t period) {
            const auto size = static_cast<double>(period);
            return period > 0 ? at - size * std::floor(at / size) : at;
        };
        return {in_first(place.x, x), in_first(place.y, y), in_first(place.z, z)};
    }
};

/// Calls use(offset of the nucleus from the point, distance raised to the power of the metric) for
/// the nuclei of the cells around the point. Skips cells that are surely farther away than
/// `farthest`, which `use` may reduce.
template <class Use>
void for_nuclei(const Vec3& point, double metric, const Period& period, const double& farthest,
                Use use) {
    static constexpr auto steps = make_steps();
    const Cell home = cell_of(point - Vec3(cell_margin));
    const std::span<const double> random = random_table();
    const Vec3 corner = Vec3(static_cast<double>(home.x), static_cast<double>(home.y),
                             static_cast<double>(home.z)) -
                        point;
    const Gaps x(corner.x, metric), y(corner.y, metric), z(corner.z, metric);
    for (const CellStep& step : steps) {
        if (x.at(step.x) + y.at(step.y) + z.at(step.z) > farthest) continue;
        const std::size_t hash = period.hash({home.x + step.x, home.y + step.y, home.z + step.z});
        const Vec3 offset = corner + Vec3(step.x + random[hash], step.y + random[hash + 1],
                                          step.z + random[hash + 2]);
        use(offset, raised_distance(offset, metric));
    }
}

}  // namespace

double evaluate(const Cells&, const Vec3& point) {
    const Cell cell = cell_of(point + Vec3(cell_margin));
    return random_table()[cell_hash(cell.x, cell.y, cell.z)];
}

double evaluate(const Crackle& crackle, const PatternPoint& at) {
    const double metric = crackle.metric.x;
    std::array<double, 3> nearest = {infinite, infinite, infinite};
    // Only the nearest nuclei up to this index are needed.
    const std::size_t last = crackle.solid         ? 0
                             : crackle.form.z != 0 ? 2
                             : crackle.form.y != 0 ? 1
                                                   : 0;
    Vec3 to_nucleus(0);
    const auto cells = [](double size) { return static_cast<std::int64_t>(size); };
    const Period period{cells(crackle.repeat.x), cells(crackle.repeat.y), cells(crackle.repeat.z)};
    const auto take = [&](const Vec3& offset, double distance) {
        if (!(distance < nearest[2])) return;
        if (distance < nearest[0]) {
            to_nucleus = offset;
            nearest = {distance, nearest[0], nearest[1]};
        } else if (distance < nearest[1]) {
            nearest = {nearest[0], distance, nearest[1]};
        } else {
            nearest[2] = distance;
        }
    };
    for_nuclei(at.position, metric, period, nearest[last], take);
    if (crackle.solid) return noise(period.first(at.position + to_nucleus), at.noise_generator());
    const double more = crackle.offset == 0 ? 0 : power(crackle.offset, metric);
    double value = 0;
    for (std::size_t i = 0; i < nearest.size(); ++i)
        if (const double weight = crackle.form[static_cast<int>(i)]; weight != 0)
            value += weight * root(nearest[i] + more, metric);
    return std::clamp(value, 0.0, 1.0);
}

double evaluate(const Facets&, const Vec3&) { return 0; }

Vec3 nearest_nucleus(const Vec3& point, double metric) {
    double least = infinite;
    Vec3 result(0);
    // With metric 1, a nucleus behind the point counts as near, as in POV-Ray.
    const bool signed_sum = metric == 1;
    for_nuclei(point, metric, Period{}, signed_sum ? infinite : least,
               [&](const Vec3& offset, double raised) {
                   const double distance = signed_sum ? offset.x + offset.y + offset.z : raised;
                   if (!(distance < least)) return;
                   least = distance;
                   result = offset;
               });
    return point + result;
}

}  // namespace candelabra

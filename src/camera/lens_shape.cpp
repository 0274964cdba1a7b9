// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/lens_shape.h"

#include "base/circle.h"
#include "base/degrees.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace candelabra {

namespace {

constexpr double circle = 2 * std::numbers::pi;

/// Divides a random number among equal parts: the part, and what is left as a random number.
struct Parted {
    int part;
    double rest;
};
Parted parted(double chance, int parts) {
    const double place = chance * parts;
    const int part = std::min(static_cast<int>(place), parts - 1);
    return {part, place - part};
}

}  // namespace

const ItemInfo Bokeh::vocabulary = described<Bokeh>([] {
    using F = Field<Bokeh>;
    return schema<Bokeh>(
        "bokeh",
        {"The shape of points of light that are out of focus: a polygon by `blades`, or a picture "
         "by a pigment over the square from 0 to x + y. Without it they are round.",
         "bokeh { blades 6 }", "bokeh { blades 5 angle 36 }",
         "bokeh { pigment { radial frequency 5 color_map { [0.5 rgb 0] [0.5 rgb 1] } } }"},
        F{"blades", &Bokeh::blades, item, "corners of the opening; 0: it is round", between(0, 64)},
        F{"angle", &Bokeh::angle, item, "degrees by which the opening is turned"});
});

LensShape::LensShape(const Bokeh& bokeh) : blades_(bokeh) {}

LensShape::LensShape(const std::vector<double>& brightness) {
    double sum = 0;
    for (const double each : brightness) sums_.push_back(sum += each > 0 ? each : 0);
    if (!(sum > 0) || !std::isfinite(sum)) sums_.clear();
}

Vec2 LensShape::point(Vec2 place) const {
    if (is_picture()) {
        const double wanted = place.x * sums_.back();
        const auto found = std::upper_bound(sums_.begin(), sums_.end() - 1, wanted);
        const auto cell = static_cast<int>(found - sums_.begin());
        const double before = cell == 0 ? 0 : sums_[static_cast<std::size_t>(cell) - 1];
        const double within = (wanted - before) / (*found - before);
        const Vec2 corner(cell % lens_cells, cell / lens_cells);
        return (corner + Vec2(std::clamp(within, 0.0, 1.0), place.y)) * (2.0 / lens_cells) -
               Vec2(1);
    }
    if (is_round()) return std::sqrt(place.x) * on_circle(circle * place.y);
    // A point between the middle and the edge from one corner to the next.
    const auto [edge, along] = parted(place.y, blades_.blades);
    const double step = circle / blades_.blades,
                 start = blades_.angle * radians_per_degree + std::numbers::pi / 2 + edge * step;
    const Vec2 first = on_circle(start), next = on_circle(start + step);
    return std::sqrt(place.x) * (first + along * (next - first));
}

}  // namespace candelabra

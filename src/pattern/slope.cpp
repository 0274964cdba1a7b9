// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/slope.h"

#include "base/elementary.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

const ItemInfo Slope::vocabulary = described<Slope>([] {
    using F = Field<Slope>;
    return schema<Slope>(
        "slope",
        {"Steepness: 1 where the surface faces a direction, 0 where it faces away.",
         "pigment { slope { <-1, 1, 0> } }", "pigment { slope { y, 0.2, 0.9 altitude y, 0, 1 } }",
         "pigment { slope { point_at <0, 1, 0>, 0, 2 } }"},
        maybe(F{"direction", &Slope::direction, positional,
                "the direction; its length is its weight against altitude"}),
        maybe(F{"low", &Slope::low, positional, "steepness that becomes 0"}),
        maybe(F{"high", &Slope::high, positional, "steepness that becomes 1; 0: no change"}),
        F{"altitude", &Slope::altitude, item,
          "direction along which height is mixed in; its length is the weight"},
        maybe(F{"altitude_low", &Slope::altitude_low, following, "height that becomes 0"}),
        maybe(F{"altitude_high", &Slope::altitude_high, following, "height that becomes 1"}),
        F{"point_at", &Slope::point_at, item, "point to face, in place of a direction"},
        maybe(F{"point_low", &Slope::point_low, following, "steepness that becomes 0"}),
        maybe(F{"point_high", &Slope::point_high, following, "steepness that becomes 1"}));
});

const ItemInfo Aoi::vocabulary = described<Aoi>([] {
    return schema<Aoi>("aoi",
                       {"The angle between the surface's normal and the ray, over 180.",
                        "pigment { aoi color_map { [0.5 rgb <0.2, 0.3, 0.6>] [1 rgb 1] } }"});
});

namespace {

using std::numbers::pi;

constexpr double top_margin = 1e-10;

double rescaled(double value, double low, double high) {
    return high == low ? value : (value - low) / (high - low);
}

/// Wraps into 0..1, except that 1 itself maps to just below 1.
double below_one(double value) {
    if (value >= 1 && value < 1 + top_margin) return value - top_margin;
    return value < 0 ? 1 + std::fmod(value, 1) : std::fmod(value, 1);
}

}  // namespace

double evaluate(const Slope& slope, const PatternPoint& at) {
    const SurfaceView* view = at.scene.view;
    if (!view) return 0;
    const bool to_point = slope.point_at.has_value();
    const Vec3 towards =
        to_point ? *slope.point_at - view->position : slope.direction.value_or(Vec3(0));
    const double cosine = std::clamp(dot(view->normal, unit(towards)), -1.0, 1.0);
    const double steepness =
        rescaled(math::asin(cosine) / pi + 0.5, to_point ? slope.point_low : slope.low,
                 to_point ? slope.point_high : slope.high);
    if (to_point || !slope.altitude || *slope.altitude == Vec3(0)) return below_one(steepness);
    const double height =
        rescaled(dot(at.position, unit(*slope.altitude)), slope.altitude_low, slope.altitude_high);
    const double along = length(towards), up = length(*slope.altitude);
    return below_one((along * steepness + up * height) / (along + up));
}

double evaluate(const Aoi&, const PatternPoint& at) {
    const SurfaceView* view = at.scene.view;
    if (!view) return 0;
    return math::acos(std::clamp(dot(view->normal, view->direction), -1.0, 1.0)) / pi;
}

}  // namespace candelabra

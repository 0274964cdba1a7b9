// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pigment.h"

#include <algorithm>

ColourMap default_map(const Pattern& pattern) {
    if (std::holds_alternative<Checker>(pattern))
        return {{0, {Vec3(0, 0, 1)}}, {1, {Vec3(0, 1, 0)}}};
    return {{0, {Vec3(0)}}, {1, {Vec3(1)}}};
}

Colour evaluate(const Pigment& pigment, const Vec3& point) {
    if (!pigment.pattern) return pigment.colour;
    return look_up(pigment.map, evaluate(*pigment.pattern, pigment.transform.inverse_point(point)));
}

Vec3 brightest(const Pigment& pigment) {
    if (!pigment.pattern) return pigment.colour.rgb;
    Vec3 result = pigment.map.front().colour.rgb;
    for (const ColourStop& stop : pigment.map) result = glm::max(result, stop.colour.rgb);
    return result;
}

bool transparent(const Pigment& pigment) {
    const auto passes = [](const Colour& c) { return c.filter != 0 || c.transmit != 0; };
    if (!pigment.pattern) return passes(pigment.colour);
    return std::ranges::any_of(pigment.map,
                               [&](const ColourStop& stop) { return passes(stop.colour); });
}

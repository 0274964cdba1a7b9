// SPDX-License-Identifier: GPL-3.0-or-later
// What shapes say of a part of a line, beside what they say of all of it.
#pragma once

#include "shape/built_shape.h"
#include "support/hits.h"

namespace candelabra {

/// Whether what the shape says of a part of the line agrees with what it says of all of it.
inline bool agree_in(const Interval& range, const BuiltShape& shape, const Ray& ray) {
    const auto inside = [&](const auto& all) {
        std::vector<double> places;
        for (std::size_t i = 0; i < all.size(); ++i)
            if (range.contains(all[i].t)) places.push_back(all[i].t);
        std::sort(places.begin(), places.end());
        return places;
    };
    Crossings between, nearest;
    all_crossings_in(shape, ray, range, between);
    crossings_in(shape, ray, range, nearest);
    const std::vector<double> all = inside(hits(shape, ray)), first = inside(nearest);
    return inside(between) == all && first.empty() == all.empty() &&
           (all.empty() || first[0] == all[0]);
}

}  // namespace candelabra

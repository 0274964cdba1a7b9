// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/precedence.h"

#include "shape/slabs.h"

namespace candelabra {

bool precedes(const Geometry& geometry, std::uint32_t item, std::uint32_t other, const Ray& ray) {
    constexpr double together = 1e-6;  // relative: more than the excess size of boxes
    const Slabs slabs(ray);
    const auto entry = [&](std::uint32_t i) {
        return slabs.within(geometry.bounds(i), {0, std::numeric_limits<double>::infinity()}).min;
    };
    const double here = entry(item), there = entry(other);
    if (std::abs(here - there) > together * std::max(std::abs(here), std::abs(there)))
        return here < there;
    return item < other;
}

}  // namespace candelabra

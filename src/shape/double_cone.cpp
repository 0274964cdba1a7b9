// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/double_cone.h"

namespace candelabra {

bool is_crossed(const Cone& cone) { return cone.base_radius < 0 || cone.cap_radius < 0; }

std::vector<Cone> uncrossed(const Cone& cone) {
    const double base = std::abs(cone.base_radius), cap = std::abs(cone.cap_radius);
    if (cone.base_radius * cone.cap_radius >= 0)
        return {{cone.base, base, cone.cap, cap, cone.open}};
    const Vec3 tip = cone.base + base / (base + cap) * (cone.cap - cone.base);
    return {{cone.base, base, tip, 0, cone.open}, {tip, 0, cone.cap, cap, cone.open}};
}

}  // namespace candelabra

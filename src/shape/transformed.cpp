// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/transformed.h"

namespace candelabra {

Plane transformed(const Plane& plane, const Transform& map) {
    const Vec3 normal = unit(plane.normal), turned = unit(map.normal(normal));
    return {turned, dot(turned, map.point(plane.distance * normal))};
}

}  // namespace candelabra

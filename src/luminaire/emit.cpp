// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/emit.h"

#include "base/cosine_direction.h"
#include "luminaire/area.h"
#include "luminaire/composite.h"
#include "luminaire/source.h"
#include "luminaire/sphere.h"
#include "luminaire/triangle.h"
#include "luminaire/volume.h"

#include <numbers>

namespace candelabra {

EmittedRay emitted_ray(const Vec3& position, const Vec3& normal, double per_area, Vec2 direction,
                       bool both_sides) {
    Vec3 side = normal;
    if (both_sides) {
        if (direction.x >= 0.5) side = -normal;
        direction.x = direction.x < 0.5 ? 2 * direction.x : 2 * direction.x - 1;
    }
    const Vec3 towards = cosine_direction(side, direction);
    const double share = both_sides ? 0.5 : 1;
    return {{position, towards}, side, per_area * share * dot(towards, side) / std::numbers::pi};
}

std::optional<EmittedRay> emit(const Luminaire& luminaire, const Vec2& where,
                               const Vec2& direction) {
    return std::visit([&](const auto& e) { return emit(e, where, direction); }, luminaire.emitter);
}

}  // namespace candelabra

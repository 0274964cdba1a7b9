// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/emit.h"

#include "base/cosine_direction.h"
#include "luminaire/area.h"
#include "luminaire/composite.h"
#include "luminaire/rectangle.h"
#include "luminaire/sphere.h"
#include "luminaire/triangle.h"

#include <numbers>

namespace candelabra {

EmittedRay emitted_ray(const Vec3& position, const Vec3& normal, double per_area, double inner,
                       const EmissionDraw& u) {
    const bool from_inside = u.side < inner;
    const Vec3 side = from_inside ? -normal : normal;
    const Vec3 towards = cosine_direction(side, u.direction);
    const double share = from_inside ? inner : 1 - inner;
    return {{position, towards},
            side,
            per_area * share * dot(towards, side) / std::numbers::pi,
            per_area};
}

double inner_share(SealedSide sealed, double inner) {
    if (sealed == SealedSide::none) return 0.5;
    return sealed == SealedSide::inner ? inner : 1 - inner;
}

std::optional<EmittedRay> emit(const Luminaire& luminaire, double inner, const EmissionDraw& u) {
    return std::visit([&](const auto& e) { return emit(e, inner, u); }, luminaire.emitter);
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/lamp_sight.h"

#include <cmath>

namespace candelabra {

std::optional<LightDirection> sight_of_lamp(const World& world, LightIndex lamp, const Vec3& from,
                                            const Vec2& u) {
    const LuminaireAt here = world.lights.luminaires[lamp];
    const Luminaire& luminaire = *here;
    std::optional<LightDirection> drawn;
    std::optional<double> distance;  // of the drawn point; another one has another density
    if (const auto searched = SearchedLuminaire::of(luminaire)) {
        drawn = searched->draw(from, u);
    } else if (const auto point = sample(luminaire, from, u)) {
        drawn = LightDirection{point->direction, point->density};
        distance = point->distance;
    }
    if (!drawn) return std::nullopt;
    constexpr double same_point = 1e-6;
    bool seen = false;
    world.along({from, drawn->direction}, 0, RayKind::camera, [&](const Hit& hit, double met) {
        if (world.luminaire_of(hit.primitive) == lamp) {
            seen = !distance || std::abs(met - *distance) <= same_point * *distance + hit.tolerance;
            if (seen) return false;
        }
        return !world.material(hit.primitive).stops_light();
    });
    return seen ? drawn : std::nullopt;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/luminaire_choices.h"

#include <variant>

namespace candelabra {

bool LuminaireChoices::exact_nearby(LightIndex light) const {
    const Emitter& emitter = luminaires_[light].emitter;
    return !luminaires_[light].web && (std::holds_alternative<TriangleEmitter>(emitter) ||
                                       std::holds_alternative<RectangleEmitter>(emitter));
}

double LuminaireChoices::arriving(LightIndex light, const SurveyPlace& from, const Vec2& u,
                                  const LightProbe& probe) const {
    const auto drawn = sample(luminaires_[light], from.point, u);
    if (!drawn) return 0;
    const double cosine = from.point.cosine(drawn->direction);
    if (!(cosine > 0)) return 0;
    const Ray ray{from.point.position, drawn->direction};
    double luminance = 0;
    look_along(ray, from.tolerance, probe, [&](const ProbeHit& sight, double share) {
        if (sight.light != light) return false;
        luminance = share * sight.luminance;
        return true;
    });
    return luminance * cosine / drawn->density;
}

}  // namespace candelabra

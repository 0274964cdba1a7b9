// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/luminaire_choices.h"

#include "world/prototype.h"

#include <variant>

namespace candelabra {

LuminaireChoices::LuminaireChoices(const LuminaireList& luminaires,
                                   std::span<const Vec3> bent_normals,
                                   std::unique_ptr<const ChoosableSky> sky)
    : own_(luminaires.own()),
      list_(&luminaires),
      bent_normals_(bent_normals),
      sky_(std::move(sky)) {
    for (const PlacedLuminaires& placed : luminaires.placed())
        copies_.push_back({placed.first, &placed.prototype->lights, placed.place,
                           placed.place->uniform_scale(), placed.prototype->luminance});
}

bool LuminaireChoices::exact_nearby(LightIndex light) const {
    const LuminaireAt lamp = at(light);
    const Emitter& emitter = lamp->emitter;
    return !lamp->web && (std::holds_alternative<TriangleEmitter>(emitter) ||
                          std::holds_alternative<RectangleEmitter>(emitter));
}

double LuminaireChoices::arriving(LightIndex light, const SurveyPlace& from, const Vec2& u,
                                  const LightProbe& probe) const {
    const LuminaireAt lamp = at(light);
    const auto drawn = sample(*lamp, from.point, u);
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

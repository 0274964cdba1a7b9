// SPDX-License-Identifier: GPL-3.0-or-later
#include "world/media_choices.h"

namespace candelabra {

namespace {

/// Fraction of light that surfaces transmit over that distance.
double left_on_way(const Ray& ray, double tolerance, double distance, const LightProbe& probe) {
    double left = 1;
    look_along(ray, tolerance, probe, [&](const ProbeHit& sight, double share) {
        left = sight.distance < distance ? share * sight.passes : share;
        return sight.distance >= distance;
    });
    return left;
}

}  // namespace

double MediaChoices::arriving(LightIndex light, const SurveyPlace& from, const Vec2& u,
                              const LightProbe& probe) const {
    const auto drawn = sample(boxes_[light], from.point.position, u);
    if (!drawn) return 0;
    const double cosine = from.point.cosine(drawn->direction);
    if (!(cosine > 0)) return 0;
    const Ray ray{from.point.position, drawn->direction};
    return left_on_way(ray, from.tolerance, drawn->distance, probe) *
           emitted_about(boxes_[light], drawn->position) * cosine / drawn->density;
}

}  // namespace candelabra

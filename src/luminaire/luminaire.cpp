// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/luminaire.h"

#include "base/colour.h"
#include "luminaire/area.h"
#include "luminaire/composite.h"
#include "luminaire/source.h"
#include "luminaire/sphere.h"
#include "luminaire/triangle.h"

double luminance(const Vec3& radiance) {
    const Vec3 shining(std::fmax(radiance.x, 0), std::fmax(radiance.y, 0),
                       std::fmax(radiance.z, 0));
    if (shining == Vec3(0)) return 0;
    // Wide enough for any scene, narrow enough that no product of it with lengths leaves the range
    // of a double.
    return std::fmin(std::fmax(grey(shining), 1e-100), 1e100);
}

LightBounds bounds(const Luminaire& luminaire) {
    return std::visit([&](const auto& e) { return bounds(e, luminance(luminaire.radiance)); },
                      luminaire.emitter);
}

double unoccluded(const Luminaire& luminaire, const ShadingPoint& point) {
    return std::visit(
        [&](const auto& e) { return unoccluded(e, luminance(luminaire.radiance), point); },
        luminaire.emitter);
}

std::optional<LightPoint> sample(const Luminaire& luminaire, const Vec3& from, const Vec2& u) {
    return std::visit([&](const auto& e) { return sample(e, from, u); }, luminaire.emitter);
}

std::optional<LightPoint> sample(const Luminaire& luminaire, const ShadingPoint& point,
                                 const Vec2& u) {
    if (const auto* sphere = std::get_if<SphereEmitter>(&luminaire.emitter))
        return sample(*sphere, point, u);
    return sample(luminaire, point.position, u);
}

void meet(const Luminaire& luminaire, const ShadingPoint& point, const Vec3& direction,
          LightMeetings& met) {
    std::visit([&](const auto& e) { meet(e, point, direction, met); }, luminaire.emitter);
}

double emitting_area(const Emitter& emitter) {
    return std::visit([](const auto& e) { return emitting_area(e); }, emitter);
}

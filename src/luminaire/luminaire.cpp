// SPDX-License-Identifier: GPL-3.0-or-later
#include "luminaire/luminaire.h"

#include "base/colour.h"
#include "luminaire/area.h"
#include "luminaire/body_web.h"
#include "luminaire/brightness.h"
#include "luminaire/composite.h"
#include "luminaire/emitter_kind.h"
#include "luminaire/rectangle.h"
#include "luminaire/sphere.h"
#include "luminaire/triangle.h"

#include <algorithm>

namespace candelabra {

static_assert(are_emitters<Emitter>);

namespace {

/// Fraction of a luminaire's points that are drawn as if it glowed evenly, when it has a map of its
/// brightness. Light that the map misses is noisier by one over this.
constexpr double evenly = 0.25;
/// Lower bound of the mean brightness as a fraction of the maximum.
constexpr double min_mean = 1e-3;

/// Ratio of the mean luminance, over the surface and both sides, to that of the brightest point.
double mean_share(const Luminaire& luminaire) {
    const double sides =
        (luminaire.one_sided ? 0.5 : 1) * (luminaire.web ? luminaire.web->mean_share() : 1);
    const auto* e = std::get_if<CompositeEmitter>(&luminaire.emitter);
    if (!luminaire.brightness && !(e && e->mean)) return sides;
    const double mean = luminaire.brightness ? luminaire.brightness->mean() : *e->mean;
    return sides * std::clamp(mean / luminance(luminaire.radiance), min_mean, 1.0);
}

/// Ratio of the luminance towards a point to that in the brightest direction, roughly: the
/// luminaire may be large. Lower bound of the ratio to its mean.
constexpr double least_towards = 0.05;
double share_towards(const Luminaire& luminaire, const Vec3& point) {
    const BodyWeb& web = *luminaire.web;
    const LightBounds around = bounds(luminaire);
    const Vec3 offset = point - around.centre;
    const double distance = length(offset), mean = web.mean_share();
    if (!(distance > 2 * around.radius)) return 1 / mean;
    return std::fmax(web.factor(offset / distance) / web.greatest() / mean, least_towards);
}

std::optional<LightPoint> sample_evenly(const Luminaire& luminaire, const Receiver& point,
                                        const Vec2& u) {
    return std::visit(
        [&](const auto& e) {
            if constexpr (requires { sample(e, point, u); })
                return sample(e, point, u);
            else
                return sample(e, point.position, u);
        },
        luminaire.emitter);
}

void intersect_evenly(const Luminaire& luminaire, const Receiver& point, const Vec3& direction,
                      LightHits& met) {
    std::visit([&](const auto& e) { intersect(e, point, direction, met); }, luminaire.emitter);
}

/// Samples by the map or evenly; the density is that of the mixture.
std::optional<LightPoint> sample_bright(const Luminaire& luminaire, const Brightness::View& view,
                                        const Receiver& point, const Vec2& u) {
    if (u.x < evenly) {
        auto drawn = sample_evenly(luminaire, point, {u.x / evenly, u.y});
        if (drawn)
            drawn->density = evenly * drawn->density + (1 - evenly) * view.density(drawn->position);
        return drawn;
    }
    const auto drawn = view.draw({(u.x - evenly) / (1 - evenly), u.y});
    const Vec3 offset = drawn.position - point.position;
    const double distance = length(offset);
    if (!(drawn.density > 0)) return {};
    LightHits met;
    intersect_evenly(luminaire, point, offset / distance, met);
    for (const LightHit& meeting : met)
        if (std::abs(meeting.distance - distance) < 1e-6 * distance)
            return LightPoint{drawn.position, offset / distance, distance,
                              evenly * meeting.density + (1 - evenly) * drawn.density};
    return {};
}

std::vector<BrightFace> faces_of(const Emitter& emitter) {
    if (const auto* t = std::get_if<TriangleEmitter>(&emitter))
        return {
            {t->corner1, t->corner2 - t->corner1, t->corner3 - t->corner1, BrightFace::triangle}};
    if (const auto* r = std::get_if<RectangleEmitter>(&emitter))
        return {{r->corner, r->side1, r->side2}};
    const auto* area = std::get_if<AreaEmitter>(&emitter);
    return area ? flat_faces(*area) : std::vector<BrightFace>();
}

}  // namespace

double luminance(const Rgb& radiance) {
    const Rgb shining(std::fmax(radiance.r, 0), std::fmax(radiance.g, 0), std::fmax(radiance.b, 0));
    if (shining == Rgb(0)) return 0;
    // Wide enough for any scene, and narrow enough that products with lengths stay in the range of
    // a double.
    return std::fmin(std::fmax(grey(shining), 1e-100), 1e100);
}

LightBounds bounds(const Luminaire& luminaire) {
    LightBounds result = std::visit(
        [&](const auto& e) { return bounds(e, luminance(luminaire.radiance)); }, luminaire.emitter);
    result.intensity *= mean_share(luminaire);
    return result;
}

double unoccluded(const Luminaire& luminaire, const Receiver& point) {
    return mean_share(luminaire) * (luminaire.web ? share_towards(luminaire, point.position) : 1) *
           std::visit(
               [&](const auto& e) { return unoccluded(e, luminance(luminaire.radiance), point); },
               luminaire.emitter);
}

std::optional<LightPoint> sample(const Luminaire& luminaire, const Vec3& from, const Vec2& u) {
    if (luminaire.brightness) return sample(luminaire, Receiver{from, Vec3(0), Horizon::none}, u);
    return std::visit([&](const auto& e) { return sample(e, from, u); }, luminaire.emitter);
}

std::optional<LightPoint> sample(const Luminaire& luminaire, const Receiver& point, const Vec2& u) {
    if (luminaire.brightness) {
        const Brightness::View view(*luminaire.brightness, point.position);
        if (view.any()) return sample_bright(luminaire, view, point, u);
    }
    return sample_evenly(luminaire, point, u);
}

void intersect(const Luminaire& luminaire, const Receiver& point, const Vec3& direction,
               LightHits& met) {
    const std::size_t before = met.size();
    intersect_evenly(luminaire, point, direction, met);
    if (!luminaire.brightness || met.size() == before) return;
    const Brightness::View view(*luminaire.brightness, point.position);
    if (!view.any()) return;
    for (std::size_t i = before; i < met.size(); ++i)
        met[i].density = evenly * met[i].density +
                         (1 - evenly) * view.density(point.position + met[i].distance * direction);
}

double emitting_area(const Emitter& emitter) {
    return std::visit([](const auto& e) { return emitting_area(e); }, emitter);
}

std::size_t face_count(const Emitter& emitter) {
    constexpr std::size_t of_sphere = 8;
    return std::holds_alternative<SphereEmitter>(emitter) ? of_sphere : faces_of(emitter).size();
}

Handle<Brightness> brightness_of(const Luminaire& luminaire, int cells,
                                 FunctionRef<double(const Vec3&)> luminance) {
    if (const auto* sphere = std::get_if<SphereEmitter>(&luminaire.emitter)) {
        Brightness map(sphere->centre, sphere->radius, cells, luminance);
        return map.unevenness() > Brightness::uneven ? make_handle<Brightness>(std::move(map))
                                                     : nullptr;
    }
    const std::vector<BrightFace> faces = faces_of(luminaire.emitter);
    return make_handle<Brightness>(faces, faces.size() > 1, cells, luminance);
}

std::optional<SearchedLuminaire> SearchedLuminaire::of(const Luminaire& luminaire) {
    const auto* emitter = std::get_if<CompositeEmitter>(&luminaire.emitter);
    return emitter ? std::optional(SearchedLuminaire(*emitter)) : std::nullopt;
}

std::optional<LightDirection> SearchedLuminaire::draw(const Vec3& from, const Vec2& u) const {
    return draw_direction(*emitter_, from, u);
}

double SearchedLuminaire::density(const Vec3& from, const Vec3& direction) const {
    return direction_density(*emitter_, from, direction);
}

}  // namespace candelabra

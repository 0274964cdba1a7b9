// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/shadow_ray.h"

#include "world/radiance.h"
#include "world/volumes.h"

namespace candelabra {

namespace {

/// As in POV-Ray, a clear surface does not dim light of a source if it lies no further than this,
/// along the way of light, behind another one that does, or from either end. So glasses that touch
/// each other, and things in a glass, are not darker for it.
constexpr double apart_for_sources = 1e-3;

/// The air that dims light on its way to a layer dims a ray which the layer follows, too. As in
/// POV-Ray, air dims light that radiosity gathers only if that is asked for.
AirOnWay air_on_way_to(const LitLayer& layer) {
    return layer.radiosity && !layer.radiosity->media ? AirOnWay::none : AirOnWay::followed;
}

/// The solids that contain a ray from the vertex.
EnteredSolids solids_along(const World& world, const Vertex& vertex, const Vec3& direction) {
    EnteredSolids inside(vertex.around.begin(), vertex.around.end());
    const bool behind = dot(direction, vertex.shading.geometric_normal) < 0;
    if (behind && vertex.material->transparent) world.pass(vertex.hit.primitive, inside);
    return inside;
}

}  // namespace

ShadowRay::ShadowRay(const ArrivingLight& at, const Vec3& direction, const Key& key)
    : at_(at),
      ray_{at.layer.vertex.position(), direction},
      key_(key),
      air_(air_on_way_to(at.layer)),
      around_(solids_along(at.world, at.layer.vertex, direction)) {}

ShadowRay::ShadowRay(const ArrivingLight& at, const Vec3& direction, const Key& key,
                     const SourceRules& rules)
    : at_(at),
      ray_{at.layer.vertex.position(), direction},
      key_(key),
      air_(rules.air),
      apart_(apart_for_sources),
      photons_(rules.photons),
      around_(solids_along(at.world, at.layer.vertex, direction)) {}

WayOfLight ShadowRay::way(double distance, bool ends) const {
    return {.ray = ray_,
            .tolerance = at_.layer.vertex.tolerance(),
            .distance = distance,
            .ends = ends,
            .around = {around_.data(), around_.size()},
            .apart = apart_,
            .air = air_};
}

Rgb ShadowRay::left(double distance) const {
    const Rgb left = light_left(at_.world, way(distance, true), key_);
    const bool brought =
        at_.photons && left != Rgb(0) && at_.layer.collects() &&
        target_between(at_.world, photons_, ray_, at_.layer.vertex.tolerance(), distance);
    return brought ? Rgb(0) : left;
}

Rgb ShadowRay::left_from_sky() const { return light_left(at_.world, way(far_away, false), key_); }

Rgb ShadowRay::left_by_air(double distance, double tolerance) const {
    const World& world = at_.world;
    const WayOfLight whole = way(distance, true);
    if (!world.appearance.any_clear && !world.appearance.any_left_out)
        return light_left(world, whole, key_);
    Hit hit;
    const bool is_free = !world.first_hit(ray_, whole.tolerance, RayKind::gathering, hit) ||
                         length(hit.position - ray_.origin) > distance - tolerance;
    return is_free ? left_on_free_way(world, whole, key_) : Rgb(0);
}

Rgb ShadowRay::emitted(const Luminaire& luminaire, double distance) const {
    const Rgb radiance =
        radiance_seen(at_.world, luminaire, {ray_, at_.layer.vertex.tolerance(), distance});
    return radiance == Rgb(0) ? radiance : radiance * left_by_lamp(luminaire, distance);
}

Rgb ShadowRay::emitted(const MediaBox& box, double distance) const {
    const SightOfVolume sight{
        ray_, at_.layer.vertex.tolerance(), distance, {around_.data(), around_.size()}};
    const Rgb radiance = volume_emission(at_.world, box.primitive, sight);
    return radiance == Rgb(0) ? radiance : radiance * left_by_lamp(box, distance);
}

Rgb ShadowRay::emitted(const Luminaire& luminaire, const Hit& hit, double distance) const {
    return left_by_lamp(luminaire, distance) *
           radiance_of(at_.world, luminaire, emitting_point(hit, ray_));
}

/// Fraction of a lamp's light that its own solid lets through, if other light passes it.
template <class Glowing>
Rgb ShadowRay::left_by_lamp(const Glowing& lamp, double distance) const {
    return candelabra::left_by_lamp(at_.world, lamp, way(distance, true), key_);
}

}  // namespace candelabra

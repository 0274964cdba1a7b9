// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/path_steps.h"

#include "base/elementary.h"
#include "scattering/microfacet.h"
#include "scattering/mirror.h"

namespace candelabra {

PathEnds::PathEnds(const Shot& shot, bool clear_sky, bool from_anywhere)
    : world_(*shot.world),
      starts_anywhere_(from_anywhere || shot.view.camera.parallel),
      origin_(shot.view.camera.location),
      around_(world_.containing(origin_)),
      clear_sky_(clear_sky) {}

PathState PathEnds::begin(const Ray& ray, const Key& key) {
    clear_ = 0;
    PathState path;
    path.ray = ray;
    path.key = key;
    if (starts_anywhere_ && ray.origin != origin_) {
        origin_ = ray.origin;
        around_ = world_.containing(origin_);
    }
    path.media = around_;
    return path;
}

Rgb PathEnds::background(const PathState& path, LightLedger& ledger) {
    const Rgb radiance = seen_behind(path);
    const Rgb seen = path.throughput * radiance;
    if (!world_.sky.light.empty()) ledger.add_visible(Lamp::sky(), seen);
    record_glow(ledger, path, seen);
    return radiance;
}

Rgb PathEnds::seen_behind(const PathState& path) {
    if (path.taken.by_shadow_rays && !world_.sky.light.empty()) return Rgb(0);
    const Vec3& direction = path.ray.direction;
    // As any light source, the sun lights surfaces itself: mirrors show its disc, and do not send
    // its light on.
    const bool shows_sun = path.bounces == 0 && !path.taken.by_shadow_rays;
    const Rgb sun = shows_sun ? world_.sun_radiance(direction) : Rgb(0);
    return sun + sky_behind(path);
}

Rgb PathEnds::sky_behind(const PathState& path) {
    const Vec3& direction = path.ray.direction;
    if (!clear_sky_) return world_.sky_radiance(direction);
    if (path.kind != RayKind::camera)
        return world_.sky_radiance(direction, world_.sky.background.mirrored());
    clear_ += path.clear * world_.sky_clear(direction);
    if (world_.rules.language_version < 3.7 && !world_.sky.daylight) return Rgb(0);
    return world_.sky_radiance(direction, world_.sky.background.covering());
}

void record_glow(LightLedger& ledger, const PathState& path, const Rgb& light) {
    if (path.kind == RayKind::camera && path.depth == 0) ledger.glow += light;
}

bool shows_emission(const World& world, const PathState& path, PrimitiveIndex primitive) {
    return !path.taken.lamps() || world.lights.luminaires.empty() ||
           world.luminaire_of(primitive) == no_primitive;
}

double shown_emission(const World& world, const PathState& path, PrimitiveIndex primitive) {
    const Vec3 towards = -path.ray.direction;
    const bool shows = primitive != no_primitive && shows_emission(world, path, primitive);
    return shows ? world.output(primitive, &towards) : 0;
}

PathState mirrored_path(const PathState& path, const Vertex& vertex, const Shading& s) {
    PathState next = path;
    next.go_on({vertex.position(), reflected_direction(s)}, vertex.tolerance(), Branch::reflection);
    next.kind = RayKind::reflected;
    next.taken.pass_mirror(vertex.material->photons);
    return next;
}

std::optional<FacetPath> facet_path(const PathState& path, const Vertex& vertex, const Shading& s) {
    const auto drawn = Microfacets(s).scatter(
        uniform(path.key, Purpose::facet_choice),
        {uniform(path.key, Purpose::facet_u), uniform(path.key, Purpose::facet_v)});
    if (!drawn || dot(drawn->direction, s.geometric_normal) <= 0) return std::nullopt;
    PathState next = path.dimmed(drawn->weight);
    next.go_on({vertex.position(), drawn->direction}, vertex.tolerance(), Branch::scattering);
    next.kind = RayKind::reflected;
    next.taken.scatter(!drawn->narrow, vertex.material->photons.collects);
    return FacetPath{next, drawn->weight};
}

double refraction_ratio(PathState& path, const Interface& surface) {
    if (surface.bands == 0) return surface.ratio;
    const auto number = static_cast<int>(uniform(path.key, Purpose::band_choice) *
                                         static_cast<double>(surface.bands));
    path.band = SpectralBand{std::min(number, surface.bands - 1), surface.bands};
    path.dim(hue(*path.band));
    return surface.ratio * math::pow(surface.dispersion, path.band->power());
}

PathState path_from_air(const PathState& path, const Vec3& position, const Vec3& direction) {
    PathState next = path;
    next.go_on({position, direction}, 0, Branch::medium_scattering);
    next.depth = path.depth;
    ++next.bounces;
    next.kind = RayKind::gathering;
    return next;
}

PathState gathering_path(const PathState& path, const Vertex& vertex, const Vec3& direction) {
    PathState next = path;
    next.go_on({vertex.position(), direction}, vertex.tolerance(), Branch::diffuse);
    next.depth = next.passed = 0;
    next.clear = 0;
    ++next.bounces;
    next.kind = RayKind::gathering;
    next.taken.scatter(true, vertex.material->photons.collects);
    return next;
}

PathState gathering_path_behind(const World& world, const PathState& path, const Vertex& vertex,
                                const Vec3& direction) {
    PathState next = gathering_path(path, vertex, direction);
    if (vertex.material->transparent)
        next.media = interface_at(world, path.media, vertex.hit.primitive, path.band).behind;
    return next;
}

PathState path_behind(const PathState& path, const Vertex& vertex, const Shading& s,
                      const Interface& surface, double ratio) {
    const bool straight = std::abs(ratio - 1) < 1e-10;
    PathState next = path;
    next.go_on({vertex.position(), straight ? path.ray.direction : refracted_direction(s, ratio)},
               vertex.tolerance(), Branch::refraction);
    if (straight) next.depth = path.depth;
    ++next.passed;
    next.media = surface.behind;
    return next;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/photon_path.h"

#include "medium/transmittance.h"
#include "scattering/bsdf.h"
#include "scattering/phase_function.h"
#include "transport/light_left.h"
#include "transport/surface_lobes.h"

#include <algorithm>

namespace candelabra {

namespace {

/// Maximum number of photons that are deposited along one segment through media.
constexpr double max_air_places = 8;
/// Fraction of the way to a surface after which a photon is still in front of it.
constexpr double before_surface = 1 - 1e-7;

}  // namespace

struct PhotonPaths::Journey {
    const PhotonShot& shot;
    double share;
    PathState path = {};
    double way = 0;  ///< length so far, from the lamp
    int met = 0;     ///< surfaces met, from the target's first one on
    int passed = 0;  ///< other surfaces, passed in a straight line
};

PhotonPaths::PhotonPaths(const Shot& shot)
    : world_(*shot.world), near_(shot.near), rules_(shading_rules(world_)) {
    const GlobalSettings& settings = world_.rules.settings;
    max_surfaces_ =
        static_cast<int>(settings.photons.max_trace_level.value_or(settings.max_trace_level));
    min_weight_ = settings.photons.adc_bailout.value_or(settings.adc_bailout);
    if (world_.facts.has_media)
        places_in_air_ =
            static_cast<int>(std::clamp(std::ceil(settings.photons.media), 0.0, max_air_places));
}

void PhotonPaths::follow(const PhotonShot& shot, const Key& key, double share,
                         std::vector<Photon>& found) const {
    Journey journey{shot, share};
    PathState& path = journey.path;
    path.ray = shot.ray;
    path.tolerance = shot.tolerance;
    path.key = key;
    while (journey.passed < max_surfaces_along) {
        Hit hit;
        const bool met = world_.first_hit(path.ray, path.tolerance, RayKind::light, hit);
        const double distance = met ? length(hit.position - path.ray.origin) : INFINITY;
        // In front of the first surface, where the photon has left its lamp, if only through an
        // opening.
        if (journey.met + journey.passed == 0 && met)
            path.media = world_.containing(path.ray.at(distance * before_surface));
        if (journey.met > 0) deposit_in_air(journey, distance, found);
        if (!met) return;
        journey.way += distance;
        path.throughput *= left_after(journey, distance, true);
        const Ray came = path.ray;
        const Vertex vertex = vertex_at(world_, came, hit, {path.media.data(), path.media.size()});
        const PhotonSurface& surface = vertex.material->photons;
        if (journey.met == 0 && surface.target != shot.target) {
            // Photons of another target are shot at that target.
            const bool other =
                surface.target != 0 && is_open(shot.ways.refraction, surface.ways.refraction);
            if (other || !pass(journey, vertex, came)) return;
            continue;
        }
        if (++journey.met > max_surfaces_) return;
        if (journey.met > 1) deposit(journey, vertex, found);
        const bool straight =
            journey.met > 1 && !is_refracted(journey, surface) && !is_reflected(journey, surface);
        if (straight ? !pass(journey, vertex, came) : !scatter(journey, vertex, path.key)) return;
    }
}

/// Deposits photons where media scatter light along a segment of the path: at points spread over
/// the part near the scene, and at one point of the rest if the segment leads far away.
void PhotonPaths::deposit_in_air(const Journey& journey, double distance,
                                 std::vector<Photon>& found) const {
    if (places_in_air_ == 0) return;
    const PathState& path = journey.path;
    const bool ends = std::isfinite(distance);
    MediaList all;
    add_followed(world_, {path.media.data(), path.media.size()}, ends, all);
    static const Material air;
    const Material& around = path.media.empty() ? air : world_.material(path.media.back());
    if (!collects_photons(view_of(all)) || !reaches(journey, around)) return;
    const auto add = [&](double way, double stands_for) {
        const Rgb left =
            attenuation(innermost(world_, path.media), way) * left_after(journey, way, ends);
        const Rgb power = journey.shot.power_after(journey.way + way) * path.throughput * left *
                          (journey.share * stands_for);
        if (power != Rgb(0))
            found.push_back({path.ray.at(way), glm::vec3(path.ray.direction), glm::vec3(0),
                             glm::vec3(vec3_of(power)), 0, journey.shot.lamp});
    };
    const double near = length(path.ray.origin - near_.centre()) + length(near_.size()),
                 end = std::min(distance, end_of_air), until = std::min(near, end);
    const double u = uniform(path.key, Purpose::media_distance);
    for (int i = 0; i < places_in_air_; ++i)
        add(until * (i + u) / places_in_air_, until / places_in_air_);
    if (!(end > near)) return;
    const double share = 1 - near / end, way = near / (1 - u * share);
    add(way, share * way * way / near);
}

/// Fraction of the photon's light that the air leaves after a distance. Photons of light sources
/// are not attenuated by air outside of solids, as in POV-Ray; those of luminaires are by all that
/// attenuates a ray on the same way. `ends`: the photon meets a surface after the segment.
Rgb PhotonPaths::left_after(const Journey& journey, double distance, bool ends) const {
    const PathState& path = journey.path;
    const std::span<const PrimitiveIndex> solids(path.media.data(), path.media.size());
    const Key key = path.key.branched(Branch::medium);
    if (journey.shot.lamp.is_luminaire())
        return left_in_air(world_, {path.ray, {0, distance}, solids, ends}, key);
    MediaList media;
    if (ends) add_media(world_, solids, media);
    if (media.empty()) return Rgb(1);
    return transmittance(view_of(media), path.ray, {0, distance}, world_.pattern_scene(), key);
}

/// Continues straight through the surface, attenuated as a shadow ray is. Returns whether any light
/// passes.
bool PhotonPaths::pass(Journey& journey, const Vertex& vertex, const Ray& came) const {
    const Rgb left = StraightWay(world_, came, true).passed(vertex.hit, vertex.around);
    if (left == Rgb(0)) return false;
    PathState& path = journey.path;
    ++journey.passed;
    path.throughput *= left * left_inside(world_, path, vertex.hit);
    path.media = interface_at(world_, path.media, vertex.hit.primitive, path.band).behind;
    path.ray.origin = vertex.position();
    path.tolerance = vertex.tolerance();
    return true;
}

/// Whether a photon that continues behind the surface is refracted.
bool PhotonPaths::is_refracted(const Journey& journey, const PhotonSurface& surface) const {
    const bool straight = surface.target == 0 && surface.passed;
    return !straight && is_open(journey.shot.ways.refraction, surface.ways.refraction);
}

/// Whether the surface mirrors the photon. Light that luminaires send to a mirror which is not a
/// target is found from the camera.
bool PhotonPaths::is_reflected(const Journey& journey, const PhotonSurface& surface) const {
    return (surface.target != 0 || !journey.shot.lamp.is_luminaire()) &&
           is_open(journey.shot.ways.reflection, surface.ways.reflection);
}

/// Continues from a surface in one randomly chosen way. Returns false if the photon ends.
bool PhotonPaths::scatter(Journey& journey, const Vertex& vertex, const Key& key) const {
    const auto textures = visible_textures(world_, vertex);
    const VisibleTexture* texture = choose(textures, uniform(key, Purpose::texture_choice));
    return texture && go_on(journey, vertex, texture->layers);
}

bool PhotonPaths::go_on(Journey& journey, const Vertex& vertex, const Layers& layers) const {
    PathState& path = journey.path;
    const PhotonSurface& surface = vertex.material->photons;
    const LayerStack stack(world_, path, vertex, layers);
    // At the first surface light continues only where photons are refracted; at later ones, always.
    const bool bent = is_refracted(journey, surface);
    SurfaceLobes lobes(world_, rules_, path, vertex, stack);
    if (is_reflected(journey, surface))
        stack.visit([&](const LayerStack::Seen& layer) {
            lobes.add(layer, {.mirror = true, .facets = false, .diffuse = false});
        });
    if (bent || journey.met > 1) lobes.add_behind();
    const auto chosen = lobes.choose(uniform(path.key, Purpose::way_choice));
    if (!chosen) return false;
    const Lobe& lobe = chosen->lobe;
    const bool from_behind = lobe.kind == LobeKind::behind || lobe.kind == LobeKind::total;
    // The lobe of light from behind has what the interior leaves.
    const Rgb inside = from_behind ? Rgb(1) : left_inside(world_, path, vertex.hit);
    path.weight *= max_abs_component(inside * lobe.share);
    if (path.weight < min_weight_) return false;
    path.throughput *= inside * lobe.through / chosen->chance;
    if (from_behind && !bent) {
        path.media = stack.interface().behind;
        path.go_on({vertex.position(), path.ray.direction}, vertex.tolerance(), Branch::refraction);
        return true;
    }
    return lobes.follow(lobe, path);
}

/// Whether the light group of the photon's lamp lights objects of the material.
bool PhotonPaths::reaches(const Journey& journey, const Material& material) const {
    return journey.shot.lamp.is_luminaire() || world_.reaches(journey.shot.light_group, material);
}

/// Whether any layer reflects arriving light to the viewer.
bool PhotonPaths::answers(const Vertex& vertex) const {
    return std::ranges::any_of(visible_textures(world_, vertex), [&](const VisibleTexture& each) {
        return std::ranges::any_of(each.layers, [&](const Layer& layer) {
            return Bsdf(with_layer(world_, vertex, layer), rules_).answers_light();
        });
    });
}

void PhotonPaths::deposit(const Journey& journey, const Vertex& vertex,
                          std::vector<Photon>& found) const {
    if (!vertex.material->photons.collects || !reaches(journey, *vertex.material) ||
        !answers(vertex))
        return;
    const Rgb power =
        journey.shot.power_after(journey.way) * journey.path.throughput * journey.share;
    if (power == Rgb(0)) return;
    found.push_back({vertex.position(), glm::vec3(journey.path.ray.direction),
                     glm::vec3(vertex.hit.normal), glm::vec3(vec3_of(power)), 0,
                     journey.shot.lamp});
}

}  // namespace candelabra

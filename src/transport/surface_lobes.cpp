// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/surface_lobes.h"

#include "scattering/mirror.h"
#include "scattering/phong.h"

#include <cassert>
#include <numbers>

namespace candelabra {

namespace {

/// Whether a layer reflects and transmits no more than all light, as its finish says.
bool adds_no_light(const Shading& s) {
    const Finish& f = *s.finish;
    const bool mirrors = f.reflection.least != Vec3(0) || f.reflection.greatest != Vec3(0);
    const bool scatters = !f.microfacet.on && f.diffuse + f.diffuse_back > 1;
    return !scatters && (f.conserve_energy || !mirrors) && f.refraction <= 1 && f.brilliance >= 1 &&
           min_component(s.colour.rgb) >= 0 && max_component(s.colour.rgb) <= 1 &&
           s.colour.opacity() >= 0;
}

double weight_of(const Lobe& lobe) { return max_component(glm::abs(lobe.share)); }

}  // namespace

SurfaceLobes::SurfaceLobes(const World& world, const PathState& path, const Vertex& vertex,
                           const LayerStack& stack)
    : world_(world), path_(path), vertex_(vertex), stack_(stack), rules_(shading_rules(world)) {}

void SurfaceLobes::add(const LayerStack::Seen& layer, const LobeKinds& wanted) {
    const Shading scattering = layer.scattering();
    adds_no_light_ &= adds_no_light(layer.shading);
    const auto add = [&](LobeKind kind, const Vec3& through, const Vec3& share) {
        if (share != Vec3(0)) lobes_.push_back({kind, scattering, through, share});
    };
    const Vec3 through = layer.through * layer.below_mirror;
    if (wanted.mirror) {
        const Vec3 direction = reflected_direction(layer.shading);
        add(LobeKind::mirror, layer.reflected,
            layer.reflected * iridescence(layer.shading, rules_, direction));
    }
    if (!wanted.facets && !wanted.diffuse) return;
    const Bsdf bsdf(scattering, rules_);
    if (wanted.facets) add(LobeKind::facets, through, through * bsdf.facets_albedo());
    if (wanted.diffuse) add(LobeKind::diffuse, through, through * bsdf.diffuse_albedo());
}

void SurfaceLobes::add_behind() {
    if (!stack_.is_clear()) return;
    const Vec3 left =
        left_inside(world_, path_, vertex_.hit) * stack_.top().finish->refraction * stack_.behind();
    lobes_.push_back(
        {stack_.reflects_totally() ? LobeKind::total : LobeKind::behind, stack_.top(), left, left});
}

std::optional<SurfaceLobes::Choice> SurfaceLobes::choose(double u) const {
    double all = 0;
    Vec3 share(0);
    for (const Lobe& lobe : lobes_) {
        all += weight_of(lobe);
        share += lobe.share;
    }
    assert(vertex_.shading.both_sides || !adds_no_light_ || max_component(share) <= 1 + 1e-9);
    double target = u * all;
    for (const Lobe& lobe : lobes_) {
        const double own = weight_of(lobe);
        if (target < own) return Choice{lobe, own / all};
        target -= own;
    }
    return std::nullopt;
}

std::optional<PathState> SurfaceLobes::follow(const Lobe& lobe, PathState path) const {
    switch (lobe.kind) {
        case LobeKind::mirror:
            path = mirrored_path(path, vertex_, lobe.shading);
            path.dim(iridescence(lobe.shading, rules_, path.ray.direction));
            return path;
        case LobeKind::facets:
            if (const auto scattered = facet_path(path, vertex_, lobe.shading))
                return scattered->next;
            return std::nullopt;
        case LobeKind::diffuse:
            return follow_diffuse(lobe.shading, std::move(path));
        case LobeKind::behind:
            return follow_behind(lobe.shading, std::move(path));
        case LobeKind::total:
            return follow_total(lobe.shading, path);
    }
    return std::nullopt;
}

/// Samples a direction in front of the surface, behind it, or on both sides.
std::optional<PathState> SurfaceLobes::follow_diffuse(const Shading& s, PathState path) const {
    const Bsdf bsdf(s, rules_);
    const auto direction = bsdf.sample_diffuse(
        {uniform(path.key, Purpose::bounce_u), uniform(path.key, Purpose::bounce_v)});
    const double density = direction ? bsdf.diffuse_pdf(*direction) : 0;
    if (!(density > 0)) return std::nullopt;
    path.dim(bsdf.evaluate(*direction, diffuse_terms, 0) / (std::numbers::pi * density));
    path = gathering_path(path, vertex_, *direction);
    const bool from_behind = dot(*direction, s.geometric_normal) < 0;
    if (from_behind && vertex_.material->transparent) path.media = stack_.interface().behind;
    return path;
}

/// Where white light is split, the path has one of its colours from here on.
PathState SurfaceLobes::follow_behind(const Shading& s, PathState path) const {
    const Interface& surface = stack_.interface();
    const double ratio = refraction_ratio(path, surface);
    if (surface.bands > 0 && reflects_totally(s, ratio)) return follow_total(s, path);
    return path_behind(path, vertex_, s, surface, ratio);
}

/// Light that shadow rays have taken goes straight on instead of being reflected.
PathState SurfaceLobes::follow_total(const Shading& s, const PathState& path) const {
    PathState next = mirrored_path(path, vertex_, s);
    next.taken.by_shadow_rays = path.taken.by_shadow_rays;
    return next;
}

}  // namespace candelabra

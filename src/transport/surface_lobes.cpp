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
    const bool mirrors = f.reflection.least != Rgb(0) || f.reflection.greatest != Rgb(0);
    const bool amplifies =
        max_component(f.reflection.least) > 1 || max_component(f.reflection.greatest) > 1;
    const bool scatters = !f.microfacet.on && f.diffuse + f.diffuse_back > 1;
    return !scatters && !amplifies && (f.conserve_energy || !mirrors) && f.refraction <= 1 &&
           f.brilliance >= 1 && min_component(s.colour.rgb) >= 0 &&
           max_component(s.colour.rgb) <= 1 && s.colour.opacity() >= 0;
}

double weight_of(const Lobe& lobe) { return max_abs_component(lobe.share); }

}  // namespace

SurfaceLobes::SurfaceLobes(const World& world, const ShadingRules& rules, const PathState& path,
                           const Vertex& vertex, const LayerStack& stack)
    : world_(world), rules_(rules), path_(path), vertex_(vertex), stack_(stack) {}

void SurfaceLobes::add(const LayerStack::Seen& layer, const LobeKinds& wanted) {
    adds_no_light_ &= adds_no_light(layer.shading);
    if (wanted.mirror && layer.reflected != Rgb(0)) {
        const Vec3 direction = reflected_direction(layer.shading);
        const Rgb film = iridescence(layer.shading, rules_, direction);
        lobes_.push_back(
            {LobeKind::mirror, layer.scattering(), layer.reflected, layer.reflected * film});
    }
    if (!wanted.facets && !wanted.diffuse) return;
    const Bsdf bsdf(layer.scattering(), rules_);
    const Rgb through = layer.through * layer.below_mirror;
    const auto add = [&](LobeKind kind, const Rgb& albedo) {
        const Rgb share = through * albedo;
        if (share != Rgb(0)) lobes_.push_back({kind, bsdf.shading(), through, share});
    };
    if (wanted.facets) add(LobeKind::facets, bsdf.facets_albedo());
    if (wanted.diffuse) add(LobeKind::diffuse, bsdf.diffuse_albedo());
}

void SurfaceLobes::add_behind() {
    if (!stack_.is_clear()) return;
    const Rgb left =
        left_inside(world_, path_, vertex_.hit) * stack_.top().finish->refraction * stack_.behind();
    lobes_.push_back(
        {stack_.reflects_totally() ? LobeKind::total : LobeKind::behind, stack_.top(), left, left});
}

std::optional<SurfaceLobes::Choice> SurfaceLobes::choose(double u) const {
    double all = 0;
    Rgb share(0);
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

bool SurfaceLobes::follow(const Lobe& lobe, PathState& path) const {
    switch (lobe.kind) {
        case LobeKind::mirror:
            path = mirrored_path(path, vertex_, lobe.shading);
            path.dim(iridescence(lobe.shading, rules_, path.ray.direction));
            return true;
        case LobeKind::facets:
            if (auto scattered = facet_path(path, vertex_, lobe.shading)) {
                path = std::move(scattered->next);
                return true;
            }
            return false;
        case LobeKind::diffuse:
            return follow_diffuse(lobe.shading, path);
        case LobeKind::behind:
            follow_behind(lobe.shading, path);
            return true;
        case LobeKind::total:
            follow_total(lobe.shading, path);
            return true;
    }
    return false;
}

/// Samples a direction in front of the surface, behind it, or on both sides.
bool SurfaceLobes::follow_diffuse(const Shading& s, PathState& path) const {
    const Bsdf bsdf(s, rules_);
    const auto direction = bsdf.sample_diffuse(
        {uniform(path.key, Purpose::bounce_u), uniform(path.key, Purpose::bounce_v)});
    const double density = direction ? bsdf.diffuse_pdf(*direction) : 0;
    if (!(density > 0)) return false;
    path.dim(bsdf.evaluate(*direction, diffuse_terms, 0) / (std::numbers::pi * density));
    path = gathering_path(path, vertex_, *direction);
    const bool from_behind = dot(*direction, s.geometric_normal) < 0;
    if (from_behind && vertex_.material->transparent) path.media = stack_.interface().behind;
    return true;
}

/// Where white light is split, the path has one of its colours from here on.
void SurfaceLobes::follow_behind(const Shading& s, PathState& path) const {
    const Interface& surface = stack_.interface();
    const double ratio = refraction_ratio(path, surface);
    if (surface.bands > 0 && reflects_totally(s, ratio)) return follow_total(s, path);
    path = path_behind(path, vertex_, s, surface, ratio);
}

/// Shadow rays go straight on where light would be reflected totally. So does a path whose light
/// they have taken: if it were reflected, it would bring light of another direction in addition.
void SurfaceLobes::follow_total(const Shading& s, PathState& path) const {
    path = path.taken.by_shadow_rays ? path_behind(path, vertex_, s, stack_.interface(), 1)
                                     : mirrored_path(path, vertex_, s);
}

}  // namespace candelabra

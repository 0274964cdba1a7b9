// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/trace.h"

#include <algorithm>

namespace {

// Clear surfaces in a row that a ray may pass; a stop for rays that rounding keeps in one place.
constexpr int most_passed = 1000;

enum Bounce : std::uint32_t { reflection, refraction };

Vec3 mirrored(const Vec3& direction, const Vec3& normal) {
    return direction - 2 * dot(direction, normal) * normal;
}

}  // namespace

Tracer::Tracer(const World& world, int shadow_rays)
    : world_(world), direct_light_(world, shadow_rays) {
    if (world.any_transparent && !world.camera.parallel)
        around_camera_ = world.containing(world.camera.location);
}

Vec3 Tracer::radiance(const Ray& ray, const Key& key) {
    ++rays_.camera;
    Path path;
    path.ray = ray;
    path.key = key;
    path.solids = world_.any_transparent && world_.camera.parallel ? world_.containing(ray.origin)
                                                                   : around_camera_;
    return follow(path);
}

double Tracer::ior(const Solids& solids) const {
    if (solids.empty()) return 1;
    const auto& interior = world_.material(solids.back()).interior;
    return interior ? interior->ior : 1;
}

Tracer::Interface Tracer::interface_at(const Path& path, PrimitiveIndex primitive) const {
    Interface result{1, path.solids};
    Solids& behind = result.behind;
    const auto inside = std::ranges::find(behind, world_.solid(primitive),
                                          [&](PrimitiveIndex p) { return world_.solid(p); });
    if (inside == behind.end()) {
        behind.push_back(primitive);
    } else {
        const bool innermost = inside + 1 == behind.end();
        behind.erase(inside);
        if (!innermost) return result;  // leaving one of two that overlap bends nothing
    }
    result.ratio = ior(path.solids) / ior(behind);
    return result;
}

Vec3 Tracer::follow(const Path& path) {
    if (path.level >= world_.settings.max_trace_level || path.weight < world_.settings.adc_bailout)
        return Vec3(0);
    Hit hit;
    if (!world_.first_hit(path.ray, path.tolerance, path.kind, hit))
        return world_.background.radiance();

    const Shading s = shading_at(world_, path.ray, hit);
    Vec3 result = own_radiance(world_, s) + direct_light_(s, path.key, rays_);

    const Vec3 passing = s.colour.passing();
    const bool clear = grey(passing) > world_.settings.adc_bailout;
    const Finish& finish = *s.finish;
    const bool mirror = finish.reflection.greatest != Vec3(0) || finish.reflection.least != Vec3(0);
    if (!clear && !mirror) return result;

    const Interface surface =
        clear || finish.reflection.fresnel ? interface_at(path, hit.primitive) : Interface{1, {}};
    const Vec3 amount = reflectivity(s, surface.ratio);
    const double cosine = -dot(s.view, s.normal);
    const bool total = clear && surface.ratio * surface.ratio * (1 - cosine * cosine) > 1;
    if (total) return result + reflected(path, s, Vec3(1));
    if (amount != Vec3(0)) result += reflected(path, s, amount);
    if (clear) {
        const Vec3 kept =
            finish.conserve_energy ? glm::clamp(Vec3(1) - amount, Vec3(0), Vec3(1)) : Vec3(1);
        result += transmitted(path, s, surface, passing * kept);
    }
    return result;
}

Vec3 Tracer::reflected(const Path& path, const Shading& s, const Vec3& amount) {
    Vec3 direction = mirrored(path.ray.direction, s.normal);
    // A smooth normal may mirror the ray into the surface; the true one brings it out again.
    if (dot(direction, s.true_normal) < 0) direction = mirrored(direction, s.true_normal);
    Path next = path;
    next.ray = {s.position, unit(direction)};
    next.tolerance = s.tolerance;
    next.level = path.level + 1;
    next.weight = path.weight * max_component(amount);
    next.kind = RayKind::reflected;
    next.key = path.key.bounced(reflection);
    ++rays_.scattered;
    const Vec3 seen = follow(next);
    const double exponent = s.finish->reflection.exponent;
    if (exponent == 1) return amount * seen;
    const auto dimmed = [&](double channel) {
        return channel > 0 ? std::pow(channel, 1 / exponent) : 0.0;
    };
    return amount * Vec3(dimmed(seen.x), dimmed(seen.y), dimmed(seen.z));
}

Vec3 Tracer::transmitted(const Path& path, const Shading& s, const Interface& surface,
                         const Vec3& share) {
    const bool straight = std::abs(surface.ratio - 1) < 1e-10;
    Path next = path;
    next.ray = {s.position, path.ray.direction};
    if (!straight) {
        const double cosine = -dot(s.view, s.normal);
        const double behind = std::sqrt(1 - surface.ratio * surface.ratio * (1 - cosine * cosine));
        next.ray.direction =
            unit(surface.ratio * s.view + (surface.ratio * cosine - behind) * s.normal);
    }
    next.tolerance = s.tolerance;
    next.level = path.level + (straight ? 0 : 1);
    next.passed = path.passed + 1;
    if (next.passed > most_passed) return Vec3(0);
    next.weight = path.weight * max_component(share);
    next.key = path.key.bounced(refraction);
    next.solids = surface.behind;
    ++rays_.scattered;
    return share * follow(next);
}

// SPDX-License-Identifier: GPL-3.0-or-later
#include "transport/subsurface.h"

#include "base/circle.h"
#include "base/elementary.h"
#include "scattering/mirror.h"
#include "surface/quality.h"

#include <cmath>
#include <numbers>
#include <optional>

namespace candelabra {

namespace {

using std::numbers::pi;

/// Light with a smaller factor than this is subject to Russian roulette.
constexpr double min_factor = 0.2;

/// Fraction of the requested samples that gives POV-Ray's noise with that many, as samples here are
/// spread evenly. Measured on a flat surface with 30, 100 and 400 samples.
constexpr double needed = 1.0 / 3;

double fraction(double x) { return x - std::floor(x); }

class Inside {
public:
    Inside(const World& world, DirectLight& lights, const LitLayer& layer, LightLedger& ledger)
        : world_(world),
          lights_(lights),
          layer_(layer),
          s_(layer.scatterer.bsdf().shading()),
          solid_(world.solid(layer.vertex.hit.primitive)),
          rules_(shading_rules(world)),
          ledger_(ledger),
          ior_(interior() ? std::fmax(interior()->ior, 1) : 1),
          dipole_(s_.colour.rgb * s_.finish->diffuse, free_path(world, s_), ior_) {
        const auto [x, y] = perpendiculars(s_.geometric_normal);
        axes_ = {s_.geometric_normal, x, y};
        const double slowest = min_component(dipole_.falloff());
        reach_ = std::fmin(30 / slowest, 1000 * max_component(dipole_.heights(1)));
        entry_.diffuse = 1;
        times_ = is_plane(world, layer.vertex.hit.primitive) ? 2 : 1;
    }

    Rgb seen(const PathState& path) {
        const SubsurfaceSettings& wanted = world_.rules.settings.subsurface;
        const auto count = [&](int samples) {
            return static_cast<int>(std::ceil(needed * samples * std::fmin(path.weight, 1)));
        };
        const double out = s_.opacity * (1 - fresnel(std::fmax(-dot(s_.view, s_.normal), 0), ior_));
        return mean(count(wanted.samples), out * times_,
                    path.key.branched(Branch::subsurface_spread),
                    [&](const Draw& d) { return spread_light(d); }) +
               mean(count(wanted.single_samples), out, path.key.branched(Branch::subsurface_once),
                    [&](const Draw& d) { return light_scattered_once(d); });
    }

private:
    const Interior* interior() const { return layer_.vertex.material->interior.get(); }

    /// Whether the primitive is a plane. POV-Ray sends rays to the surface from a point below it,
    /// and drops those that miss: for a plane these are half of them, so that the light comes out
    /// twice as bright.
    static bool is_plane(const World& world, PrimitiveIndex primitive) {
        const PlacedShape* placed = world.geometry.shape(primitive);
        return placed && std::holds_alternative<Plane>(placed->shape);
    }

    /// Mean free path in the scene's units. A channel without any has a very short one.
    static Rgb free_path(const World& world, const Shading& s) {
        const Rgb& way = s.finish->subsurface.translucency;
        return max(way, Rgb(1e-4 * max_component(way))) / world.rules.settings.mm_per_unit;
    }

    /// One of several samples: its key, and three random numbers below 1.
    struct Draw {
        Key key;
        double choice, u, v;
        Rgb throughput;  ///< of the light that the sample finds
    };

    /// Mean of `count` samples, times a factor, which is also part of the light's throughput. The
    /// samples' three numbers are jointly well distributed: one by steps of equal length, the
    /// others by those of the plastic number (Roberts, "The Unreasonable Effectiveness of
    /// Quasirandom Sequences", 2018).
    template <class Once>
    Rgb mean(int count, double factor, const Key& key, const Once& each) {
        if (count == 0) return Rgb(0);
        constexpr double plastic = 1.3247179572447461;
        const Rgb throughput = layer_.throughput * (factor / count);
        const Vec3 start(uniform(key, Purpose::subsurface_choice),
                         uniform(key, Purpose::subsurface_u), uniform(key, Purpose::subsurface_v));
        Rgb sum(0);
        for (int i = 0; i < count; ++i)
            sum += each(Draw{key.part(count, i), (i + start.x) / count,
                             fraction(start.y + i / plastic),
                             fraction(start.z + i / (plastic * plastic)), throughput});
        return sum * (factor / count);
    }

    /// Returns the next crossing of the solid on the line; `from` moves behind it.
    std::optional<Hit> next(const Ray& ray, double& from, double until) const {
        std::optional<Hit> crossing;
        world_.along(ray, from, RayKind::light, [&](Hit& hit, double distance) {
            if (distance > until) return false;
            hit.tolerance = std::fmax(hit.tolerance, 1e-9 * reach_);
            if (world_.solid(hit.primitive) != solid_) return true;
            from = distance + hit.tolerance;
            crossing = hit;
            return false;
        });
        return crossing;
    }

    /// The vertex at which light enters the solid.
    Vertex entry(const Hit& hit) const {
        Vertex vertex{hit, {}, layer_.vertex.material};
        Shading& e = vertex.shading;
        e.position = hit.position;
        e.normal = hit.smooth_normal;
        e.geometric_normal = hit.normal;
        e.view = -hit.normal;
        e.finish = &entry_;
        e.colour = Colour{Rgb(1), 0, 0};
        return vertex;
    }

    /// Pdf, per area of the surface, of a line through the point: lines are parallel to one of the
    /// axes, and their distance from the visible point is distributed as the light of the dipole's
    /// sources.
    double density(const Vec3& offset, const Vec3& normal) const {
        double sum = 0;
        for (std::size_t i = 0; i < axes_.size(); ++i) {
            const double along = dot(offset, axes_[i]);
            const double radius2 = std::fmax(dot(offset, offset) - along * along, 0);
            sum += chances[i] * std::abs(dot(normal, axes_[i])) * disc_density(radius2);
        }
        return sum;
    }

    double disc_density(double radius2) const {
        double sum = 0;
        for (int source = 0; source < 2; ++source)
            for (int channel = 0; channel < 3; ++channel) {
                const double height = dipole_.heights(source)[channel];
                const double way2 = radius2 + height * height;
                sum += height / (2 * pi * way2 * std::sqrt(way2));
            }
        return sum / 6;
    }

    /// Returns the squared radius of the disc that holds this share of disc_density.
    double radius2(double share) const {
        const double beyond = 6 * (1 - share);
        double result = 0;
        for (int step = 0; step < 8; ++step) {
            double sum = 0, slope = 0;
            for (int source = 0; source < 2; ++source)
                for (int channel = 0; channel < 3; ++channel) {
                    const double height = dipole_.heights(source)[channel];
                    const double way2 = result + height * height;
                    const double part = height / std::sqrt(way2);
                    sum += part;
                    slope += part / way2;
                }
            // Newton's method, on a function that is nearly linear.
            const double change = (sum * sum / (beyond * beyond) - 1) * sum / slope;
            result += change;
            if (std::abs(change) < 1e-9 * result) break;
        }
        return std::fmax(result, 0);
    }

    /// Light that enters where a sampled line crosses the solid's surface.
    Rgb spread_light(const Draw& draw) {
        const std::size_t axis = draw.u < chances[0] ? 0 : draw.u < chances[0] + chances[1] ? 1 : 2;
        const double radius = std::sqrt(radius2(draw.choice));
        if (radius > reach_) return Rgb(0);
        const double angle = 2 * pi * draw.v;
        const Vec3 aside = on_circle(angle, axes_[(axis + 1) % 3], axes_[(axis + 2) % 3]);
        const Ray line{s_.position + radius * aside - reach_ * axes_[axis], axes_[axis]};
        Rgb sum(0);
        double from = 0;
        for (std::uint32_t branch = 0; const auto hit = next(line, from, 2 * reach_); ++branch) {
            const Vec3 offset = hit->position - s_.position;
            Rgb factor = dipole_.spread(dot(offset, offset)) / density(offset, hit->normal);
            const Key own = draw.key.with_branch(branch);
            // Russian roulette for small factors.
            const double kept = std::fmin(1, max_component(factor) / min_factor);
            if (!(uniform(own, Purpose::subsurface_roulette) < kept)) continue;
            factor /= kept;
            sum += factor * light_at(entry(*hit), draw.throughput * factor, own);
        }
        return sum;
    }

    Rgb light_at(const Vertex& vertex, const Rgb& throughput, const Key& key) {
        const Bsdf bsdf = Bsdf::entering(vertex.shading, rules_, ior_);
        return lights_({vertex, bsdf, layer_.light, throughput}, key, ledger_);
    }

    /// Light of a source that is scattered once, on the refracted ray inside the solid.
    Rgb light_scattered_once(const Draw& draw) {
        if (world_.lights.sources.empty() || !layer_.light.has_any(all_sources)) return Rgb(0);
        const double cosine = std::fmax(-dot(s_.view, s_.geometric_normal), 0);
        const double behind = std::sqrt(1 - (1 - cosine * cosine) / (ior_ * ior_));
        const Ray inner{s_.position,
                        unit(s_.view / ior_ + (cosine / ior_ - behind) * s_.geometric_normal)};
        const double u = 3 * draw.choice;
        const Rgb& extinction = dipole_.extinction();
        const double way = -math::log(1 - draw.u) / extinction[static_cast<int>(u)];
        const Rgb left = math::exp(-extinction * way);
        const Rgb densities = extinction * left;  // of the channels
        const double chance = (densities.r + densities.g + densities.b) / 3;
        double from = layer_.vertex.tolerance();
        if (!(chance > 0) || next(inner, from, way)) return Rgb(0);
        const auto count = static_cast<double>(world_.lights.sources.size());
        const auto light = static_cast<std::uint32_t>(count * draw.v);
        const Rgb factor = dipole_.scattering() * left * (count / (4 * pi * chance));
        return factor * light_from(light, inner.at(way), draw.throughput * factor, draw.key);
    }

    /// Light of a source at a point inside. The path from the source is straight, but as long
    /// inside as the refracted one. As in POV-Ray, the light per area of the surface counts.
    Rgb light_from(std::uint32_t light, const Vec3& point, const Rgb& throughput, const Key& key) {
        const PointLight& source = world_.lights.sources[light];
        const Vec3 direction = incidence(source, source.location, point).direction;
        double from = layer_.vertex.tolerance();
        const auto way_in = next({point, direction}, from, 1e20);
        if (!way_in) return Rgb(0);
        const Vertex vertex = entry(*way_in);
        const double cosine = dot(vertex.shading.normal, direction);
        if (!(cosine > 0)) return Rgb(0);
        const Bsdf bsdf = Bsdf::entering(vertex.shading, rules_, ior_);
        const double bent = std::sqrt(1 - (1 - cosine * cosine) / (ior_ * ior_));
        const double way = length(way_in->position - point) * cosine / bent;
        const Rgb left = math::exp(-dipole_.extinction() * way);
        return left * lights_.from_source(light, 1, {vertex, bsdf, all_sources, throughput * left},
                                          key, ledger_);
    }

    static constexpr auto chances = std::to_array<double>({0.75, 0.125, 0.125});

    const World& world_;
    DirectLight& lights_;
    const LitLayer& layer_;
    const Shading& s_;
    std::uint32_t solid_;
    ShadingRules rules_;
    LightLedger& ledger_;
    double ior_;
    Dipole dipole_;
    std::array<Vec3, 3> axes_;
    double reach_;  ///< distance beyond which light that enters does not count
    double times_;  ///< factor on spread light
    Finish entry_;
};

}  // namespace

bool scatters_inside(const World& world, const Shading& s) {
    return world.rules.settings.subsurface.on && world.rules.quality >= quality_full &&
           s.finish->subsurface.translucency != Rgb(0) && s.finish->diffuse != 0 &&
           !s.finish->microfacet.on;
}

Rgb light_from_inside(const World& world, DirectLight& lights, const LitLayer& layer,
                      const PathState& path, LightLedger& ledger) {
    return Inside(world, lights, layer, ledger).seen(path);
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/sample.h"

#include "camera/sample_turns.h"
#include "film/develop.h"
#include "photometry/light_colour.h"
#include "transport/camera_ray.h"

#include <numbers>
#include <variant>

namespace candelabra {

namespace {

std::vector<Integrator> integrators_of_moments(const RenderPlan& plan, const Tracing& tracing) {
    std::vector<Integrator> integrators;
    for (std::size_t i = 0; i < plan.shot.moments(); ++i) {
        const Shot& shot = plan.shot.moment(i);
        Tracing there = tracing;
        if (i > 0 && plan.sent) {
            const int seed = plan.settings.seed, threads = plan.settings.threads;
            // What the plan leaves to paths is left to them at all moments.
            there.sent = plan.sent.reflected ? SentLight::of(shot, seed, threads)
                                             : SentLight{photons_of(shot, seed, threads)};
        }
        integrators.emplace_back(shot, there);
    }
    return integrators;
}

Tracing tracing_of(const RenderPlan& plan, const RenderHooks& hooks) {
    return {plan.shadow_rays, hooks.counts_lights || hooks.aovs.lights, hooks.lamps != nullptr,
            plan.sent, hooks.aovs.alpha};
}

std::vector<Integrator> meters_of(const RenderPlan& plan, const RenderHooks& hooks) {
    if (!hooks.aovs.illuminance) return {};
    return integrators_of_moments(plan, {.shadow_rays = plan.shadow_rays, .sent = plan.sent});
}

/// Adds a colour to three sums.
void add_colour(const Rgb& colour, std::span<ExactSum> sums, std::size_t first) {
    for (int c = 0; c < 3; ++c) sums[first + static_cast<std::size_t>(c)].add(colour[c]);
}

}  // namespace

SampleTracer::SampleTracer(const RenderPlan& plan, const RenderHooks& hooks, const Film& film)
    : plan_(&plan),
      hooks_(&hooks),
      film_(&film),
      filter_(make_handle<PixelFilter>(plan.shot.view.film.filter())),
      exposure_(plan.shot.view.film.exposure_factor()),
      integrators_(integrators_of_moments(plan, tracing_of(plan, hooks))),
      meters_(meters_of(plan, hooks)) {}

void SampleTracer::prepare(std::uint32_t sample) const {
    for (const Integrator& each : integrators_) each.prepare(sample);
}

PicturePoint SampleTracer::point(int x, int y) const {
    return {x, y, film_->width(), film_->height()};
}

PrimaryHit SampleTracer::seen_at_middle(int x, int y) const {
    return candelabra::seen_at_middle(hooks_->aovs, plan_->shot, point(x, y));
}

void SampleTracer::add_rays(LightLedger& rays) const {
    for (const Integrator& each : integrators_) rays += each.ledger();
}

FilteredPlace SampleTracer::place(const Key& key) const {
    const auto by_rule = std::visit([&](const auto& rule) { return rule.place(key); }, plan_->rule);
    if (by_rule) return {*by_rule};
    // A blurred picture's rays are always spread over the pixel, as in POV-Ray.
    if (!plan_->settings.antialias && plan_->shot.view.camera.lens_radius == 0) return {Vec2(0.5)};
    return filter_->place(key);
}

SeenSample SampleTracer::look(int x, int y, std::uint32_t sample, std::span<ExactSum> extra) {
    Key key;
    key.pixel = mix(static_cast<std::uint64_t>(plan_->settings.seed)) + film_->index(x, y);
    key.sample = sample;
    const std::size_t moment =
        item_in_turn(Turns::moments, static_cast<std::uint32_t>(integrators_.size()), key);
    const Shot& shot = plan_->shot.moment(moment);
    const FilteredPlace in_pixel = place(key);
    const Ray ray = ray_through(shot, point(x, y), in_pixel.place, key);
    Integrator& integrator = integrators_[moment];
    const std::uint64_t before_rays = integrator.ledger().shadow;
    const Rgb colour = integrator.radiance(ray, key);
    const auto rays = static_cast<std::uint32_t>(integrator.ledger().shadow - before_rays);
    if (integrator.cut() && hooks_->cut) hooks_->cut(x, y);
    if (!extra.empty() && !in_pixel.negative) {
        gather(colour, ray, key, moment, extra);
    } else if (!extra.empty()) {
        apart_.assign(extra.size(), ExactSum());
        gather(colour, ray, key, moment, apart_);
        for (std::size_t i = 0; i < extra.size(); ++i) extra[i].subtract(apart_[i]);
    }
    if (hooks_->lamps) {
        std::vector<LampPart>& parts = integrator.ledger().parts;
        hooks_->lamps->add(x, y, parts, in_pixel.negative);
        parts.clear();
    }
    return {colour, rays, in_pixel.negative};
}

/// Adds a sample's values besides its colour, after all rays that they take: work that ends in the
/// middle of a sample leaves none of it.
void SampleTracer::gather(const Rgb& colour, const Ray& ray, const Key& key, std::size_t moment,
                          std::span<ExactSum> sums) {
    const Aovs& aovs = hooks_->aovs;
    const World& world = *plan_->shot.moment(moment).world;
    const double lux = aovs.illuminance ? illuminance(ray, key, moment) : 0;
    gather_sample(aovs, world, ray, integrators_[moment], sums);
    if (aovs.smooth) add_colour(compressed(colour, exposure_), sums, aovs.first_smooth());
    if (aovs.squares) {
        const Rgb reflected = colour - integrators_[moment].ledger().glow;
        add_colour(reflected * reflected, sums, aovs.first_square());
    }
    if (aovs.luminance)
        sums[aovs.first_luminance()].add(
            world.rules.settings.light_units().luminance(light_luminance(colour)));
    if (aovs.illuminance) sums[aovs.first_illuminance()].add(lux);
}

/// Illuminance in lux of the first surface on a ray, on the side that is seen; 0 if there is none.
double SampleTracer::illuminance(const Ray& ray, const Key& key, std::size_t moment) {
    const World& world = *plan_->shot.moment(moment).world;
    Hit hit;
    if (ray.direction == Vec3(0) || !world.first_hit(ray, 0, RayKind::camera, hit)) return 0;
    const Vec3 facing = dot(hit.normal, ray.direction) > 0 ? -hit.normal : hit.normal;
    const WhiteElement element(hit.position, facing, hit.tolerance);
    const Rgb shown = meters_[moment].element_radiance(element, key);
    return std::numbers::pi * world.rules.settings.light_units().luminance(light_luminance(shown));
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pilot.h"

#include "base/gamma.h"
#include "base/parallel.h"
#include "base/work_watch.h"
#include "transport/camera_ray.h"

#include <algorithm>
#include <vector>

namespace candelabra {

namespace {

/// Number of samples that are taken at each place that is tried.
constexpr int samples_of_place = 4;
/// Cost of a light path with its reflected luminaires, in rays.
constexpr double rays_of_light_path = 6;
/// Cost of the choice among lights at a hit and of the survey of its cell, in rays, where cells are
/// surveyed: "Which way pays".
constexpr double cost_of_lit_hit = 3;
/// Cost of a sample's choice among reflected luminaires, in rays, with the cells that are made anew
/// for each generation, where these are as many as that, and in proportion where they are fewer.
constexpr double cost_of_choice = 6, many_reflected = 1800;
/// Cost of a camera ray, with shading and the weights of luminaires, in shadow rays.
constexpr double cost_of_camera_ray = 1.2;
/// Maximum number of shadow rays for each draw among lights, and how many times as many are tried
/// where all samples of a pixel begin with the same ray.
constexpr int max_pilot_rays = 4, many_times = 4;
/// Maximum number of rays for one of the pilot's camera rays: what is behind so many reflections
/// does not matter for the choice.
constexpr std::uint64_t max_rays_of_pilot = 10'000;
/// Maximum standard deviation of one sample's display value (0 to 1) in quiet light: three steps of
/// an 8-bit picture.
constexpr double quiet_deviation = 3.0 / 255;
/// Maximum number of pixels tried in each direction, and minimum number of pixels for each of them.
constexpr int max_across = 16;
constexpr int pixels_for_each = 4;
/// Minimum number of pixels tried that tell which of two ways makes less noise: rare bright light
/// is missed by fewer. Smaller pictures are made by paths, which cost nothing in advance.
constexpr int least_tried = 64;
/// Minimum number of pixels of a picture for each of those tried with many shadow rays: in smaller
/// pictures the trial would take too much of the time.
constexpr std::uint64_t pixels_for_many = 128;

double squared(double x) { return x * x; }

double displayed(double radiance) { return from_linear(std::fmax(radiance, 0), display_gamma); }

/// A pixel of a grid that covers the picture.
struct Trial {
    int column, row, columns, rows;
};

/// Adds the noise of a pixel: of `places` in it, 1 or 2. One place tells only that of light.
void try_pixel(Integrator& integrator, const Shot& shot, const RenderSettings& settings,
               const Trial& trial, int places, PilotNoise& noise) {
    const auto number = static_cast<std::uint64_t>(trial.row * trial.columns + trial.column);
    const double x = std::floor((trial.column + 0.5) * settings.width / trial.columns),
                 y = std::floor((trial.row + 0.5) * settings.height / trial.rows);
    const auto seen = [&](std::uint32_t place, std::uint32_t light) {
        Key key;
        // Outside of the picture, whose samples must be independent of these.
        key.pixel = mix(~number) + place;
        key.sample = light;
        const Key where = {key.pixel, 0, 0, 0};
        const bool spread = settings.antialias;
        const double dx = spread ? uniform(where, Purpose::pixel_x) : 0.5,
                     dy = spread ? uniform(where, Purpose::pixel_y) : 0.5;
        const double u = (x + dx) / settings.width - 0.5, v = 0.5 - (y + dy) / settings.height;
        // Values above white are clipped in pictures, and so is their noise.
        const double bright = grey(integrator.radiance(camera_ray(shot, u, v, where), key));
        return std::fmin(bright * shot.view.film.exposure_factor(), 1.0);
    };
    ++noise.places;
    const double a = seen(0, 0), b = seen(0, 1);
    if (places == 1) {
        noise.of_light += squared(a - b) / 2;
        noise.shown += squared(displayed(a) - displayed(b)) / 2;
        return;
    }
    // Two estimates of the light at each of two places. The product of the differences between the
    // places estimates the variance due to the camera, regardless of the noise of light.
    const double c = seen(1, 0), d = seen(1, 1);
    noise.of_light += (squared(a - b) + squared(c - d)) / 4;
    noise.of_camera += (a - c) * (b - d) / 2;
    noise.shown +=
        (squared(displayed(a) - displayed(b)) + squared(displayed(c) - displayed(d))) / 4;
}

/// The pixels that are tried: a grid over the picture.
struct TrialGrid {
    int columns, rows;

    explicit TrialGrid(const RenderSettings& settings)
        : columns(std::clamp(settings.width / pixels_for_each, 1, max_across)),
          rows(std::clamp(settings.height / pixels_for_each, 1, max_across)) {}

    int tried() const { return columns * rows; }
};

/// What is tried.
struct Tried {
    const Shot& shot;
    const RenderSettings& settings;
    const std::optional<SentLight>& sent;
    const std::function<bool()>& cancelled;
};

/// See pilot_noise(); `places`: in each pixel that is tried.
PilotNoise noise_of_places(const Tried& tried, const ShadowRays& rays, int places) {
    const auto& [shot, settings, sent, cancelled] = tried;
    const TrialGrid grid(settings);
    std::vector<PilotNoise> noise(static_cast<std::size_t>(grid.rows));
    run_parallel(noise.size(), settings.threads, [&](std::size_t row) {
        Integrator integrator(shot,
                              {.shadow_rays = rays, .sent = sent, .max_rays = max_rays_of_pilot});
        const WorkWatch watch(cancelled);
        try {
            for (int column = 0; column < grid.columns && !(cancelled && cancelled()); ++column)
                try_pixel(integrator, shot, settings,
                          {column, static_cast<int>(row), grid.columns, grid.rows}, places,
                          noise[row]);
        } catch (const WorkEnded&) {
            return;
        }
        const LightLedger& ledger = integrator.ledger();
        noise[row].of_hits = ledger.noise;
        noise[row].rays = ledger.camera + ledger.shadow + ledger.scattered;
    });
    PilotNoise sum;
    for (const PilotNoise& each : noise) {
        sum.of_light += each.of_light;
        sum.of_camera += each.of_camera;
        sum.shown += each.shown;
        sum.places += each.places;
        sum.of_hits += each.of_hits;
        sum.rays += each.rays;
    }
    sum.of_camera = std::fmax(sum.of_camera, 0);
    return sum;
}

/// Rays for each sample, where four samples of each place were followed.
double cost(const PilotNoise& noise) {
    return (static_cast<double>(noise.rays) + cost_of_lit_hit * noise.of_hits.hits) /
           (samples_of_place * noise.places);
}

Pilot found_by(const Tried& tried) {
    const auto& [shot, settings, sent, cancelled] = tried;
    PilotNoise noise = noise_of_places(tried, {}, 2);
    const bool equal_rays = has_equal_rays(shot, settings);
    if (equal_rays) noise.of_camera = 0;
    const HitNoise& hits = noise.of_hits;
    // One draw stands for that among luminaires and that among sources.
    const int draws = shot.joined ? 2 : 1;
    const ShadowRays few{best_shadow_rays(noise, draws), hits.hits > 0 ? hits.sum / hits.hits : 0},
        many{few.usual * many_times, few.usual_noise};
    const TrialGrid grid(settings);
    const bool tries_many = equal_rays && noise.of_light > 0 && grid.tried() >= least_tried &&
                            shot.pixels >= pixels_for_many * grid.tried();
    const auto with = [&](const ShadowRays& rays) { return noise_of_places(tried, rays, 1); };
    const bool pays = tries_many && more_rays_pay(with(few), with(many));
    return {pays ? many : few, pays, is_quiet(noise)};
}

}  // namespace

PilotNoise pilot_noise(const Shot& shot, const RenderSettings& settings,
                       const std::optional<SentLight>& sent, const std::function<bool()>& cancelled,
                       const ShadowRays& rays) {
    return noise_of_places({shot, settings, sent, cancelled}, rays, 2);
}

int best_shadow_rays(const PilotNoise& noise, int draws) {
    if (!(noise.of_light > 0)) return 1;
    const double most = max_pilot_rays * draws;
    const double rays = std::sqrt(cost_of_camera_ray * noise.of_light /
                                  std::fmax(noise.of_camera, 1e-3 * noise.of_light));
    return static_cast<int>(std::lround(std::clamp(rays, 1.0, most)));
}

bool paths_pay(const PilotNoise& reflected, const PilotNoise& paths, double sending) {
    if (reflected.places == 0 || paths.places == 0) return false;
    return paths.of_light * cost(paths) < reflected.of_light * (cost(reflected) + sending);
}

bool has_equal_rays(const Shot& shot, const RenderSettings& settings) {
    const Projection& camera = shot.view.camera;
    return !settings.antialias && camera.lens_radius == 0 && !camera.mesh && shot.moments() == 1;
}

bool more_rays_pay(const PilotNoise& few, const PilotNoise& many) {
    if (few.places == 0 || many.places == 0) return false;
    return many.of_light * cost(many) < few.of_light * cost(few);
}

bool is_quiet(const PilotNoise& noise) {
    return noise.places > 0 && noise.shown < noise.places * squared(quiet_deviation);
}

Pilot pilot(const Shot& shot, const RenderSettings& settings, const std::optional<SentLight>& sent,
            const std::function<bool()>& cancelled) {
    const bool has_pixels = !shot.view.camera.mesh;
    const bool tries = shot.world->facts.light_is_drawn && has_pixels;
    const auto with_rays = [&](const std::optional<SentLight>& way) {
        if (settings.shadow_rays > 0) return Pilot{settings.shadow_rays};
        return tries ? found_by({shot, settings, way, cancelled}) : Pilot{1};
    };
    const auto* traced = std::get_if<PathTraced>(&shot.world->rules.settings.integrator);
    const bool left_open = traced && !traced->reflected_luminaires && sent && sent->reflected;
    if (!left_open || !has_pixels) return with_rays(sent);
    SentLight without = *sent;
    without.reflected = nullptr;
    Pilot by_paths = with_rays(without);
    by_paths.by_paths = true;
    if (TrialGrid(settings).tried() < least_tried) return by_paths;
    const Pilot reflected = with_rays(sent);
    const PilotNoise of_reflected =
                         pilot_noise(shot, settings, sent, cancelled, reflected.shadow_rays),
                     of_paths =
                         pilot_noise(shot, settings, without, cancelled, by_paths.shadow_rays);
    const double sending = rays_of_light_path * sent->reflected->count() /
                           static_cast<double>(shot.pixels),
                 all = static_cast<double>(sent->reflected->generation(0)->list.size()),
                 choice = cost_of_choice * std::fmin(all / many_reflected, 1);
    return paths_pay(of_reflected, of_paths, sending + choice) ? by_paths : reflected;
}

}  // namespace candelabra

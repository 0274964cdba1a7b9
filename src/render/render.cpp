// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include "base/elementary.h"
#include "base/parallel.h"
#include "base/work_watch.h"
#include "film/develop.h"
#include "film/pixel_filter.h"
#include "render/pilot.h"

#include <algorithm>
#include <atomic>
#include <mutex>
#include <utility>

namespace candelabra {

namespace {

std::vector<Region> tiles_of(int width, int height, int size) {
    std::vector<Region> tiles;
    for (int y = 0; y < height; y += size)
        for (int x = 0; x < width; x += size)
            tiles.push_back({x, y, std::min(x + size, width), std::min(y + size, height)});
    return tiles;
}

void nearest_first(std::vector<Region>& tiles, const Vec2& pixel) {
    const auto away = [&](const Region& tile) {
        return math::hypot(0.5 * (tile.left + tile.right) - pixel.x,
                           0.5 * (tile.top + tile.bottom) - pixel.y);
    };
    std::ranges::stable_sort(tiles, {}, away);
}

/// Tile size where pixels are independent: a fraction of a tile, so that more threads find work.
constexpr int small_tile = tile_size / 2;

/// Number of samples between checks for cancellation, since a check costs as much as a short ray.
constexpr std::uint64_t samples_between_questions = 16;

/// `quiet`: the light hardly differs between samples.
SampleRule sample_rule(const World& world, const RenderSettings& settings, bool quiet) {
    if (settings.samples > 0 || settings.noise > 0) return NoiseRule();
    if (world.view.camera.blurs()) return world.view.camera.blur;
    // The maximum number that a pixel gets for its contrast.
    const auto depth = static_cast<std::uint32_t>(settings.antialias_depth);
    const std::uint32_t by_contrast = depth * depth + 1;
    if (settings.antialias && world.left_to_chance() && quiet) return NoiseRule{by_contrast};
    // A filter wider than a pixel needs samples over its whole support, not in squares of the
    // pixel.
    const FilmSettings& film = world.view.film;
    const bool wide = film.filter() != FilterShape::box;
    if (!settings.antialias || world.left_to_chance() || world.view.camera.mesh || wide)
        return NoiseRule();
    const double gamma = world.rules.settings.assumed_gamma, exposure = film.exposure_factor();
    if (settings.sampling_method > 1) return corner_rule(settings, gamma, exposure);
    return contrast_rule(settings, gamma, exposure);
}

/// Whether the number of samples depends on the number of shadow rays.
bool follows_shadow_rays(const World& world, const RenderSettings& settings) {
    return settings.samples <= 0 && settings.noise <= 0 && !world.view.camera.blurs();
}

/// Returns the default number of samples. `rays`: number of shadow rays at each hit, where
/// relevant.
int usual_samples(const World& world, const RenderSettings& settings, int rays) {
    constexpr int first_for_noise = 16;
    if (settings.noise > 0)
        return settings.samples > 0 ? std::clamp(settings.samples, 2, first_for_noise)
                                    : first_for_noise;
    if (settings.samples > 0) return settings.samples;
    if (world.view.camera.blurs()) return std::max(2, world.view.camera.blur.least);
    // With more shadow rays per sample, fewer samples suffice.
    constexpr int least = 4, to_middle = 16, min_in_media = 2;
    if (!settings.antialias) {
        if (!world.left_to_chance()) return 1;
        if (world.differs_by_light()) return std::max(least, to_middle / rays);
        return world.photon_targets.empty() ? min_in_media : least;
    }
    const int first = std::max(2, (1 << (2 * settings.antialias_depth)) / 8);
    return rays == 1 ? first : std::min(first, std::max(least, first / rays));
}

int first_samples(const World& world, const RenderSettings& settings, const SampleRule& rule,
                  int rays) {
    if (std::holds_alternative<CornerRule>(rule)) return 1;
    // A target above one sample requests the comparison, whatever its result.
    if (std::holds_alternative<ContrastRule>(rule)) return 2;
    const int usual = usual_samples(world, settings, rays);
    constexpr int first_of_quiet = 4;
    const auto* const noise = std::get_if<NoiseRule>(&rule);
    if (noise && noise->at_most > 0) return std::min(usual, first_of_quiet);
    if (settings.samples > 0 || settings.noise > 0) return usual;
    const int moments = 1 + static_cast<int>(world.shutter.size());
    return std::max(
        {usual, moments, world.view.camera.mesh ? world.view.camera.mesh->rays_per_pixel() : 1});
}

class Renderer {
public:
    Renderer(const RenderPlan& plan, RenderState& state, const RenderHooks& hooks)
        : plan_(plan),
          world_(plan.world),
          settings_(plan.settings),
          state_(state),
          hooks_(hooks),
          film_(plan.world.view.film),
          filter_(film_.filter()),
          exposure_(film_.exposure_factor()),
          tracing_{plan.shadow_rays, hooks.counts_lights || hooks.aovs.lights, plan.sent,
                   hooks.aovs.alpha},
          fresh_integrators_(integrators_of_moments()) {}

    /// Runs all rounds. Returns false if they were stopped.
    bool run() {
        do {
            if (state_.rounds > 0) run_round();
            if (stopped_) return false;
        } while (plan_round(state_, settings_, plan_.samples, plan_.rule));
        return true;
    }

    const LightLedger& rays() const { return rays_; }

private:
    /// Brings all pixels to their targets in passes, so that the whole picture converges evenly.
    void run_round() {
        const Wanted all = wanted_samples(state_.film);
        wanted_ = all.samples;
        done_ = all.samples - all.missing;
        if (all.missing == 0) return;
        constexpr std::uint32_t growth = 4;
        std::uint32_t before = 0;
        for (std::uint32_t level = 1; !stopped_;) {
            prepare(before, level);
            over_tiles(level, level >= all.most);
            if (level >= all.most) return;
            before = level;
            level = level > all.most / growth ? all.most : level * growth;
            if (plan_.sent) level = std::min(level, before + plan_.sent.samples_at_once());
        }
    }

    /// Prepares the integrators for samples `from` to `to` - 1 of each pixel, if any are wanted.
    void prepare(std::uint32_t from, std::uint32_t to) {
        if (!plan_.sent) return;
        const std::uint32_t first = state_.shard.first_sample;
        std::uint32_t least = to;
        for_pixels({0, 0, state_.film.width(), state_.film.height()}, [&](const PixelSum& pixel) {
            if (pixel.samples < pixel.target) least = std::min(least, pixel.samples);
        });
        // Sample by sample, because the light of one generation may take a second to send.
        for (std::uint32_t sample = std::max(from, least); sample < to && !stopped_; ++sample) {
            for (const Integrator& each : fresh_integrators_) each.prepare(first + sample);
            if (hooks_.cancelled && hooks_.cancelled()) stopped_ = true;
        }
    }

    /// The work on one tile.
    struct Work {
        std::vector<Integrator> integrators;  ///< one for each moment
        std::uint64_t made = 0;               ///< samples
        std::vector<ExactSum> gathered = {};  ///< buffer for a sample's values besides its colour
    };

    void over_tiles(std::uint32_t level, bool ends_round) {
        const int size = is_settled_by_tiles(plan_.rule) ? tile_size : small_tile;
        std::vector<Region> tiles = tiles_of(state_.film.width(), state_.film.height(), size);
        if (hooks_.first) nearest_first(tiles, *hooks_.first);
        std::atomic<std::size_t> begun = 0;
        run_parallel(tiles.size(), settings_.threads, [&](std::size_t i) {
            const std::size_t turn = begun++;
            if (turn + 1 == tiles.size() && ends_round) wind_down();
            // Threads start at arbitrary tiles; if the order matters, they take tiles in sequence.
            if (hooks_.first) i = turn;
            if (stopped_ || !wants(tiles[i], level)) return;
            Work work{fresh_integrators_};
            const std::uint64_t made = watched([&] { return make_tile(work, tiles[i], level); });
            {
                const std::lock_guard lock(mutex_);
                for (const Integrator& each : work.integrators) rays_ += each.ledger();
            }
            const std::uint64_t done = done_ += made;
            if (hooks_.progress && made > 0)
                hooks_.progress(overall(static_cast<double>(done) / static_cast<double>(wanted_)));
        });
    }

    /// Calls make(), and ends it if it is asked to. Returns what it has made, or nothing then.
    std::uint64_t watched(const std::function<std::uint64_t()>& make) {
        try {
            const WorkWatch watch(ended_);
            return make();
        } catch (const WorkEnded&) {
            stopped_ = true;
            return 0;
        }
    }

    void wind_down() {
        if (hooks_.winds_down && !stopped_ && !std::exchange(winds_down_, true))
            hooks_.winds_down();
    }

    std::vector<Integrator> integrators_of_moments() const {
        std::vector<Integrator> integrators;
        integrators.emplace_back(world_, tracing_);
        for (const World& moment : world_.shutter) {
            Tracing there = tracing_;
            if (plan_.sent) there.sent = SentLight::of(moment, settings_.seed, settings_.threads);
            integrators.emplace_back(moment, there);
        }
        return integrators;
    }

    /// Returns the completed fraction of all rounds, given that of this round. With a noise bound
    /// or a lens the number of rounds is unknown, so each is assumed to complete half of the rest.
    double overall(double share_of_round) const {
        if (plan_.is_even() || is_settled_by_tiles(plan_.rule)) return share_of_round;
        const double rounds = state_.rounds - 1 + share_of_round;
        const bool open = settings_.noise > 0 || std::holds_alternative<BlurRule>(plan_.rule);
        return open ? 1 - math::exp2(-rounds) : rounds / 2;
    }

    bool wants(const Region& tile, std::uint32_t level) const {
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x) {
                const PixelSum& pixel = state_.film.at(x, y);
                if (pixel.samples < std::min(level, pixel.target)) return true;
            }
        return false;
    }

    /// Renders a tile. Returns the number of samples made or found unnecessary.
    std::uint64_t make_tile(Work& work, const Region& tile, std::uint32_t level) {
        if (const auto* rule = std::get_if<ContrastRule>(&plan_.rule); rule && level > 1)
            return compare_tile(work, tile, *rule);
        std::optional<CornerCells> cells;
        if (const auto* rule = std::get_if<CornerRule>(&plan_.rule)) cells.emplace(*rule, tile);
        for (int y = tile.top; y < tile.bottom; ++y)
            for (int x = tile.left; x < tile.right; ++x) {
                const std::uint32_t wanted = std::min(level, state_.film.at(x, y).target);
                if (cells)
                    add_cell(work, *cells, x, y, wanted);
                else
                    add_samples(work, x, y, wanted);
            }
        return work.made;
    }

    /// Refines a tile by contrast. A pixel that already has more than one sample has them from an
    /// earlier run. Unwanted pixels of the tile are compared as well, so that the others look as in
    /// the whole picture.
    std::uint64_t compare_tile(Work& work, const Region& tile, const ContrastRule& rule) {
        const Region own = common(tile, state_.shard.region);
        const auto apart = [&](int x, int y, std::uint32_t samples) {
            PixelSum pixel;
            std::vector<ExactSum> extra(state_.film.aovs());
            for (std::uint32_t sample = 0; sample < samples; ++sample)
                pixel.add(look(work, x, y, sample, extra).colour);
            return shown(rule.contrast, pixel, extra);
        };
        const auto first = [&](int x, int y) {
            if (!own.contains(x, y) || state_.film.at(x, y).samples != 1) return apart(x, y, 1);
            return shown(rule.contrast, state_.film.at(x, y), aovs_of(x, y));
        };
        const auto all = [&](int x, int y) -> std::optional<DisplayValue> {
            if (!own.contains(x, y)) return apart(x, y, all_samples(rule));
            PixelSum& pixel = state_.film.at(x, y);
            pixel.target = all_samples(rule);
            add_samples(work, x, y, pixel.target);
            if (pixel.samples < pixel.target) return {};
            return shown(rule.contrast, pixel, aovs_of(x, y));
        };
        Wanted before;
        for_pixels(own, [&](PixelSum& pixel) { before.add(pixel); });
        if (!refine_block(rule.contrast, tile, {first, all})) return 0;
        for_pixels(own, [](PixelSum& pixel) { pixel.target = pixel.samples; });
        return before.missing;
    }

    template <class Use>
    void for_pixels(const Region& region, const Use& use) {
        for (int y = region.top; y < region.bottom; ++y)
            for (int x = region.left; x < region.right; ++x) use(state_.film.at(x, y));
    }

    DisplayValue shown(const Contrast& contrast, const PixelSum& pixel,
                       std::span<const ExactSum> extra) const {
        const double clear = hooks_.aovs.alpha ? pixel.mean_of(extra[0].value()) : 0;
        return contrast.shown(pixel.mean(), clear);
    }

    std::span<ExactSum> aovs_of(int x, int y) { return state_.film.extra(state_.film.index(x, y)); }

    void add_samples(Work& work, int x, int y, std::uint32_t wanted) {
        PixelSum& pixel = state_.film.at(x, y);
        const std::span<ExactSum> extra = aovs_of(x, y);
        for (; pixel.samples < wanted && !stop(work); ++work.made) {
            const std::uint32_t sample = state_.shard.first_sample + pixel.samples;
            const Seen seen = look(work, x, y, sample, extra);
            pixel.add(seen.colour, seen.negative, exposure_);
            pixel.shadow_rays += seen.shadow_rays;
            if (sample == 0) gather_middle(hooks_.aovs, world_, point(x, y), extra);
        }
    }

    /// Adds one sample that is made of many rays.
    void add_cell(Work& work, CornerCells& cells, int x, int y, std::uint32_t wanted) {
        PixelSum& pixel = state_.film.at(x, y);
        if (pixel.samples >= wanted || stop(work)) return;
        const std::span<ExactSum> extra = aovs_of(x, y);
        std::vector<ExactSum> shown(extra.size());
        const PixelSample seen = cells.pixel(x, y, [&](int u, int v, std::uint32_t sample) {
            std::ranges::fill(shown, ExactSum());
            const Seen one = look(work, u, v, sample, shown);
            PixelSample sight{one.colour, 0, {}, one.shadow_rays};
            for (const ExactSum& each : shown) sight.extra.push_back(each.value());
            if (hooks_.aovs.alpha) sight.clear = sight.extra.front();
            return sight;
        });
        pixel.add(seen.colour, false, exposure_);
        pixel.shadow_rays += seen.shadow_rays;
        for (std::size_t i = 0; i < extra.size(); ++i) extra[i].add(seen.extra[i]);
        gather_middle(hooks_.aovs, world_, point(x, y), extra);
        ++work.made;
    }

    PicturePoint point(int x, int y) const {
        return {x, y, state_.film.width(), state_.film.height()};
    }

    struct Seen {
        Vec3 colour;
        std::uint32_t shadow_rays;
        bool negative;  ///< the filter is negative at the sample
    };

    /// Follows the ray of a sample, and adds its values besides the colour to `extra`. Samples
    /// cycle through the moments of the shutter.
    Seen look(Work& work, int x, int y, std::uint32_t sample, std::span<ExactSum> extra) {
        Key key;
        key.pixel = mix(static_cast<std::uint64_t>(settings_.seed)) + state_.film.index(x, y);
        key.sample = sample;
        const std::size_t moment = sample % work.integrators.size();
        const World& world = moment == 0 ? world_ : world_.shutter[moment - 1];
        const FilteredPlace in_pixel = place(world, key);
        const Ray ray = ray_through(world, point(x, y), in_pixel.place, key);
        Integrator& integrator = work.integrators[moment];
        const std::uint64_t before_rays = integrator.ledger().shadow;
        const Vec3 colour = integrator.radiance(ray, key);
        const auto rays = static_cast<std::uint32_t>(integrator.ledger().shadow - before_rays);
        if (integrator.cut() && hooks_.cut) hooks_.cut(x, y);
        if (!extra.empty())
            gather(work.gathered, in_pixel.negative, extra, [&](std::span<ExactSum> sums) {
                gather_sample(hooks_.aovs, world, ray, integrator, sums);
                if (hooks_.aovs.smooth) add_compressed(colour, sums);
                if (hooks_.aovs.squares) add_squares(colour, sums);
            });
        return {colour, rays, in_pixel.negative};
    }

    /// Adds a sample's values besides its colour, or subtracts them via `apart`.
    template <class Add>
    static void gather(std::vector<ExactSum>& apart, bool subtracts, std::span<ExactSum> sums,
                       const Add& add) {
        if (!subtracts) return add(sums);
        apart.assign(sums.size(), ExactSum());
        add(std::span(apart));
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i].subtract(apart[i]);
    }

    void add_squares(const Vec3& colour, std::span<ExactSum> sums) const {
        for (int c = 0; c < 3; ++c)
            sums[hooks_.aovs.first_square() + static_cast<std::size_t>(c)].add(colour[c] *
                                                                               colour[c]);
    }

    void add_compressed(const Vec3& colour, std::span<ExactSum> sums) const {
        const Vec3 light = compressed(colour, exposure_);
        for (int c = 0; c < 3; ++c)
            sums[hooks_.aovs.first_smooth() + static_cast<std::size_t>(c)].add(light[c]);
    }

    /// Returns the place of a sample in its pixel.
    FilteredPlace place(const World& world, const Key& key) const {
        if (const auto* rule = std::get_if<ContrastRule>(&plan_.rule))
            return {place_in_pixel(*rule, key)};
        if (const auto* rule = std::get_if<CornerRule>(&plan_.rule))
            return {place_in_pixel(*rule, key)};
        // A blurred picture's rays are always spread over the pixel, as in POV-Ray.
        if (!settings_.antialias && world.view.camera.lens_radius == 0) return {Vec2(0.5)};
        return filter_.place(key);
    }

    bool stop(const Work& work) {
        const bool asks = work.made % samples_between_questions == 0;
        if (asks && !stopped_ && hooks_.cancelled && hooks_.cancelled()) stopped_ = true;
        return stopped_;
    }

    std::function<bool()> when_ended() {
        if (!hooks_.ended) return {};
        return [this] { return stopped_ || hooks_.ended(); };
    }

    const RenderPlan& plan_;
    const World& world_;
    const RenderSettings& settings_;
    RenderState& state_;
    const RenderHooks& hooks_;
    const FilmSettings& film_;
    const PixelFilter filter_;
    const double exposure_;  ///< factor on the radiance for display
    Tracing tracing_;
    /// Prototypes that are copied, since finding the objects around the camera visits every object.
    const std::vector<Integrator> fresh_integrators_;
    std::mutex mutex_;
    LightLedger rays_;
    std::uint64_t wanted_ = 0;  ///< in total so far
    std::atomic<std::uint64_t> done_ = 0;
    std::atomic<bool> stopped_ = false;
    /// Empty if nobody may end samples.
    const std::function<bool()> ended_ = when_ended();
    bool winds_down_ = false;  ///< set when the last tile of a round begins
};

}  // namespace

RenderPlan plan_of(const World& world, const RenderSettings& settings) {
    return *plan_of(world, settings, SentLight::of(world, settings.seed, settings.threads), {});
}

std::optional<RenderPlan> plan_of(const World& world, const RenderSettings& settings,
                                  const SentLight& sent, const std::function<bool()>& cancelled) {
    const Pilot tried = pilot(world, settings, sent, cancelled);
    if (cancelled && cancelled()) return {};
    const int shared = follows_shadow_rays(world, settings) ? tried.shadow_rays.usual : 1;
    const SampleRule rule = sample_rule(
        world, settings, tried.quiet && !world.lights.sources.empty() && world.sky.light.empty());
    const int samples = first_samples(world, settings, rule, shared);
    return RenderPlan{world, settings, tried.shadow_rays, sent, static_cast<std::uint32_t>(samples),
                      rule};
}

bool advance(const RenderPlan& plan, RenderState& state, LightLedger& rays,
             const RenderHooks& hooks) {
    Renderer renderer(plan, state, hooks);
    const bool finished = renderer.run();
    rays += renderer.rays();
    return finished;
}

Rendering render(const World& world, const RenderSettings& settings, const RenderHooks& hooks) {
    RenderState state = begin_picture(settings, hooks.aovs.count(world));
    LightLedger rays;
    advance(plan_of(world, settings), state, rays, hooks);
    return {state.film.image(), rays};
}

}  // namespace candelabra

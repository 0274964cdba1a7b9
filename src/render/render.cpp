// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/render.h"

#include "base/parallel.h"
#include "render/adaptive.h"
#include "render/film.h"
#include "render/trace.h"

#include <algorithm>
#include <atomic>
#include <mutex>

namespace {

constexpr int tile_size = 16;

struct Tile {
    int left, top, right, bottom;
};

std::vector<Tile> tiles_of(int width, int height) {
    std::vector<Tile> tiles;
    for (int y = 0; y < height; y += tile_size)
        for (int x = 0; x < width; x += tile_size)
            tiles.push_back(
                {x, y, std::min(x + tile_size, width), std::min(y + tile_size, height)});
    return tiles;
}

/// POV-Ray's recursive antialiasing makes up to so many rays of a pixel.
std::uint32_t most_samples(const RenderSettings& settings) {
    return std::uint32_t{1} << (2 * settings.antialias_depth);
}

/// Shares of the whole work: the first pass, and the second when there is one.
struct Pass {
    double begin, end;
};

class Renderer {
public:
    Renderer(const World& world, const RenderSettings& settings, const RenderHooks& hooks)
        : world_(world),
          settings_(settings),
          hooks_(hooks),
          film_(settings.width, settings.height),
          samples_(static_cast<std::uint32_t>(samples_per_pixel(world, settings))) {}

    Rendering operator()() {
        const bool adaptive = settings_.antialias && settings_.samples == 0;
        over_tiles(adaptive ? Pass{0, 0.5} : Pass{0, 1}, [&](int, int) { return samples_; });
        if (adaptive) refine();
        return {film_.image(), rays_};
    }

private:
    void refine() {
        // POV-Ray's threshold is for the difference of two rays; the mean of many should be better
        // than that.
        const AdaptiveRule rule{settings_.antialias_threshold / 10, most_samples(settings_)};
        std::vector<std::uint32_t> more(film_.index(0, film_.height()));
        for (int y = 0; y < film_.height(); ++y)
            for (int x = 0; x < film_.width(); ++x)
                more[film_.index(x, y)] = samples_to_add(film_, x, y, rule);
        over_tiles({0.5, 1}, [&](int x, int y) { return more[film_.index(x, y)]; });
    }

    /// Adds count(x, y) samples to each pixel.
    template <class Count>
    void over_tiles(const Pass& pass, const Count& count) {
        const std::vector<Tile> tiles = tiles_of(film_.width(), film_.height());
        std::atomic<std::size_t> done = 0;
        run_parallel(tiles.size(), settings_.threads, [&](std::size_t i) {
            if (hooks_.cancelled && hooks_.cancelled()) return;
            Tracer tracer(world_, settings_.shadow_rays);
            const Tile& tile = tiles[i];
            for (int y = tile.top; y < tile.bottom; ++y)
                for (int x = tile.left; x < tile.right; ++x) add_samples(tracer, x, y, count(x, y));
            {
                const std::lock_guard lock(mutex_);
                rays_ += tracer.rays();
            }
            const double share = static_cast<double>(++done) / static_cast<double>(tiles.size());
            if (hooks_.progress) hooks_.progress(pass.begin + share * (pass.end - pass.begin));
        });
    }

    void add_samples(Tracer& tracer, int x, int y, std::uint32_t count) {
        PixelSum& pixel = film_.at(x, y);
        Key key;
        key.pixel = mix(static_cast<std::uint64_t>(settings_.seed)) + film_.index(x, y);
        for (const std::uint32_t last = pixel.samples + count; pixel.samples < last;) {
            key.sample = pixel.samples;
            const double dx = settings_.antialias ? uniform(key, Purpose::pixel_x) : 0.5;
            const double dy = settings_.antialias ? uniform(key, Purpose::pixel_y) : 0.5;
            pixel.add(tracer.radiance(
                world_.camera.ray((x + dx) / film_.width() - 0.5, 0.5 - (y + dy) / film_.height()),
                key));
        }
    }

    const World& world_;
    const RenderSettings& settings_;
    const RenderHooks& hooks_;
    Film film_;
    std::uint32_t samples_;
    std::mutex mutex_;
    RayCounts rays_;
};

}  // namespace

int samples_per_pixel(const World& world, const RenderSettings& settings) {
    if (settings.samples > 0) return settings.samples;
    if (!settings.antialias) return world.luminaires.empty() ? 1 : 16;
    return std::max(2, static_cast<int>(most_samples(settings)) / 8);
}

Rendering render(const World& world, const RenderSettings& settings, const RenderHooks& hooks) {
    return Renderer(world, settings, hooks)();
}

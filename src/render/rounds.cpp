// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/rounds.h"

#include "base/elementary.h"
#include "base/parallel.h"
#include "film/schedule.h"
#include "render/tile.h"

#include <algorithm>
#include <utility>
#include <variant>
#include <vector>

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

}  // namespace

bool Rounds::run() {
    do {
        if (state_.rounds > 0) run_round();
        if (interruption_.stopped()) return false;
    } while (plan_round(state_, plan_.settings, plan_.samples, plan_.rule));
    return true;
}

/// Returns the number of samples up to which the next pass goes. The whole picture converges
/// evenly; only where the light of lamps is kept, which takes memory, tiles are finished at once.
std::uint32_t Rounds::level_after(std::uint32_t level, std::uint32_t most) const {
    constexpr std::uint32_t growth = 4;
    std::uint32_t next = level == 0 ? 1 : level > most / growth ? most : level * growth;
    if (hooks_.lamps) next = most;
    return plan_.sent ? std::min(next, level + plan_.sent.samples_at_once()) : next;
}

/// Brings all pixels to their planned samples in passes.
void Rounds::run_round() {
    const Wanted all = wanted_samples(state_.film);
    wanted_ = all.samples;
    done_ = all.samples - all.missing;
    if (all.missing == 0) return;
    for (std::uint32_t before = 0; before < all.most && !interruption_.stopped();) {
        const std::uint32_t level = level_after(before, all.most);
        prepare(before, level);
        over_tiles(level, level >= all.most);
        before = level;
    }
}

/// Prepares the integrators for samples `from` to `to` - 1 of each pixel, if any are wanted.
void Rounds::prepare(std::uint32_t from, std::uint32_t to) {
    if (!plan_.sent) return;
    std::uint32_t least = to;
    for_pixels(state_.film, [&](int, int, const PixelSum& pixel) {
        if (pixel.samples < pixel.planned) least = std::min(least, pixel.samples);
    });
    // Sample by sample, because the light of one generation may take a second to send.
    for (std::uint32_t sample = std::max(from, least); sample < to && !interruption_.stopped();
         ++sample) {
        interruption_.watched([&] {
            fresh_tracer_.prepare(state_.shard.first_sample + sample);
            return 0;
        });
        interruption_.ask();
    }
}

void Rounds::over_tiles(std::uint32_t level, bool ends_round) {
    const bool whole = decided_by(plan_.settings, plan_.rule) == DecidedBy::tile;
    std::vector<Region> tiles =
        tiles_of(state_.film.width(), state_.film.height(), whole ? tile_size : small_tile);
    if (hooks_.first) nearest_first(tiles, *hooks_.first);
    std::atomic<std::size_t> begun = 0;
    run_parallel(tiles.size(), plan_.settings.threads, [&](std::size_t i) {
        const std::size_t turn = begun++;
        if (turn + 1 == tiles.size() && ends_round) wind_down();
        // Threads start at arbitrary tiles; if the order matters, they take tiles in sequence.
        if (hooks_.first) i = turn;
        if (interruption_.stopped()) return;
        const std::uint64_t made = wants(tiles[i], level) ? make_tile(tiles[i], level) : 0;
        if (hooks_.lamps) pass_lamps(tiles[i], level);
        if (made == 0) return;
        const std::uint64_t done = done_ += made;
        if (hooks_.progress)
            hooks_.progress(overall(static_cast<double>(done) / static_cast<double>(wanted_)));
    });
}

/// Returns how many of the planned samples are done.
std::uint64_t Rounds::make_tile(const Region& region, std::uint32_t level) {
    TileMaker tile(state_, region, hooks_, fresh_tracer_, interruption_);
    const std::uint64_t made = interruption_.watched([&] {
        return std::visit([&](const auto& rule) { return rule.make(tile, level); }, plan_.rule);
    });
    const auto pixels = static_cast<std::uint64_t>(region.right - region.left) *
                        static_cast<std::uint64_t>(region.bottom - region.top);
    if ((held_ += pixels) >= Film::held_pixels) {
        held_ = 0;
        state_.film.let_go();
    }
    const std::lock_guard lock(mutex_);
    tile.add_rays(rays_);
    return made;
}

void Rounds::wind_down() {
    if (hooks_.winds_down && !interruption_.stopped() && !std::exchange(winds_down_, true))
        hooks_.winds_down();
}

bool Rounds::wants(const Region& tile, std::uint32_t level) const {
    const int last = std::min(tile.bottom, state_.film.last_row());
    for (int y = std::max(tile.top, state_.film.first_row()); y < last; ++y)
        for (int x = tile.left; x < tile.right; ++x) {
            const PixelSum& pixel = state_.film.at(x, y);
            if (pixel.samples < std::min(level, pixel.planned)) return true;
        }
    return false;
}

/// Tells who keeps lamps that a region has exactly the samples of a pass. A run that goes on after
/// a pause says so at the same moments as one without.
void Rounds::pass_lamps(const Region& tile, std::uint32_t level) const {
    for (int y = tile.top; y < tile.bottom; ++y)
        for (int x = tile.left; x < tile.right; ++x) {
            const PixelSum& pixel = state_.film.at(x, y);
            if (pixel.samples != std::min(level, pixel.planned)) return;
        }
    hooks_.lamps->passed(tile);
}

/// Returns the completed fraction of all rounds, given that of this round. With a noise bound or a
/// lens the number of rounds is unknown, so each is assumed to complete half of the rest.
double Rounds::overall(double share_of_round) const {
    const DecidedBy by = decided_by(plan_.settings, plan_.rule);
    if (by == DecidedBy::settings || by == DecidedBy::tile) return share_of_round;
    const double rounds = state_.rounds - 1 + share_of_round;
    const bool open = plan_.settings.noise > 0 || by == DecidedBy::pixel;
    return open ? 1 - math::exp2(-rounds) : rounds / 2;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/idle_lamps.h"

#include "base/gamma.h"
#include "base/parallel.h"
#include "film/develop.h"
#include "relight/half.h"
#include "relight/relighting.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace candelabra {

namespace {

/// What a display shows of the light in a pixel, from 0 to 1.
class Display {
public:
    Display(const LightRecords& records, const Image& light) {
        if (records.film.empty()) return;
        film_ = film_from_text(records.film).value_or(FilmSettings());
        film_.exposure = exposure_of({light, {}, {}}, film_);
        film_.auto_exposure = false;
        film_.grain = 0;
        if (film_.on) developer_.emplace(film_, film_.exposure, light.width, light.height);
    }

    bool glares() const { return film_.on && film_.glares && film_.glare.share() > 0; }

    Rgb operator()(const Rgb& light, int x, int y) const {
        const Rgb linear = developer_ ? (*developer_)(light, 1, x, y) : light;
        Rgb shown(0);
        for (int c = 0; c < 3; ++c)
            shown[c] = from_linear(std::clamp(linear[c], 0.0, 1.0), srgb_gamma);
        return shown;
    }

private:
    FilmSettings film_;
    std::optional<PixelDeveloper> developer_;
};

/// Looks through the tiles for light that is seen. Several threads may look through different ones.
class Search {
public:
    Search(const LightRecords& records, const Image& light)
        : records_(records),
          light_(light),
          display_(records, light),
          seen_(records.lamps.size()),
          borders_(records.lamps.size() + 1) {}

    bool glares() const { return display_.glares(); }

    void look_at(std::size_t number) {
        const TileRecords& tile = records_.tiles[number];
        const auto across = static_cast<std::size_t>(records_.tiles_across());
        const Corner corner{static_cast<int>(number % across) * light_tile,
                            static_cast<int>(number / across) * light_tile};
        for (std::size_t n = 0; n < tile.nodes.size(); ++n)
            for (std::size_t pixel = 0; pixel < tile_pixels; ++pixel)
                if (changes(corner, pixel, light_of(tile, n, pixel))) {
                    ++borders_[tile.nodes[n].first];
                    --borders_[tile.nodes[n].last];
                    break;
                }
        // A lamp that a ray met has two entries in a pixel, and may be in a node as well.
        for (std::size_t i = 0; i < tile.own.size();) {
            const LampEntry& entry = tile.own[i];
            Rgb light(0);
            for (; i < tile.own.size() && tile.own[i].lamp == entry.lamp &&
                   tile.own[i].pixel == entry.pixel;
                 ++i)
                for (int c = 0; c < 3; ++c)
                    light[c] += static_cast<double>(tile.own[i].light[static_cast<std::size_t>(c)]);
            if (seen_[entry.lamp].load(std::memory_order_relaxed)) continue;
            const auto after =
                std::ranges::upper_bound(tile.nodes, entry.lamp, {}, &LampRange::first);
            if (after != tile.nodes.begin() && entry.lamp < after[-1].last)
                light += light_of(tile, static_cast<std::size_t>(after - tile.nodes.begin()) - 1,
                                  entry.pixel);
            if (changes(corner, entry.pixel, light))
                seen_[entry.lamp].store(true, std::memory_order_relaxed);
        }
    }

    /// Returns the lamps of which nothing was seen.
    std::vector<bool> unseen() const {
        std::vector<bool> lamps;
        std::int64_t nodes = 0;
        for (std::size_t lamp = 0; lamp < seen_.size(); ++lamp) {
            nodes += borders_[lamp];
            lamps.push_back(nodes == 0 && !seen_[lamp]);
        }
        return lamps;
    }

private:
    struct Corner {
        int left, top;
    };

    static Rgb light_of(const TileRecords& tile, std::size_t node, std::size_t pixel) {
        const std::uint16_t* const light = tile.light.data() + node * 3 * tile_pixels + pixel;
        Rgb sum(0);
        for (int c = 0; c < 3; ++c)
            sum[c] = static_cast<double>(
                from_half(light[static_cast<std::size_t>(c) * tile_pixels]) * tile.scale);
        return sum;
    }

    bool changes(const Corner& corner, std::size_t pixel, const Rgb& off) const {
        const int x = corner.left + static_cast<int>(pixel) % light_tile,
                  y = corner.top + static_cast<int>(pixel) / light_tile;
        if (off == Rgb(0) || x >= light_.width || y >= light_.height) return false;
        const Rgb& light = light_.at(x, y);
        const Rgb change = display_(light, x, y) - display_(light - off, x, y);
        return max_abs_component(change) >= 1.0 / 255;
    }

    const LightRecords& records_;
    const Image& light_;
    Display display_;
    std::vector<std::atomic<bool>> seen_;  ///< of each lamp
    std::vector<std::atomic<std::int64_t>>
        borders_;  ///< of nodes seen: +1 first, -1 after the last
};

/// `Facade[3..9], [12]`, or `Lamp` if that is the only one of its name.
std::string names_of(const LampGroup& group, const std::vector<std::uint32_t>& numbers) {
    std::string text(printable(group.name));
    if (group.lamps == 1) return text;
    for (std::size_t i = 0; i < numbers.size();) {
        std::size_t last = i;
        while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
        text += i > 0 ? ", [" : "[";
        text += last > i ? message(numbers[i], "..", numbers[last]) : message(numbers[i]);
        text += ']';
        i = last + 1;
    }
    return text;
}

}  // namespace

std::vector<bool> idle_lamps(const LightRecords& records, const std::vector<bool>& lit,
                             int threads) {
    std::vector<bool> idle(lit);
    idle.flip();
    const Image light = relit(records, std::vector<Rgb>(records.lamps.size(), Rgb(1)), threads);
    Search search(records, light);
    if (search.glares()) return idle;
    run_parallel(records.tiles.size(), threads, [&](std::size_t tile) { search.look_at(tile); });
    const std::vector<bool> unseen = search.unseen();
    for (std::size_t lamp = 0; lamp < idle.size(); ++lamp)
        if (unseen[lamp]) idle[lamp] = true;
    return idle;
}

std::string idle_lamps_report(const LampList& lamps, const std::vector<bool>& idle) {
    std::string text;
    for (std::size_t group = 0; group < lamps.groups().size(); ++group) {
        std::vector<std::uint32_t> numbers;
        for (std::uint32_t number = 0; number < lamps.groups()[group].lamps; ++number)
            if (idle[lamps.place_of(group, number)]) numbers.push_back(number);
        if (!numbers.empty())
            text += message("could be off alone, since no pixel changes by 1/255 without it: ",
                            names_of(lamps.groups()[group], numbers), '\n');
    }
    return text;
}

}  // namespace candelabra

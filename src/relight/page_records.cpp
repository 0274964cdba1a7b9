// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/page_records.h"

#include "base/elementary.h"
#include "base/order.h"
#include "base/parallel.h"
#include "film/develop.h"
#include "film/glare.h"
#include "relight/byte_stream.h"
#include "relight/half.h"
#include "relight/lamp_density.h"
#include "relight/relighting.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// Most nodes of a cell.
constexpr std::size_t most_cell_nodes = 64;
/// Most strong lamps, and how many pixels they light at least, and with what share of all light.
constexpr std::size_t most_strong = 8;
constexpr double least_area = 0.01, least_light = 0.002;
/// What a dot differs from what its cell tells, in terms of the light of its pixel.
constexpr double least_difference = 0.1;
/// Light that is added to that of a pixel there, in terms of the mean of the picture.
constexpr double dark_share = 0.05;

/// Light of a lamp in a pixel of the picture.
struct Dot {
    std::size_t pixel = 0;
    std::uint32_t lamp = 0;
    Rgb light = Rgb(0);
};

void append_light(std::string& bytes, const Rgb& light) {
    constexpr double per_stop = 2048, gain = 64, most = 65535;
    for (int c = 0; c < 3; ++c) {
        const double code = light[c] > 0 ? per_stop * math::log2(1 + gain * light[c]) : 0;
        append_number(bytes, static_cast<std::uint16_t>(std::min(std::round(code), most)));
    }
}

void append_zigzag(std::string& bytes, std::int64_t number) {
    append_short(bytes, number < 0 ? 2 * static_cast<std::uint64_t>(-number) - 1
                                   : 2 * static_cast<std::uint64_t>(number));
}

class PageMaker {
public:
    PageMaker(const LightRecords& records, const FilmSettings& film, int threads)
        : records_(records),
          film_(film),
          threads_(threads),
          before_(powers_before(records.lamps)),
          columns_((records.width + page_cell - 1) / page_cell),
          rows_((records.height + page_cell - 1) / page_cell),
          cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_),
                 LampDensity(before_)) {}

    PageRecords made(std::size_t most_dots) {
        PageRecords page;
        page.strong = strong();
        const std::vector<Rgb> usual(records_.lamps.size(), Rgb(1));
        page.layers = {relit(records_, usual, threads_), rest()};
        Image& crowd = page.layers[0];
        for (std::size_t i = 0; i < crowd.pixels.size(); ++i)
            crowd.pixels[i] -= page.layers[1].pixels[i];
        for (std::size_t i = 0; i < cells_.size(); ++i) add_tiles(i);
        const std::size_t count = page.strong.size();
        page.layers.resize(2 + count, Image(records_.width, records_.height));
        for_own([&](std::size_t, const Dot& dot) {
            const auto found = std::ranges::find(page.strong, dot.lamp);
            if (found == page.strong.end()) return;
            take_away(dot, page.layers[0]);
            page.layers[2 + static_cast<std::size_t>(found - page.strong.begin())]
                .pixels[dot.pixel] += dot.light;
        });
        std::vector<Dot> dots = found(page, most_dots);
        for (const Dot& dot : dots) take_away(dot, page.layers[0]);
        put_on_film(page.layers, dots);
        for (LampDensity& cell : cells_) cell.settle();
        page.columns = columns_;
        page.rows = rows_;
        append_cells(page.cells);
        append_dots(page.dots, dots);
        for (const float power : records_.lamps.powers()) append_float(page.powers, power);
        return page;
    }

private:
    std::size_t cell_of(std::size_t pixel) const {
        const auto width = static_cast<std::size_t>(records_.width);
        return pixel / width / page_cell * static_cast<std::size_t>(columns_) +
               pixel % width / page_cell;
    }

    /// Calls use(tile, left, top) for the tiles of a cell.
    template <class Use>
    void for_tiles(std::size_t cell, const Use& use) const {
        const int left = static_cast<int>(cell) % columns_ * page_cell,
                  top = static_cast<int>(cell) / columns_ * page_cell;
        for (int y = top; y < std::min(top + page_cell, records_.height); y += light_tile)
            for (int x = left; x < std::min(left + page_cell, records_.width); x += light_tile)
                use(records_.tiles[static_cast<std::size_t>(
                        y / light_tile * records_.tiles_across() + x / light_tile)],
                    x, y);
    }

    /// The pixel of the picture that a pixel of a tile is; none outside of the picture.
    std::optional<std::size_t> pixel_at(int left, int top, std::size_t pixel) const {
        const int x = left + static_cast<int>(pixel) % light_tile,
                  y = top + static_cast<int>(pixel) / light_tile;
        if (x >= records_.width || y >= records_.height) return std::nullopt;
        return static_cast<std::size_t>(y) * static_cast<std::size_t>(records_.width) +
               static_cast<std::size_t>(x);
    }

    Image rest() const {
        Image image(records_.width, records_.height);
        for (std::size_t cell = 0; cell < cells_.size(); ++cell)
            for_tiles(cell, [&](const TileRecords& tile, int left, int top) {
                for (std::size_t i = 0; tile.rest && i < tile_pixels; ++i)
                    if (const auto pixel = pixel_at(left, top, i))
                        for (int c = 0; c < 3; ++c)
                            image.pixels[*pixel][c] = static_cast<double>(
                                (*tile.rest)[static_cast<std::size_t>(c) * tile_pixels + i]);
            });
        return image;
    }

    static Rgb light_of(const LampEntry& entry) {
        return {static_cast<double>(entry.light[0]), static_cast<double>(entry.light[1]),
                static_cast<double>(entry.light[2])};
    }

    /// The light of a node in a pixel of its tile.
    static Rgb light_of(const TileRecords& tile, std::size_t node, std::size_t pixel) {
        Rgb light;
        for (std::size_t c = 0; c < 3; ++c)
            light[static_cast<int>(c)] =
                static_cast<double>(from_half(tile.light[(3 * node + c) * tile_pixels + pixel])) *
                static_cast<double>(tile.scale);
        return light;
    }

    void add_tiles(std::size_t number) {
        LampDensity& cell = cells_[number];
        for_tiles(number, [&](const TileRecords& tile, int, int) {
            for (std::size_t n = 0; n < tile.nodes.size(); ++n) {
                Rgb light(0);
                for (std::size_t i = 0; i < tile_pixels; ++i) light += light_of(tile, n, i);
                // Samples of single lamps say how the lamps of the node share it.
                for (const LampEntry& entry : tile.residual)
                    if (tile.nodes[n].first <= entry.lamp && entry.lamp < tile.nodes[n].last) {
                        light -= light_of(entry);
                        cell.add({entry.lamp, entry.lamp + 1}, light_of(entry));
                    }
                cell.add(tile.nodes[n], light);
            }
            for (const LampEntry& entry : tile.own)
                cell.add({entry.lamp, entry.lamp + 1}, light_of(entry));
        });
    }

    /// Calls use(cell, dot) for all light of lamps that is known by itself.
    template <class Use>
    void for_own(const Use& use) const {
        for (std::size_t cell = 0; cell < cells_.size(); ++cell)
            for_tiles(cell, [&](const TileRecords& tile, int left, int top) {
                for (const LampEntry& entry : tile.own)
                    if (const auto pixel = pixel_at(left, top, entry.pixel))
                        use(cell, Dot{*pixel, entry.lamp, light_of(entry)});
                for (std::size_t n = 0; n < tile.nodes.size(); ++n)
                    for (std::size_t i = 0; tile.nodes[n].size() == 1 && i < tile_pixels; ++i)
                        if (const auto pixel = pixel_at(left, top, i))
                            use(cell, Dot{*pixel, tile.nodes[n].first, light_of(tile, n, i)});
            });
    }

    void take_away(const Dot& dot, Image& crowd) {
        cells_[cell_of(dot.pixel)].add({dot.lamp, dot.lamp + 1}, -dot.light);
        crowd.pixels[dot.pixel] -= dot.light;
    }

    std::vector<std::uint32_t> strong() const {
        std::vector<double> light(records_.lamps.size());
        std::vector<std::size_t> pixels(records_.lamps.size());
        double all = 0;
        for_own([&](std::size_t, const Dot& dot) {
            const double size = max_abs_component(dot.light);
            light[dot.lamp] += size;
            pixels[dot.lamp] += size > 0 ? 1 : 0;
            all += size;
        });
        const double area = least_area * records_.width * records_.height;
        std::vector<std::uint32_t> lamps;
        for (std::uint32_t i = 0; i < light.size(); ++i)
            if (static_cast<double>(pixels[i]) > area && light[i] > least_light * all)
                lamps.push_back(i);
        sort_stably(lamps, std::greater<>(), [&](std::uint32_t lamp) { return light[lamp]; });
        lamps.resize(std::min(lamps.size(), most_strong));
        return lamps;
    }

    /// The dots of the lamps that matter, pixel by pixel.
    std::vector<Dot> found(const PageRecords& page, std::size_t most) const {
        const Image& crowd = page.layers[0];
        std::vector<LampDensity> cells = cells_;
        for (LampDensity& cell : cells) cell.settle();
        double mean = 0;
        for (const Rgb& pixel : crowd.pixels)
            mean += max_abs_component(pixel) / static_cast<double>(crowd.pixels.size());
        // What cells leave untold of each lamp: in all, and at most in one pixel.
        struct Untold {
            double sum = 0, most = 0;
            std::size_t pixels = 0;
        };
        std::vector<Untold> lamps(records_.lamps.size());
        for (const std::uint32_t lamp : page.strong) lamps[lamp].most = -1;
        for_own([&](std::size_t number, const Dot& dot) {
            Untold& lamp = lamps[dot.lamp];
            if (lamp.most < 0) return;
            const Rgb all = cells[number].light({0, records_.lamps.size()});
            const Rgb share = cells[number].light({dot.lamp, dot.lamp + 1});
            const Rgb& here = crowd.pixels[dot.pixel];
            Rgb off = dot.light;
            for (int c = 0; c < 3; ++c)
                if (all[c] > 0) off[c] -= here[c] * share[c] / all[c];
            const double difference =
                max_abs_component(off) / (max_abs_component(here) + dark_share * mean);
            lamp.sum += difference;
            lamp.most = std::max(lamp.most, difference);
            ++lamp.pixels;
        });
        std::vector<std::uint32_t> order;
        for (std::uint32_t i = 0; i < lamps.size(); ++i)
            if (lamps[i].most > least_difference) order.push_back(i);
        sort_stably(order, std::greater<>(), [&](std::uint32_t i) {
            return lamps[i].sum / static_cast<double>(lamps[i].pixels);
        });
        std::vector<bool> chosen(lamps.size());
        std::size_t count = 0;
        for (const std::uint32_t i : order)
            if (count + lamps[i].pixels <= most) {
                count += lamps[i].pixels;
                chosen[i] = true;
            }
        std::vector<Dot> dots;
        for_own([&](std::size_t, const Dot& dot) {
            if (chosen[dot.lamp]) dots.push_back(dot);
        });
        sort_stably(dots, {}, [](const Dot& dot) { return std::pair(dot.pixel, dot.lamp); });
        return dots;
    }

    /// Puts the glare and the vignette of the film on all light. What dots scatter joins crowds.
    void put_on_film(std::vector<Image>& layers, std::vector<Dot>& dots) {
        if (film_.glares && film_.glare.share() > 0) {
            const GlareKernel kernel(film_.glare, records_.width, records_.height, threads_);
            Image seen(records_.width, records_.height);
            for (const Dot& dot : dots) seen.pixels[dot.pixel] += dot.light;
            const Image around = spread(seen, kernel, threads_);
            for (Image& layer : layers) layer = spread(layer, kernel, threads_);
            const Rgb own = kernel.at(0, 0);
            for (std::size_t i = 0; i < seen.pixels.size(); ++i)
                layers[0].pixels[i] += around.pixels[i] - own * seen.pixels[i];
            scatter(kernel, dots);
            for (Dot& dot : dots) dot.light *= own;
        }
        if (!(film_.vignette > 0)) return;
        for (Image& image : layers)
            for (int y = 0; y < image.height; ++y)
                for (int x = 0; x < image.width; ++x)
                    image.at(x, y) *= vignetted_at(film_.vignette, image.width, image.height, x, y);
        for (Dot& dot : dots)
            dot.light *= vignetted_at(film_.vignette, layers[0].width, layers[0].height,
                                      static_cast<int>(dot.pixel) % records_.width,
                                      static_cast<int>(dot.pixel) / records_.width);
    }

    /// Adds to each cell what the dots of all cells scatter there.
    void scatter(const GlareKernel& kernel, const std::vector<Dot>& dots) {
        struct Source {
            std::size_t cell;
            std::uint32_t lamp;
            Rgb light;
        };
        std::vector<Source> sources;
        for (const Dot& dot : dots) sources.push_back({cell_of(dot.pixel), dot.lamp, dot.light});
        sort_stably(sources, {},
                    [](const Source& each) { return std::pair(each.cell, each.lamp); });
        std::size_t count = 0;
        for (const Source& each : sources)
            if (count > 0 && sources[count - 1].cell == each.cell &&
                sources[count - 1].lamp == each.lamp)
                sources[count - 1].light += each.light;
            else
                sources[count++] = each;
        sources.resize(count);
        constexpr int pixels = page_cell * page_cell;
        run_parallel(cells_.size(), threads_, [&](std::size_t number) {
            const int column = static_cast<int>(number) % columns_,
                      row = static_cast<int>(number) / columns_;
            std::size_t from = cells_.size();
            Rgb share(0);
            for (const Source& each : sources) {
                if (each.cell != from) {
                    from = each.cell;
                    const int across = column - static_cast<int>(from) % columns_,
                              down = row - static_cast<int>(from) / columns_;
                    // Within a cell it is as if all came from half a cell away.
                    const bool here = across == 0 && down == 0;
                    share = static_cast<double>(pixels) *
                            kernel.at(here ? page_cell / 2 : page_cell * across, page_cell * down);
                }
                cells_[number].add({each.lamp, each.lamp + 1}, share * each.light);
            }
        });
    }

    void append_cells(std::string& bytes) const {
        std::vector<std::string> made(cells_.size());
        run_parallel(cells_.size(), threads_,
                     [&](std::size_t number) { made[number] = cell_bytes(cells_[number]); });
        for (const std::string& cell : made) bytes += cell;
    }

    std::string cell_bytes(const LampDensity& cell) const {
        std::vector<LampRange> nodes = divided(cell, records_.lamps, most_cell_nodes);
        std::vector<Rgb> lights;
        Rgb all(0);
        for (const LampRange& node : nodes) {
            // Samples may give a node less than nothing.
            lights.push_back(max(cell.light(node), Rgb(0)));
            all += lights.back();
        }
        std::string bytes;
        append_short(bytes, nodes.size());
        std::uint32_t at = 0;
        for (std::size_t n = 0; n < nodes.size(); ++n) {
            append_short(bytes, nodes[n].first - at);
            append_short(bytes, nodes[n].size());
            at = nodes[n].last;
            for (int c = 0; c < 3; ++c) {
                constexpr double most = 65535;
                const double share = all[c] > 0 ? lights[n][c] / all[c] : 0;
                append_number(bytes, static_cast<std::uint16_t>(std::round(most * share)));
            }
        }
        return bytes;
    }

    static void append_dots(std::string& bytes, const std::vector<Dot>& dots) {
        append_short(bytes, dots.size());
        std::size_t pixel = 0;
        std::int64_t lamp = 0;
        for (const Dot& dot : dots) {
            append_short(bytes, dot.pixel - pixel);
            append_zigzag(bytes, static_cast<std::int64_t>(dot.lamp) - lamp);
            append_light(bytes, dot.light);
            pixel = dot.pixel;
            lamp = dot.lamp;
        }
    }

    const LightRecords& records_;
    const FilmSettings& film_;
    int threads_;
    std::vector<double> before_;
    int columns_, rows_;
    std::vector<LampDensity> cells_;
};

}  // namespace

PageRecords page_records(const LightRecords& records, const FilmSettings& film,
                         std::size_t most_dots, int threads) {
    return PageMaker(records, film, threads).made(most_dots);
}

}  // namespace candelabra

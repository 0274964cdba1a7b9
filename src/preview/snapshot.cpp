// SPDX-License-Identifier: GPL-3.0-or-later
#include "preview/snapshot.h"

#include "base/parallel.h"
#include "film/film.h"
#include "output/layers.h"
#include "picture/layers.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>

namespace candelabra {

namespace {

/// Returns the images of a snapshot in a fixed order.
std::vector<Image*> images_of(LightSnapshot& snapshot) {
    std::vector<Image*> all = {&snapshot.light, &snapshot.smooth};
    for (Image& each : snapshot.lights) all.push_back(&each);
    return all;
}

std::vector<const Image*> images_of(const LightSnapshot& snapshot) {
    std::vector<const Image*> all = {&snapshot.light, &snapshot.smooth};
    for (const Image& each : snapshot.lights) all.push_back(&each);
    return all;
}

/// The sums of a pixel that form an image.
struct Source {
    std::size_t first = 0;
    double compressed = 0;  ///< exposure factor of compressed samples; 0: not compressed
};

Rgb value_of(const Film& film, std::size_t pixel, const Source& source) {
    const PixelSum& sums = film.pixels()[pixel];
    const auto extra = film.extra(pixel).subspan(source.first, 3);
    const Rgb mean{sums.mean_of(extra[0].value()), sums.mean_of(extra[1].value()),
                   sums.mean_of(extra[2].value())};
    return source.compressed > 0 ? expanded(mean, source.compressed) : mean;
}

const Dimmer* dimmer_of(const Look& look, const std::string& name) {
    const auto found = look.lamps.find(name);
    return found == look.lamps.end() || found->second.factor() == Rgb(1) ? nullptr : &found->second;
}

/// Quantises values to bytes by a table of the thresholds between them.
class ByteScale {
public:
    explicit ByteScale(const PictureFormat& format) {
        for (unsigned step = 1; step <= most; ++step) {
            double low = 0, high = 1;
            for (int i = 0; i < 40; ++i) {
                const double middle = 0.5 * (low + high);
                (quantised(middle, most, format) >= step ? high : low) = middle;
            }
            bounds_[step - 1] = high;
        }
        for (unsigned i = 0; i <= cells; ++i)
            first_[i] = static_cast<std::uint8_t>(
                std::ranges::upper_bound(bounds_, static_cast<double>(i) / cells) -
                bounds_.begin());
    }

    char operator()(double value) const {
        if (!(value > 0)) return 0;
        if (value >= 1) return static_cast<char>(most);
        unsigned byte = first_[static_cast<unsigned>(value * cells)];
        while (byte < most && value >= bounds_[byte]) ++byte;
        return static_cast<char>(byte);
    }

private:
    static constexpr unsigned most = 255, cells = 4096;
    std::array<double, most> bounds_{};
    std::array<std::uint8_t, cells + 1> first_{};
};

}  // namespace

bool Look::relights() const {
    return std::ranges::any_of(lamps,
                               [](const auto& each) { return each.second.factor() != Rgb(1); });
}

Rgb spread_out(const Image& coarse, const Image& whole, int x, int y) {
    const double u = (x + 0.5) * coarse.width / whole.width - 0.5,
                 v = (y + 0.5) * coarse.height / whole.height - 0.5;
    const double left = std::floor(u), top = std::floor(v);
    const auto at = [&](double column, double row) {
        return coarse.at(std::clamp(static_cast<int>(column), 0, coarse.width - 1),
                         std::clamp(static_cast<int>(row), 0, coarse.height - 1));
    };
    const Rgb above = mix(at(left, top), at(left + 1, top), u - left);
    const Rgb below = mix(at(left, top + 1), at(left + 1, top + 1), u - left);
    return mix(above, below, v - top);
}

LightSnapshot snapshot_of(const Film& film, const Aovs& aovs, const FilmSettings& settings,
                          bool with_lights, const LightSnapshot* coarse) {
    const std::size_t statements =
        with_lights && aovs.lights ? (film.aovs() - aovs.first_light()) / 3 : 0;
    LightSnapshot snapshot;
    snapshot.width = film.width();
    snapshot.height = film.height();
    snapshot.light = Image(film.width(), film.height());
    if (aovs.smooth) snapshot.smooth = snapshot.light;
    snapshot.lights.assign(statements, snapshot.light);
    std::vector<Source> sources = {{}, {aovs.first_smooth(), settings.exposure_factor()}};
    for (std::size_t k = 0; k < statements; ++k) sources.push_back({aovs.first_light() + 3 * k});
    const std::vector<Image*> images = images_of(snapshot);
    const std::vector<const Image*> rough =
        coarse ? images_of(*coarse) : std::vector<const Image*>();
    run_parallel(static_cast<std::size_t>(film.height()), 0, [&](std::size_t row) {
        const int y = static_cast<int>(row);
        for (int x = 0; x < film.width(); ++x) {
            const std::size_t pixel = film.index(x, y);
            const bool seen = film.pixels()[pixel].samples > 0;
            for (std::size_t i = 0; i < images.size(); ++i) {
                if (images[i]->pixels.empty()) continue;
                if (!seen && i < rough.size() && !rough[i]->pixels.empty())
                    images[i]->pixels[pixel] = spread_out(*rough[i], *images[i], x, y);
                else if (seen)
                    images[i]->pixels[pixel] =
                        i == 0 ? film.pixels()[pixel].mean() : value_of(film, pixel, sources[i]);
            }
        }
    });
    return snapshot;
}

LightSnapshot reduced(const LightSnapshot& snapshot, int step) {
    LightSnapshot made = snapshot;
    for (Image* const image : images_of(made)) {
        if (image->pixels.empty()) continue;
        Image small((image->width + step - 1) / step, (image->height + step - 1) / step);
        std::vector<int> counts(small.pixels.size());
        for (int y = 0; y < image->height; ++y)
            for (int x = 0; x < image->width; ++x) {
                small.at(x / step, y / step) += image->at(x, y);
                ++counts[static_cast<std::size_t>(y / step) *
                             static_cast<std::size_t>(small.width) +
                         static_cast<std::size_t>(x / step)];
            }
        for (std::size_t i = 0; i < counts.size(); ++i) small.pixels[i] /= counts[i];
        *image = std::move(small);
    }
    return made;
}

Image relit(const LightSnapshot& snapshot, const std::vector<std::string>& names,
            const Look& look) {
    Image image = snapshot.light;
    for (std::size_t k = 0; k < std::min(snapshot.lights.size(), names.size()); ++k) {
        const Dimmer* const dimmer = dimmer_of(look, names[k]);
        if (!dimmer) continue;
        const Rgb more = dimmer->factor() - Rgb(1);
        for (std::size_t i = 0; i < image.pixels.size(); ++i)
            image.pixels[i] += more * snapshot.lights[k].pixels[i];
    }
    return image;
}

std::string change_look(FilmSettings& film, const FilmChange& wanted) {
    if (wanted.name == "auto") {
        if (wanted.value != "on" && wanted.value != "off") return "auto is on or off";
        film.on = true;
        film.auto_exposure = wanted.value == "on";
        return {};
    }
    const bool automatic = film.auto_exposure;
    const std::string wrong = change(film, wanted);
    if (wanted.name == "exposure" && wanted.value != "auto") film.auto_exposure = automatic;
    return wrong.empty() ? problem(film) : wrong;
}

FilmSettings film_with(FilmSettings film, const Look& look) {
    for (const FilmChange& each : look.film) {
        FilmSettings changed = film;
        if (change_look(changed, each).empty()) film = changed;
    }
    return film;
}

DisplayImage display_image(const LightSnapshot& snapshot, const SnapshotContext& context,
                           const Look& look) {
    if (snapshot.view) return {*snapshot.view, {}};
    PictureFormat format = context.format;
    format.type = PictureType::png;
    format.bits = 8;
    const FilmSettings film = film_with(context.film, look);
    if (!film.on) return {relit(snapshot, context.names, look), format};
    Negative negative{linear(relit(snapshot, context.names, look), format), {}, {}};
    if (film.smooths_edges() && !snapshot.smooth.pixels.empty() && !look.relights())
        negative.smooth = linear(snapshot.smooth, format);
    format.gamma = 1;
    format.encoded = true;
    return {develop(negative, film, context.threads), format};
}

std::string screen_bytes(const DisplayImage& shown, int threads) {
    const ByteScale scale(shown.format);
    const Image& image = shown.image;
    constexpr std::size_t channels = 4;
    std::string bytes(image.pixels.size() * channels, '\xff');
    const auto width = static_cast<std::size_t>(image.width);
    run_parallel(static_cast<std::size_t>(image.height), threads, [&](std::size_t row) {
        for (std::size_t i = row * width; i < (row + 1) * width; ++i)
            for (std::size_t c = 0; c < 3; ++c)
                bytes[i * channels + c] = scale(image.pixels[i][static_cast<int>(c)]);
    });
    return bytes;
}

std::optional<std::string> exr_of(const LightSnapshot& snapshot, const SnapshotContext& context,
                                  const Look& look, Diagnostics& diagnostics) {
    LayeredPicture made;
    made.width = snapshot.light.width;
    made.height = snapshot.light.height;
    if (!context.format.description.empty())
        made.texts.emplace_back("ImageDescription", context.format.description);
    const FilmSettings film = film_with(context.film, look);
    if (film.on) made.texts.emplace_back(film_text_name, to_text(film));
    const auto add = [&](const std::string& before, const Image& image, const Rgb& factor) {
        static constexpr auto letters = std::array{"R", "G", "B"};
        for (int c = 0; c < 3; ++c) {
            ChannelPlane plane{before + letters[static_cast<std::size_t>(c)], false, {}};
            plane.bits.reserve(image.pixels.size());
            for (const Rgb& pixel : image.pixels)
                plane.bits.push_back(
                    std::bit_cast<std::uint32_t>(static_cast<float>(factor[c] * pixel[c])));
            made.planes.push_back(std::move(plane));
        }
    };
    add("", linear(relit(snapshot, context.names, look), context.format), Rgb(1));
    for (std::size_t k = 0; k < std::min(snapshot.lights.size(), context.names.size()); ++k) {
        const Dimmer* const dimmer = dimmer_of(look, context.names[k]);
        add(message("light.", context.names[k], "."), snapshot.lights[k],
            dimmer ? dimmer->factor() : Rgb(1));
    }
    return encode(made, diagnostics);
}

}  // namespace candelabra

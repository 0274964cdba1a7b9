// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/light_file.h"

#include "output/layers.h"
#include "picture/layers.h"
#include "text/message.h"
#include "text/printable.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>

namespace candelabra {

namespace {

double value_of(const ChannelPlane& plane, std::size_t pixel) {
    return std::bit_cast<float>(plane.bits[pixel]);
}

/// Whether all layers of light together are the picture, if they are all there.
bool add_up(const LightFile& file, const std::string& before, const std::vector<std::string>& names,
            const Image& picture) {
    constexpr double tolerance = 1e-3;
    if (std::ranges::find(names, "rest") == names.end()) return true;
    std::vector<Rgb> sums(picture.pixels.size(), Rgb(0));
    for (const std::string& name : names) {
        const Image light = *file.image(before + name);
        for (std::size_t i = 0; i < sums.size(); ++i) sums[i] += light.pixels[i];
    }
    double error = 0, size = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) {
        error += max_abs_component(sums[i] - picture.pixels[i]);
        size += max_abs_component(picture.pixels[i]);
    }
    return error <= tolerance * size;
}

}  // namespace

std::optional<LightFile> LightFile::read(const std::string& path, Diagnostics& diagnostics) {
    static constexpr auto texts =
        std::to_array<std::string_view>({film_text_name, "ImageDescription"});
    auto picture = read_layers(path, texts, diagnostics);
    if (!picture) return std::nullopt;
    return LightFile(path, std::move(*picture));
}

const ChannelPlane* LightFile::find(std::string_view name) const {
    const auto found = std::ranges::find(picture_.planes, name, &ChannelPlane::name);
    return found == picture_.planes.end() || found->whole ? nullptr : &*found;
}

std::optional<Image> LightFile::image(const std::string& layer) const {
    const std::string before = layer.empty() ? "" : layer + ".";
    std::array<const ChannelPlane*, 3> found = {find(before + "R"), find(before + "G"),
                                                find(before + "B")};
    if (const ChannelPlane* grey = find(before + "Y"); grey && !found[0])
        found = {grey, grey, grey};
    if (!found[0] || !found[1] || !found[2]) return std::nullopt;
    Image image(picture_.width, picture_.height);
    for (std::size_t i = 0; i < image.pixels.size(); ++i)
        image.pixels[i] = {value_of(*found[0], i), value_of(*found[1], i), value_of(*found[2], i)};
    return image;
}

std::vector<double> LightFile::alpha(const std::string& layer) const {
    std::vector<double> alpha;
    if (const ChannelPlane* plane = find(layer.empty() ? "A" : layer + ".A"))
        // Files of other programs may exceed 1; NaN becomes 0.
        for (std::size_t i = 0; i < plane->bits.size(); ++i)
            alpha.push_back(std::fmin(1, std::fmax(0, value_of(*plane, i))));
    return alpha;
}

std::vector<std::string> LightFile::layers() const {
    std::vector<std::string> names;
    for (const ChannelPlane& plane : picture_.planes) {
        const std::size_t dot = plane.name.rfind('.');
        const std::string name = dot == plane.name.npos ? "" : plane.name.substr(0, dot);
        if (std::ranges::find(names, name) == names.end() && image(name)) names.push_back(name);
    }
    return names;
}

std::optional<FilmSettings> film_of(const LightFile& file, const Options& options,
                                    Diagnostics& diagnostics) {
    return film_of(file.film_text(), file.path(), options, diagnostics);
}

std::optional<FilmSettings> film_of(const std::string& text, const std::string& path,
                                    const Options& options, Diagnostics& diagnostics) {
    FilmSettings film;
    if (const auto told = film_from_text(text))
        film = *told;
    else
        diagnostics.add(warning(Fault::io, {},
                                message("`", printable(path),
                                        "` has a film that this version does not know, "
                                        "and is developed as if it had none")));
    RenderSettings settings;
    settings.film = options.render.film;
    const std::string wrong = settle_film(film, settings);
    if (!film.on) film = {};  // as without a film: clipped
    film.on = true;
    if (wrong.empty()) return film;
    diagnostics.add(
        error(Fault::option, {},
              message("the options do not fit the film of `", printable(path), "`: ", wrong)));
    return std::nullopt;
}

std::optional<std::vector<std::string>> lamps_of(const LightFile& file, const std::string& before,
                                                 const Image& picture, Diagnostics& diagnostics) {
    std::vector<std::string> known;
    for (const std::string& layer : file.layers())
        if (layer.starts_with(before)) known.push_back(layer.substr(before.size()));
    if (known.empty())
        diagnostics.add(error(Fault::option, {},
                              message("`", printable(file.path()), "` has no layers of light"))
                            .with_help("render it with --layers lights"));
    else if (!add_up(file, before, known, picture))
        diagnostics.add(error(Fault::option, {},
                              message("the layers of light in `", printable(file.path()),
                                      "` do not add up to its picture"))
                            .with_help("they do in scenes with assumed_gamma 1"));
    else
        return known;
    return std::nullopt;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/layers.h"

#include "film/film.h"
#include "output/film_images.h"
#include "picture/file.h"
#include "picture/layers.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/source.h"
#include "vocabulary/words.h"

#include <algorithm>
#include <array>
#include <bit>
#include <filesystem>
#include <limits>
#include <set>
#include <span>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// Extracts the first word of the text, after blanks, `{` and `#`.
std::string_view next_word(std::string_view& text) {
    while (!text.empty() && std::string_view(" \t\r\n{#").find(text[0]) != text.npos)
        text.remove_prefix(1);
    const auto end = std::ranges::find_if_not(text, in_name);
    const std::string_view word = text.substr(0, static_cast<std::size_t>(end - text.begin()));
    text.remove_prefix(word.size());
    return word;
}

/// Whether the word before `text` stands for a whole item of its block, rather than for a position
/// or another value in it: the block ends behind it, or goes on with a word of the language.
bool stands_alone(std::string_view text, const Names& names) {
    const std::size_t next = std::min(text.find_first_not_of(" \t\r\n"), text.size());
    text.remove_prefix(next);
    if (text.starts_with('}')) return true;
    const std::string word(next_word(text));
    static constexpr auto colours =
        std::to_array<std::string_view>({"color", "colour", "red", "green", "blue", "rgb", "rgbf",
                                         "rgbt", "rgbft", "srgb", "srgbf", "srgbt", "srgbft"});
    return !word.empty() && names.find(word) != no_name &&
           std::ranges::find(colours, word) == colours.end();
}

/// Returns the name with the number of an element, if it has one: `Lamps[3]` is `Lamps_3`.
std::string element_name(std::string_view word, std::string_view& text) {
    std::string name(word);
    while (text.starts_with('[')) {
        const std::string_view index = text.substr(1, text.find(']') - 1);
        if (text.find(']') == text.npos) break;
        if (!index.empty() && std::ranges::all_of(index, is_digit)) name += message('_', index);
        text.remove_prefix(index.size() + 2);
    }
    return name;
}

/// Returns a readable name for the statement.
std::string name_of(const Span& span, const SourceStore& sources, const Names& names) {
    if (!span.known()) return "light";
    const Place place = sources.place(span.source, span.first);
    std::string_view line = sources.line(span.source, place.line);
    const std::size_t column = std::min(line.size(), static_cast<std::size_t>(place.column - 1));
    std::string_view before = line.substr(0, column), text = line.substr(column);
    const std::string_view directive = next_word(before);
    if (directive == "declare" || directive == "local") return std::string(next_word(before));
    const std::string first(next_word(text));
    if (names.find(first) == no_name) return first.empty() ? "light" : element_name(first, text);
    const auto holds_objects = [](std::string_view word) {
        return word == "object" || word == "union" || word == "light_group";
    };
    // object { Lamp ... }, light_group { Lamps[2] ... }, union { object { Lamp ... } ... }
    bool objects = holds_objects(first);
    for (int depth = 0; depth < 4; ++depth) {
        const std::string_view word = next_word(text);
        if (word.empty()) break;
        if (names.find(std::string(word)) == no_name) {
            std::string name = element_name(word, text);
            if (objects || stands_alone(text, names)) return name;
            break;
        }
        objects = holds_objects(word);
        if (!objects) break;
    }
    return first;
}

/// The name that a scene gives, without what has a meaning in names of planes and in options.
std::string layer_name(std::string name) {
    for (char& c : name)
        if (const auto code = static_cast<unsigned char>(c);
            code < ' ' || code == 127 ||
            std::string_view(".,=\"\\").find(c) != std::string_view::npos)
            c = '_';
    return name;
}

class LayerWriter {
public:
    LayerWriter(const Film& film, const FilmFiles& files)
        : film_(film), files_(files), extras_(files.aovs()) {}

    LayeredPicture picture() {
        made_.width = film_.width();
        made_.height = film_.height();
        if (!files_.format.description.empty())
            made_.texts.emplace_back("ImageDescription", files_.format.description);
        if (files_.film.on) made_.texts.emplace_back(film_text_name, to_text(files_.film));
        if (files_.draft) quiet_ = denoised_film(film_, files_);
        const Image image = linear(quiet_ ? quiet_->light : film_.image(), files_.format);
        for (int c = 0; c < 3; ++c) add(rgb[c], [&](std::size_t i) { return image.pixels[i][c]; });
        if (files_.alpha) add("A", [&](std::size_t i) { return 1 - mean(i, 0); });
        if (extras_.smooth) add_smooth();
        if (files_.denoise) add_denoised();
        for (const PictureLayer layer : files_.layers) add(layer);
        return std::move(made_);
    }

private:
    static constexpr auto rgb = std::array{"R", "G", "B"};
    static constexpr auto xyz = std::array{"X", "Y", "Z"};

    template <class Value>
    void add(const std::string& name, const Value& value) {
        add_plane(name, [&](std::size_t i) { return finite_float(value(i)); });
    }

    template <class Value>
    void add_plane(const std::string& name, const Value& value) {
        ChannelPlane plane{name, false, {}};
        plane.bits.reserve(film_.pixels().size());
        for (std::size_t i = 0; i < film_.pixels().size(); ++i) {
            plane.bits.push_back(std::bit_cast<std::uint32_t>(value(i)));
            if (i % Film::held_pixels == 0) film_.let_go();
        }
        made_.planes.push_back(std::move(plane));
    }

    double sum(std::size_t pixel, std::size_t which) const {
        return film_.extra(pixel)[which].value();
    }

    double mean(std::size_t pixel, std::size_t which) const {
        return film_.pixels()[pixel].mean_of(sum(pixel, which));
    }

    void add(PictureLayer layer) {
        const std::string name(all_layers()[static_cast<std::size_t>(layer)].name);
        const auto of_film = [&](const auto& value) {
            add(name, [&](std::size_t i) { return value(film_.pixels()[i]); });
        };
        switch (layer) {
            case PictureLayer::albedo:
                return add_three(name, rgb, extras_.albedo());
            case PictureLayer::normal:
                return add_three(name, xyz, extras_.normal());
            case PictureLayer::depth:
                // Where there is nothing, the depth is infinite.
                return add_plane(name, [&](std::size_t i) {
                    const double depth = sum(i, extras_.depth());
                    return depth > 0 ? finite_float(depth) : std::numeric_limits<float>::infinity();
                });
            case PictureLayer::object:
                return add(name, [&](std::size_t i) { return sum(i, extras_.object()); });
            case PictureLayer::lights:
                return add_lights();
            case PictureLayer::variance:
                return of_film([](const PixelSum& p) { return p.variance_of_mean(); });
            case PictureLayer::samples:
                return of_film([](const PixelSum& p) { return p.samples; });
            case PictureLayer::shadow_rays:
                return of_film([](const PixelSum& p) { return p.shadow_rays; });
            case PictureLayer::luminance:
                return add(name + ".Y",
                           [&](std::size_t i) { return mean(i, extras_.first_luminance()); });
            case PictureLayer::illuminance:
                return add(name + ".Y",
                           [&](std::size_t i) { return mean(i, extras_.first_illuminance()); });
        }
    }

    void add_smooth() {
        add_image(std::string(smooth_layer),
                  linear(quiet_ ? quiet_->smooth : smooth_image(film_, files_), files_.format));
    }

    void add_denoised() {
        const QuietFilm quiet = denoised_film(film_, files_);
        add_image(std::string(denoised_layer), linear(quiet.light, files_.format));
        if (extras_.smooth)
            add_image(message(denoised_layer, '.', smooth_layer),
                      linear(quiet.smooth, files_.format));
        for (std::size_t k = 0; k < quiet.lights.size(); ++k)
            add_image(message(denoised_layer, ".light.", files_.lights[k]), quiet.lights[k]);
    }

    void add_image(const std::string& name, const Image& image) {
        for (int c = 0; c < 3; ++c)
            add(message(name, '.', rgb[static_cast<std::size_t>(c)]),
                [&](std::size_t i) { return image.pixels[i][c]; });
    }

    void add_three(const std::string& name, const std::array<const char*, 3>& channels,
                   std::size_t first) {
        for (std::size_t c = 0; c < 3; ++c)
            add(message(name, ".", channels[c]), [&](std::size_t i) { return mean(i, first + c); });
    }

    /// Adds the light of each statement, then the remainder, so that the sum is the picture.
    void add_lights() {
        const auto light = [&](std::size_t i, std::size_t k, std::size_t c) {
            return quiet_ ? quiet_->lights[k].pixels[i][static_cast<int>(c)]
                          : mean(i, extras_.first_light() + 3 * k + c);
        };
        for (std::size_t k = 0; k < files_.lights.size(); ++k)
            for (std::size_t c = 0; c < 3; ++c)
                add(message("light.", files_.lights[k], '.', rgb[c]),
                    [&](std::size_t i) { return light(i, k, c); });
        for (std::size_t c = 0; c < 3; ++c)
            add(message("light.rest.", rgb[c]), [&](std::size_t i) {
                const Rgb whole = quiet_ ? quiet_->light.pixels[i] : film_.pixels()[i].mean();
                double rest = whole[static_cast<int>(c)];
                for (std::size_t k = 0; k < files_.lights.size(); ++k) rest -= light(i, k, c);
                return rest;
            });
    }

    const Film& film_;
    const FilmFiles& files_;
    Aovs extras_;
    std::optional<QuietFilm> quiet_;  ///< of a draft
    LayeredPicture made_;
};

}  // namespace

Aovs aovs_for(std::span<const PictureLayer> layers, bool alpha, const Extras& extras) {
    Aovs aovs;
    aovs.alpha = alpha;
    aovs.smooth = extras.smooth;
    aovs.squares = aovs.surface = extras.denoise;
    for (const PictureLayer layer : layers) {
        aovs.surface |= layer <= PictureLayer::object;
        aovs.lights |= layer == PictureLayer::lights;
        aovs.luminance |= layer == PictureLayer::luminance;
        aovs.illuminance |= layer == PictureLayer::illuminance;
    }
    return aovs;
}

std::vector<std::string> light_names(const World& world, const SourceStore& sources) {
    const Names words;
    std::vector<std::string> names;
    std::set<std::string> taken = {"rest"};
    const Provenance& provenance = world.provenance;
    for (std::size_t k = 0; k < provenance.light_statements.size(); ++k) {
        const std::string called = provenance.light_names[k].empty()
                                       ? name_of(provenance.light_statements[k], sources, words)
                                       : layer_name(provenance.light_names[k]);
        std::string name = called;
        for (int i = 2; !taken.insert(name).second; ++i) name = message(called, "_", i);
        names.push_back(std::move(name));
    }
    return names;
}

Aovs FilmFiles::aovs() const {
    return aovs_for(layers, alpha, {film.smooths_edges(), denoise || draft});
}

bool is_developed(const FilmFiles& files) {
    return files.film.on && files.format.type != PictureType::exr &&
           files.format.type != PictureType::hdr;
}

namespace {

/// The format of a picture that has been developed, whose values are those of a display.
PictureFormat developed_format(PictureFormat format) {
    format.gamma = 1;
    format.encoded = true;
    return format;
}

}  // namespace

bool write_developed(Negative negative, const FilmFiles& files, Diagnostics& diagnostics) {
    const PictureFormat format = developed_format(files.format);
    const std::vector<double> alpha = negative.alpha;
    return write_picture(develop(std::move(negative), files.film, files.threads), files.path,
                         format, diagnostics, alpha);
}

std::string denoised_path(const FilmFiles& files) {
    if (!files.denoise || files.draft || files.format.type == PictureType::exr) return {};
    const std::filesystem::path path(files.path);
    std::filesystem::path made = path;
    return made.replace_extension(".denoised" + path.extension().string()).string();
}

std::string layers_path(const FilmFiles& files) {
    const bool exr = files.format.type == PictureType::exr;
    if (files.layers.empty() && !(exr && (files.film.on || files.denoise))) return {};
    if (exr) return files.path;
    return std::filesystem::path(files.path).replace_extension(".layers.exr").string();
}

namespace {

/// Writes the picture alone in a format without layers.
bool write_flat(Negative negative, const FilmFiles& files, Diagnostics& diagnostics) {
    if (is_developed(files)) return write_developed(std::move(negative), files, diagnostics);
    return write_picture(negative.light, files.path, files.format, diagnostics, negative.alpha);
}

/// The same of the film as it is, row by row.
bool write_flat(const Film& film, const FilmFiles& files, Diagnostics& diagnostics) {
    if (is_developed(files)) return write_developed(negative_of(film, files), files, diagnostics);
    const auto row = [&](int y, std::span<Rgb> pixels, std::span<double> alpha) {
        film_row(film, y, pixels, alpha);
    };
    return write_picture(PictureRows{film.width(), film.height(), files.alpha, row}, files.path,
                         files.format, diagnostics);
}

/// Returns the denoised picture. If it is to be developed, it has the values of a file's layers.
Negative quiet_negative(const Film& film, const FilmFiles& files) {
    QuietFilm quiet = denoised_film(film, files);
    Negative negative = negative_of(film, files);
    negative.light = std::move(quiet.light);
    negative.smooth = std::move(quiet.smooth);
    if (is_developed(files))
        for (Image* image : {&negative.light, &negative.smooth})
            *image = linear(std::move(*image), files.format);
    return negative;
}

bool write_denoised(const Film& film, const FilmFiles& files, const std::string& path,
                    Diagnostics& diagnostics) {
    FilmFiles beside = files;
    beside.path = path;
    return write_flat(quiet_negative(film, files), beside, diagnostics);
}

/// The files with a picture for displays.
FilmFiles for_display(FilmFiles files) {
    files.format.type = PictureType::png;
    files.format.grey = false;
    return files;
}

}  // namespace

std::vector<std::uint8_t> shown_bytes(Negative negative, const FilmFiles& given) {
    const FilmFiles files = for_display(given);
    const bool develops = is_developed(files);
    const std::vector<double> alpha = negative.alpha;
    const Image shown = develops ? develop(std::move(negative), files.film, files.threads)
                                 : std::move(negative.light);
    const auto row = [&](int y, std::span<Rgb> pixels, std::span<double> opaque) {
        const std::size_t first = static_cast<std::size_t>(y) * pixels.size();
        std::ranges::copy(std::span(shown.pixels).subspan(first, pixels.size()), pixels.begin());
        if (!opaque.empty())
            std::ranges::copy(std::span(alpha).subspan(first, pixels.size()), opaque.begin());
    };
    return bytes_of(PictureRows{shown.width, shown.height, !alpha.empty(), row},
                    develops ? developed_format(files.format) : files.format);
}

std::vector<std::uint8_t> shown_bytes(const Film& film, const FilmFiles& given) {
    const FilmFiles files = for_display(given);
    return shown_bytes(files.draft ? quiet_negative(film, files) : negative_of(film, files), files);
}

LayeredPicture layered_picture(const Film& film, const FilmFiles& files) {
    return LayerWriter(film, files).picture();
}

std::size_t bytes_to_write(const FilmFiles& files) {
    // Encoded bytes grow in steps, at each of which the old ones and twice as many exist.
    constexpr std::size_t with_encoded = 4;
    const PictureTypeInfo& type = info(files.format.type);
    const std::size_t channels = (files.format.grey ? 1 : 3) + (files.alpha ? 1 : 0);
    const std::size_t each = type.linear ? sizeof(float) : files.format.bits == 16 ? 2 : 1;
    std::size_t flat = with_encoded * channels * each;
    if (is_developed(files)) {
        const std::size_t images =
            (files.film.smooths_edges() ? 2 : 1) + (files.film.glares ? 5 : 0);
        flat += images * sizeof(Rgb) + (files.alpha ? 2 * sizeof(double) : 0);
    }
    // The images that the denoiser takes and makes.
    constexpr std::size_t images_of_denoiser = 12;
    const std::size_t lights = files.aovs().lights ? 2 * files.lights.size() : 0;
    const std::size_t quiet =
        files.denoise || files.draft ? (images_of_denoiser + lights) * sizeof(Rgb) : 0;
    if (layers_path(files).empty()) return flat + quiet;
    const std::size_t planes = 4 + files.aovs().count(files.lights.size());
    return std::max(flat, with_encoded * planes * sizeof(float)) + quiet;
}

bool write_film(const Film& film, const FilmFiles& files, Diagnostics& diagnostics) {
    const std::string layers = layers_path(files);
    const std::string quiet = files.draft ? files.path : denoised_path(files);
    const bool flat = layers != files.path;
    if (flat && !files.draft && !write_flat(film, files, diagnostics)) return false;
    if (flat && !quiet.empty() && !write_denoised(film, files, quiet, diagnostics)) return false;
    if (layers.empty()) return true;
    const auto bytes = encode(layered_picture(film, files), diagnostics);
    return bytes && write_file(layers, *bytes, diagnostics);
}

}  // namespace candelabra

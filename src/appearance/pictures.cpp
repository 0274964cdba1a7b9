// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/pictures.h"

#include "appearance/model_files.h"
#include "base/long_work.h"
#include "base/video_gamma.h"
#include "formula/formula.h"
#include "text/message.h"
#include "vocabulary/kinds.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace candelabra {

namespace {

using Patterns = Kinds<Pattern>;

constexpr auto file_kinds =
    std::array{"gif"_word, "tga"_word, "iff"_word,  "pot"_word,  "png"_word, "pgm"_word, "ppm"_word,
               "bmp"_word, "sys"_word, "jpeg"_word, "tiff"_word, "exr"_word, "hdr"_word};

bool takes_colours(const Pattern& pattern) { return std::holds_alternative<ImageMap>(pattern); }

/// The coding of a picture's texels by the rules of POV-Ray, which depend on the language version.
TexelCoding coding(const Binder& binder, const Pattern& pattern, const PictureMap& map) {
    TexelCoding result;
    result.gamma = map.gamma;
    result.premultiplied = map.premultiplied;
    result.working_gamma = binder.working_gamma.value_or(1);
    const bool modern = binder.evaluator.version_given() && binder.evaluator.version() >= 3.7;
    if (!takes_colours(pattern) || !(modern || binder.working_gamma))
        result.decode = TexelCoding::as_stored;
    else if (!modern)
        result.decode = TexelCoding::where_said;
    else if (binder.evaluator.version() >= modern_version)
        result.decode = TexelCoding::always_all;
    return result;
}

/// Samples a function at all pixels in 65536 steps from 0 to 1, as POV-Ray does: values outside of
/// that range wrap around. Returns nothing if this exceeds the work limit.
std::optional<Texels> texels_of(const Formula& function, Evaluator& evaluator, Span place) {
    Texels texels;
    texels.width = function.columns();
    texels.height = function.rows();
    const int count = function.results();
    texels.channels = count < 3 ? 1 : 3;
    const auto kept = [](double value) {
        const double steps = std::fmod(std::trunc(65535 * value), 65536);
        return static_cast<float>((steps < 0 ? steps + 65536 : steps) / 65535);
    };
    const auto take = [&](const FunctionResults& results, bool good) {
        const FunctionResults found = good ? results : FunctionResults{};
        for (int i = 0; i < texels.channels; ++i)
            texels.values.push_back(kept(found[static_cast<std::size_t>(i)]));
        if (count == 5) texels.alpha.push_back(kept(1 - found[4]));
    };
    if (!evaluator.sample(function, Evaluator::Rows::from_bottom, place, take)) return std::nullopt;
    if (std::ranges::all_of(texels.alpha, [](float alpha) { return alpha == 1; }))
        texels.alpha.clear();
    texels.measure();
    return texels;
}

/// From version 3.8 on `transmit all` multiplies the opacity of a picture with an alpha channel.
void scale_opacity(ImageMap& image) {
    if (image.transmit == 0 || image.texels->alpha.empty() || !image.texels->table.empty()) return;
    const auto share = static_cast<float>(1 - std::exchange(image.transmit, 0));
    for (float& alpha : image.texels.edit().alpha) alpha *= share;
}

}  // namespace

std::span<const std::string_view> picture_endings(std::string_view kind) {
    struct Endings {
        std::string_view kind;
        std::array<std::string_view, 4> endings;
        std::size_t count;
    };
    static constexpr auto known =
        std::to_array<Endings>({{"png", {".png", ".PNG"}, 2},
                                {"jpeg", {".jpg", ".JPG", ".jpeg", ".JPEG"}, 4},
                                {"tiff", {".tif", ".TIF", ".tiff", ".TIFF"}, 4},
                                {"gif", {".gif", ".GIF"}, 2},
                                {"tga", {".tga", ".TGA"}, 2},
                                {"iff", {".iff", ".IFF"}, 2},
                                {"pot", {".pot", ".POT"}, 2},
                                {"pgm", {".pgm", ".PGM"}, 2},
                                {"ppm", {".ppm", ".PPM"}, 2},
                                {"bmp", {".bmp", ".BMP"}, 2},
                                {"exr", {".exr", ".EXR"}, 2},
                                {"hdr", {".hdr", ".HDR"}, 2}});
    const auto* const found = std::ranges::find(known, kind.empty() ? "png" : kind, &Endings::kind);
    if (found == known.end()) return {};
    return std::span(found->endings).first(found->count);
}

PictureReader::PictureReader(OpenBlock& block, Pattern& pattern)
    : block_(block),
      pattern_(pattern),
      map_(*picture_of(pattern)),
      fields_(block, *Patterns::infos[pattern.index()], Patterns::address(pattern)) {
    block.item = Patterns::infos[pattern.index()];
}

void PictureReader::add_words(WordList& words) const {
    fields_.add_words(words);
    for (const NameId kind : file_kinds) words.push_back(block_.spelling(kind));
    if (takes_colours(pattern_)) words.insert(words.end(), {"filter", "transmit"});
}

bool PictureReader::take(const Element& element) {
    if (take_adjustment(element)) return true;
    if (const Numbers* place = element.value.numbers();
        element.kind == Element::Kind::value && block_.taken == 0 && place && place->count > 1) {
        block_.report(warning(Fault::deprecated, element.span,
                              "a vector before the file, once the place of a picture, has no "
                              "effect since version 3"));
        return true;
    }
    if (element.kind == Element::Kind::word && !fields_.waiting() &&
        std::ranges::find(file_kinds, element.word) != file_kinds.end()) {
        block_.file_kind = block_.spelling(element.word);
        map_.kind = std::string(block_.file_kind);
        return true;
    }
    const auto curve = element.kind == Element::Kind::word && fields_.expected() == "gamma"
                           ? gamma_called(block_.spelling(element.word))
                           : std::nullopt;
    if (curve) {
        Element value = element;
        value.kind = Element::Kind::value;
        value.word = no_name;
        value.value = Numbers::scalar(*curve);
        return fields_.take(value);
    }
    return fields_.take(element);
}

/// Takes a part of `filter all 0.5` or `filter 3, 0.5`.
bool PictureReader::take_adjustment(const Element& element) {
    if (!takes_colours(pattern_)) return false;
    const bool word = element.kind == Element::Kind::word;
    const Tree* tree = element.origin.tree;
    const auto* channel = tree && element.origin.first != no_node
                              ? tree->get_if<node::Channel>(element.origin.first)
                              : nullptr;
    const NameId name = word ? element.word : channel ? channel->channel : no_name;
    if (name == "filter"_word || name == "transmit"_word) {
        adjustment_ = {name == "filter"_word, -1, 0};
        stage_ = word ? Stage::which : Stage::amount;
        const Numbers* numbers = element.value.numbers();
        if (channel && numbers) take_number(numbers->at[adjustment_.filter ? 3 : 4], element.span);
        return true;
    }
    if (stage_ == Stage::which && word && element.word == "all"_word) {
        stage_ = Stage::amount;
        return true;
    }
    if (stage_ != Stage::amount || element.kind != Element::Kind::value) return false;
    stage_ = Stage::none;
    const auto amount = converted(block_, element, FieldType::number,
                                  {[&] { return message("the amount of `", adjusted(), '`'); },
                                   [&] { return block_.help(); }});
    if (!amount) return true;
    adjustment_.amount = std::get<double>(*amount);
    std::get<ImageMap>(pattern_).adjustments.push_back(adjustment_);
    return true;
}

/// Takes the index of the colour that is adjusted.
void PictureReader::take_number(double number, Span span) {
    constexpr double max_colours = 65536;
    if (number >= 0 && number < max_colours) {
        adjustment_.number = static_cast<int>(number);
        // Truncated like other integers, as in POV-Ray.
        if (std::floor(number) != number)
            block_.report(warning(Fault::no_effect, span,
                                  message("a colour has a whole number, and ", number,
                                          " counts as ", adjustment_.number)));
    } else {
        block_.report(error(Fault::out_of_range, span,
                            message("`", adjusted(),
                                    "` of a picture needs the number of a colour, "
                                    "counted from 0, but here is ",
                                    number))
                          .with_help(message(adjusted(), " 3, 0.5, or ", adjusted(), " all 0.5")));
    }
}

void PictureReader::finish() {
    fields_.finish();
    const bool odd_map = map_.map_type == 3 || map_.map_type == 4 || map_.map_type == 6;
    if (stage_ != Stage::none && !block_.broken)
        block_.report(
            error(Fault::missing, block_.span, "`filter` and `transmit` of a picture need a number")
                .with_help("filter all 0.5, or filter 3, 0.5 for the colour number 3"));
    if ((odd_map || map_.interpolate == 1) && !block_.broken)
        block_.report(error(Fault::out_of_range, block_.span,
                            odd_map ? message("there is no `map_type` ", map_.map_type)
                                    : "there is no `interpolate` 1")
                          .with_help(odd_map ? "map_type 0, 1, 2, 5 or 7" : "interpolate 2"));
    auto* bumps = std::get_if<BumpMap>(&pattern_);
    // Directions are as steep as the picture says where nothing else is said.
    if (bumps && bumps->tangent_space && !bumps->bump_size) bumps->bump_size = 1;
    if (bumps && bumps->tangent_space && bumps->map_type != 0 && !block_.broken)
        block_.report(error(Fault::misplaced, block_.span,
                            "a picture in `tangent_space` lies flat, or with `uv_mapping` on the "
                            "surface: it takes no `map_type`")
                          .with_help("normal { uv_mapping bump_map { \"normals.png\" "
                                     "tangent_space } }"));
    if (!block_.broken) load();
}

void PictureReader::load() {
    if (map_.function) {
        if (map_.function->columns() == 0 || map_.function->parameters() > 3) {
            block_.report(error(Fault::wrong_type, block_.span,
                                "the function of a picture needs the number of pixels")
                              .with_help("function 256, 256 { ... }"));
            return;
        }
        auto made = texels_of(*map_.function, block_.binder.evaluator, block_.span);
        if (!made) return;
        map_.texels = make_handle<Texels>(std::move(*made));
    } else if (map_.file.empty()) {
        block_.report(
            error(Fault::missing, block_.span, message(block_.quoted(), " needs a picture"))
                .with_help(message(block_.name, " { \"picture.png\" }")));
        return;
    } else {
        Binder& binder = block_.binder;
        const auto file = map_.picture
                              ? picture_of_model(block_, map_.file, *map_.picture)
                              : binder.evaluator.find_data(map_.file, block_.file_place(),
                                                           picture_endings(block_.file_kind));
        block_.broken |= !file;
        if (!file) return;
        const TexelCoding how = coding(binder, pattern_, map_);
        Handle<Texels>& known = binder.pictures[{file->path, how}];
        if (!known) {
            auto read =
                read_texels(*file, how, binder.evaluator.diagnostics(), block_.file_place());
            block_.broken |= !read;
            if (!read) return;
            constexpr std::uint64_t texels_of_step = 4;
            const auto width = static_cast<std::uint64_t>(read->width);
            count_long_work(width * static_cast<std::uint64_t>(read->height) / texels_of_step);
            known = make_handle<Texels>(std::move(*read));
        }
        map_.texels = known;
    }
    if (auto* image = std::get_if<ImageMap>(&pattern_)) {
        image->adjust();
        if (block_.binder.evaluator.version() >= modern_version) scale_opacity(*image);
    }
}

}  // namespace candelabra

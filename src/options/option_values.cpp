// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/option_values.h"

#include "base/video_gamma.h"
#include "options/declared_values.h"
#include "options/option_table.h"
#include "options/output.h"
#include "options/region.h"
#include "text/message.h"
#include "vocabulary/kinds.h"
#include "vocabulary/written.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>

namespace candelabra {

namespace {

namespace fs = std::filesystem;

using Texts = std::vector<std::string>;

Texts if_given(bool given, std::string text) { return given ? Texts{std::move(text)} : Texts(); }

PictureFormat stored_format(const Options& options) {
    Diagnostics said_elsewhere;
    return output_of(options, said_elsewhere).format;
}

/// Returns the path as from the folder of the scene; an absolute path stays one.
std::string from_scene(const std::string& path, const Options& options) {
    const fs::path folder = fs::path(options.scene.value_or("")).parent_path();
    if (folder.empty() || fs::path(path).is_absolute() || folder.is_absolute()) return path;
    return fs::path(path).lexically_normal().lexically_relative(folder.lexically_normal()).string();
}

Texts folders_from_scene(const Texts& paths, const Options& options) {
    Texts folders;
    for (const std::string& each : paths) folders.push_back(from_scene(each, options));
    return folders;
}

template <class Variant>
Texts name_of(const std::optional<Variant>& chosen) {
    if (!chosen) return {};
    return {std::string(Kinds<Variant>::infos[chosen->index()]->name)};
}

/// Whether the changes leave no film: every other change turns it on again.
bool film_is_off(const std::vector<FilmChange>& changes) {
    bool off = false;
    for (const FilmChange& each : changes)
        if (each.name == "film")
            off = each.value == "off";
        else
            off &= each.name == "glare" && each.value == "off";
    return off;
}

}  // namespace

std::vector<std::string> values_in_force(const OptionRow& row, const Options& options) {
    if (row.values) return row.values(options);
    if (row.own) return changed_values(row.own, options);
    if (row.field.empty()) return {};
    const Setting setting = find_setting(row.field);
    const void* const item = setting.item == &RenderSettings::vocabulary
                                 ? static_cast<const void*>(&options.render)
                                 : static_cast<const void*>(&options.animation);
    const std::string text = written(setting.item->get(item, setting.field), setting.info().type);
    return if_given(!text.empty(), text);
}

bool is_changed(const OptionRow& row, const Options& options) {
    return values_in_force(row, options) != values_in_force(row, Options());
}

std::vector<std::string> words_of(const OptionRow& row, const std::string& value) {
    const bool on = value == "on", sign = row.takes == Takes::sign || on || value == "off";
    if (row.takes == Takes::nothing) return {message("--", row.word)};
    if (!row.letters.empty() && row.takes != Takes::value && sign)
        return {message(on ? '+' : '-', row.letters)};
    if (!row.letters.empty()) return {message('+', row.letters, value)};
    if (!row.word.empty()) return {message("--", row.word), value};
    return {message(row.keyword, '=', value)};
}

std::string ini_option(const OptionRow& row, const std::string& value) {
    if (!row.keyword.empty()) return message(row.keyword, '=', value);
    return row.takes == Takes::nothing ? message("--", row.word)
                                       : message("--", row.word, '=', value);
}

Texts in_force::unsaid(const Options&) { return {}; }

Texts in_force::type(const Options& options) {
    const PictureFormat format = stored_format(options);
    if (format.type == PictureType::png) return {};
    return {format.compressed ? "C" : std::string(1, info(format.type).letter)};
}

Texts in_force::bits(const Options& options) {
    const PictureFormat format = stored_format(options);
    Options usual = options;
    usual.bits.reset();
    return if_given(format.bits != stored_format(usual).bits, message(format.bits));
}

Texts in_force::layers(const Options& options) {
    return if_given(!options.layers.empty(), layer_list(options.layers));
}

Texts in_force::start_row(const Options& options) {
    const int top = region_of(options).top;
    return if_given(top > 0, message(top + 1));
}

Texts in_force::end_row(const Options& options) {
    const int bottom = region_of(options).bottom;
    return if_given(bottom < options.render.height, message(bottom));
}

Texts in_force::start_column(const Options& options) {
    const int left = region_of(options).left;
    return if_given(left > 0, message(left + 1));
}

Texts in_force::end_column(const Options& options) {
    const int right = region_of(options).right;
    return if_given(right < options.render.width, message(right));
}

Texts in_force::sampler(const Options& options) { return name_of(options.render.light_sampler); }

Texts in_force::integrator(const Options& options) { return name_of(options.render.integrator); }

Texts in_force::film(const Options& options, std::string_view field) {
    const auto& changes = options.render.film;
    if (film_is_off(changes)) return if_given(field == "film", "off");
    const auto last = std::find_if(changes.rbegin(), changes.rend(),
                                   [&](const FilmChange& each) { return each.name == field; });
    if (last == changes.rend()) return {};
    return {field == "film" ? "on" : last->value};
}

Texts in_force::glare(const Options& options) {
    if (film_is_off(options.render.film)) return {};
    Texts values;
    for (const FilmChange& each : options.render.film) {
        constexpr std::string_view prefix = "glare.";
        if (each.name == "glare") values.push_back(each.value);
        if (each.name.starts_with(prefix))
            values.push_back(message(each.name.substr(prefix.size()), '=', each.value));
    }
    return values;
}

Texts in_force::library(const Options& options) {
    return folders_from_scene(options.library_paths, options);
}

Texts in_force::first_libraries(const Options& options) {
    return folders_from_scene(options.libraries, options);
}

Texts in_force::header(const Options& options) {
    const std::string& header = options.facts.header;
    return if_given(!header.empty(), from_scene(header, options));
}

Texts in_force::declares(const Options& options) {
    Texts values;
    for (const auto& [name, value] : options.declares) {
        values.push_back(message(name, '=', text_of(value)));
    }
    return values;
}

/// The clock of a frame follows from the animation.
Texts in_force::clock(const Options& options) {
    const RunFacts& facts = options.facts;
    const bool frame = facts.initial_frame != 0 || facts.final_frame != 0;
    return if_given(facts.clock_given && !frame, message(facts.clock));
}

Texts in_force::luminaires(const Options& options) {
    const auto& above = options.render.luminaires_above;
    if (!above) return {};
    return {std::isinf(*above) ? "none" : message(*above)};
}

Texts in_force::gamma(const Options& options) {
    if (options.file_gamma == bt709_gamma) return {"bt709"};
    if (options.file_gamma == bt2020_gamma) return {"bt2020"};
    return if_given(options.file_gamma > 0, message(options.file_gamma));
}

}  // namespace candelabra

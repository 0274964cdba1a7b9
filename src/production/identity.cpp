// SPDX-License-Identifier: GPL-3.0-or-later
#include "production/identity.h"

#include "base/video_gamma.h"
#include "options/command_line.h"
#include "options/option_table.h"
#include "options/option_values.h"
#include "production/version.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/sha256.h"

#include <algorithm>
#include <filesystem>
#include <utility>

namespace candelabra {

namespace {

constexpr std::string_view file_prefix = "file ";
constexpr std::string_view even = "even";
constexpr std::string_view command_mark = "command";
constexpr std::string_view film_mark = "developed";

std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return text;
}

std::string fact_name(const OptionRow& row) {
    return std::string(!row.field.empty() ? row.field : !row.word.empty() ? row.word : row.keyword);
}

/// Returns the name of the fact of the option with that long name.
std::string fact_of(std::string_view long_name) {
    const OptionRow* row = find_option(long_name);
    return row ? fact_name(*row) : std::string();
}

/// Adds the options that change the picture.
void add_options(Identity& identity, const Options& options) {
    for (const OptionRow& row : option_table()) {
        if (row.changes != Changes::picture) continue;
        // A picture that is no frame has no word of animations.
        const bool frames = find_setting(row.field).item == &AnimationSettings::vocabulary;
        if (frames && !is_changed(row, options)) continue;
        std::string all;
        for (const std::string& value : values_in_force(row, options)) {
            const std::size_t equals = value.find('=');
            // Each declared name is a fact of its own.
            if (row.parameter == "name=value")
                identity.emplace_back(
                    one_line(message(fact_name(row), '=', value.substr(0, equals))),
                    one_line(value.substr(equals + 1)));
            else
                all += message(all.empty() ? "" : ",", value);
        }
        if (!all.empty()) identity.emplace_back(fact_name(row), one_line(all));
    }
}

std::string sampling(const Options& options) {
    if (options.time) return "as the time allows";
    if (options.render.noise > 0) return message("until the noise is below ", options.render.noise);
    if (!samples_are_adaptive(options)) return std::string(even);
    std::string text;
    for (const OptionRow& row : option_table())
        if (row.changes == Changes::adaptive)
            for (const std::string& value : values_in_force(row, options))
                text += message(text.empty() ? "adaptive: " : ", ", fact_name(row), ' ', value);
    return text;
}

}  // namespace

Identity identity_of(const Options& options, const std::vector<ReadFile>& files,
                     const PictureFormat& format) {
    Identity identity = {{"program", std::string(program_name())}};
    for (const ReadFile& file : files)
        identity.emplace_back(
            message(file_prefix, one_line(std::filesystem::path(file.path).filename().string())),
            file.digest);
    add_options(identity, options);
    identity.emplace_back("sampling", sampling(options));
    if (const RunFacts& facts = options.facts; facts.initial_frame != 0 || facts.final_frame != 0)
        identity.emplace_back("frame_number", message(facts.frame_number));
    identity.emplace_back("gamma", message(format.gamma));
    identity.emplace_back("encoded", format.encoded ? "yes" : "no");
    identity.emplace_back(command_mark, one_line(command_line(options)));
    return identity;
}

std::string scene_digest(const Identity& identity) {
    std::string files;
    for (const auto& [name, value] : identity)
        if (name.starts_with(file_prefix))
            files += message(value, "  ", name.substr(file_prefix.size()), "\n");
    return sha256(files);
}

std::string description(const Identity& identity, int samples, const PictureFormat& format) {
    std::string text = message(fact(identity, "program"), "; scene ");
    bool first = true;
    for (const auto& [name, value] : identity)
        if (name.starts_with(file_prefix) && std::exchange(first, false))
            text += name.substr(file_prefix.size());
    text += message(", sha256 ", scene_digest(identity), ";");
    for (const auto& [name, value] : identity)
        if (name != "program" && name != command_mark && !name.starts_with(file_prefix))
            text += message(' ', name, '=', value, ';');
    if (fact(identity, "sampling") == even) text += message(" samples=", samples, ';');
    return message(text, " made by: ", fact(identity, std::string(command_mark)),
                   format_options(format));
}

void note_film(Identity& identity, const FilmSettings& film) {
    if (film.on) identity.emplace_back(std::string(film_mark), to_text(film));
}

void tell_layers(const Identity& identity, FilmFiles& files) {
    const auto has = [&](std::string_view name) { return !fact(identity, fact_of(name)).empty(); };
    files.denoise = has("denoise");
    files.draft = has("draft");
    files.film = film_from_text(fact(identity, std::string(film_mark))).value_or(FilmSettings());
    files.alpha = has("output-alpha");
    files.layers =
        read_layer_list(fact(identity, fact_of("layers"))).value_or(std::vector<PictureLayer>());
    std::string names = fact(identity, "lights");
    while (!names.empty()) {
        const std::size_t end = std::min(names.find(','), names.size());
        files.lights.push_back(names.substr(0, end));
        names.erase(0, end + 1);
    }
}

void note_lights(Identity& identity, std::span<const std::string> names) {
    std::string text;
    for (const std::string& name : names) text += message(text.empty() ? "" : ",", name);
    identity.emplace_back("lights", text);
}

double file_gamma_of(const Identity& identity) {
    const std::string said = fact(identity, fact_of("file-gamma"));
    return number(said).value_or(gamma_called(said).value_or(srgb_gamma));
}

std::string to_text(const Identity& identity) {
    std::string text;
    for (const auto& [name, value] : identity) text += message(name, '\t', value, '\n');
    return text;
}

Identity identity_from(const std::string& text) {
    Identity identity;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        const std::size_t tab = std::min(line.find('\t'), line.size());
        identity.emplace_back(line.substr(0, tab), line.substr(std::min(tab + 1, line.size())));
        at = end + 1;
    }
    return identity;
}

std::string fact(const Identity& identity, const std::string& name) {
    const auto found = std::ranges::find(identity, name, &Fact::first);
    return found == identity.end() ? std::string() : found->second;
}

std::string difference(const Identity& before, const Identity& now) {
    const auto look = [&](const Identity& some, const Identity& others) {
        for (const auto& [name, value] : some) {
            if (name == "sampling" && fact(now, name) == even) continue;
            if (name == command_mark) continue;  // redundant: derived from the other facts
            // Several files may share the same name.
            if (std::ranges::find(others, Fact{name, value}) != others.end()) continue;
            const std::string called = printable(name);
            if (name.starts_with(file_prefix)) {
                const bool known = !fact(others, name).empty();
                const std::string file = called.substr(file_prefix.size());
                if (known) return message("`", file, "` has changed");
                return &some == &now ? message("`", file, "` was not read then")
                                     : message("`", file, "` is not read any more");
            }
            const auto shown = [&name = name](const Identity& identity) {
                const std::string text = fact(identity, name);
                return text.empty() ? std::string("not given") : printable(text);
            };
            return message(called, " was ", shown(before), " and is ", shown(now));
        }
        return std::string();
    };
    const std::string found = look(now, before);
    return found.empty() ? look(before, now) : found;
}

}  // namespace candelabra

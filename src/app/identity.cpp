// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/identity.h"

#include "app/command_line.h"
#include "app/help.h"
#include "app/region.h"
#include "text/message.h"
#include "text/printable.h"
#include "text/sha256.h"
#include "vocabulary/written.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <utility>

namespace candelabra {

namespace {

constexpr std::string_view file_prefix = "file ";
constexpr std::string_view even = "even";
constexpr std::string_view command_mark = "command";

std::string one_line(std::string text) {
    std::ranges::replace_if(
        text, [](char c) { return c == '\n' || c == '\t'; }, ' ');
    return text;
}

/// Adds the settings of the rendering, except the numbers of rays and of threads.
void add_settings(Identity& identity, const RenderSettings& settings) {
    static constexpr auto left_out = std::to_array<std::string_view>(
        {"samples", "threads", "noise", "sampling_method", "antialias_threshold", "antialias_depth",
         "antialias_gamma", "jitter", "jitter_amount"});
    const ItemInfo& info = RenderSettings::vocabulary;
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
        const FieldInfo& field = info.fields[i];
        if (std::ranges::find(left_out, field.name) == left_out.end())
            identity.emplace_back(field.name, written(info.get(&settings, i), field.type));
    }
    const auto& sampler = settings.light_sampler;
    identity.emplace_back(
        "light-sampler",
        sampler ? std::string(Kinds<LightSampler>::infos[sampler->index()]->name) : "the scene's");
    if (settings.integrator)
        identity.emplace_back(
            "integrator",
            std::string(Kinds<IntegratorSettings>::infos[settings.integrator->index()]->name));
}

std::string sampling(const Options& options) {
    const RenderSettings& settings = options.render;
    if (options.time) return "as the time allows";
    if (settings.noise > 0) return message("until the noise is below ", settings.noise);
    if (settings.samples > 0 || !settings.antialias) return std::string(even);
    return message("adaptive with method ", settings.sampling_method, ", threshold ",
                   settings.antialias_threshold, ", depth ", settings.antialias_depth, ", gamma ",
                   settings.antialias_gamma, " and jitter ",
                   settings.jitter ? settings.jitter_amount : 0);
}

void add_facts(Identity& identity, const RunFacts& facts) {
    if (facts.clock_given) identity.emplace_back("clock", message(facts.clock));
    if (facts.version) identity.emplace_back("version", message(*facts.version));
    if (facts.final_frame == 0 && facts.initial_frame == 0) return;
    identity.emplace_back("frame_number", message(facts.frame_number));
    identity.emplace_back("frames", message(facts.initial_frame, " to ", facts.final_frame));
    identity.emplace_back("clocks", message(facts.initial_clock, " to ", facts.final_clock, " by ",
                                            facts.clock_delta));
}

}  // namespace

Identity identity_of(const Options& options, const std::vector<ReadFile>& files,
                     const PictureFormat& format) {
    Identity identity = {{"program", version_text().substr(0, version_text().find('\n'))}};
    for (const ReadFile& file : files)
        identity.emplace_back(
            message(file_prefix, one_line(std::filesystem::path(file.path).filename().string())),
            file.digest);
    add_settings(identity, options.render);
    identity.emplace_back("sampling", sampling(options));
    for (const auto& [name, value] : options.declares)
        identity.emplace_back(
            message("Declare=", name),
            std::visit([](const auto& v) { return one_line(message(v)); }, value));
    add_facts(identity, options.facts);
    const Region region = region_of(options);
    if (region != Region{0, 0, options.render.width, options.render.height})
        identity.emplace_back(
            "region", message(region.left, ' ', region.top, ' ', region.right, ' ', region.bottom));
    if (options.alpha) identity.emplace_back("alpha", "yes");
    if (options.denoise) identity.emplace_back("denoise", "yes");
    if (!options.layers.empty()) identity.emplace_back("layers", layer_list(options.layers));
    identity.emplace_back("gamma", message(format.gamma));
    identity.emplace_back("encoded", format.encoded ? "yes" : "no");
    if (format.file_gamma > 0) identity.emplace_back("file_gamma", message(format.file_gamma));
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

std::string description(const Identity& identity, int samples) {
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
    return message(text, " made by: ", fact(identity, std::string(command_mark)));
}

void note_film(Identity& identity, const FilmSettings& film) {
    if (film.on) identity.emplace_back("film", to_text(film));
}

void tell_layers(const Identity& identity, FilmFiles& files) {
    files.denoise = fact(identity, "denoise") == "yes";
    files.film = film_from_text(fact(identity, "film")).value_or(FilmSettings());
    files.alpha = fact(identity, "alpha") == "yes";
    files.layers = read_layer_list(fact(identity, "layers")).value_or(std::vector<PictureLayer>());
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

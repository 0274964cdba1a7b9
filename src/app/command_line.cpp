// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line.h"

#include "app/child.h"
#include "app/region.h"
#include "text/message.h"
#include "vocabulary/kinds.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace candelabra {

namespace {

class Words {
public:
    template <class... Pieces>
    void add(const Pieces&... pieces) {
        text_ += message(text_.empty() ? "" : " ", shell_word(message(pieces...)));
    }
    /// Adds an option whose value is a separate word.
    template <class Value>
    void add_long(std::string_view option, const Value& value) {
        add("--", option);
        add(value);
    }
    /// Adds an option if its value differs from the default.
    template <class Value>
    void add_changed(std::string_view option, const Value& value, const Value& usual) {
        if (value != usual) add(option, value);
    }
    template <class Value>
    void add_given(std::string_view option, const std::optional<Value>& value) {
        if (value) add(option, *value);
    }

    std::string take() { return std::move(text_); }

private:
    std::string text_;
};

void add_scene(Words& words, const std::string& scene) {
    const std::string name = std::filesystem::path(scene).filename().string();
    // A name that looks like an option needs the switch +I.
    const bool plain = scene == "-" || (name.find('=') == name.npos && !name.starts_with('-') &&
                                        !name.starts_with('+'));
    words.add(plain ? "" : "+I", name);
}

void add_sampling(Words& words, const Options& options) {
    const RenderSettings& settings = options.render;
    const RenderSettings usual = Options().render;
    const bool adaptive = settings.samples == 0 && settings.noise == 0 && !options.time;
    if (!settings.antialias) {
        words.add("-A");
    } else if (adaptive) {
        words.add_changed("+A", settings.antialias_threshold, usual.antialias_threshold);
        words.add_changed("+AM", settings.sampling_method, usual.sampling_method);
        words.add_changed("+R", settings.antialias_depth, usual.antialias_depth);
        words.add_changed("+AG", settings.antialias_gamma, usual.antialias_gamma);
        if (settings.jitter)
            words.add_changed("+J", settings.jitter_amount, usual.jitter_amount);
        else
            words.add("-J");
    }
    if (settings.samples != usual.samples) words.add_long("samples", settings.samples);
    if (settings.noise != usual.noise) words.add_long("noise", settings.noise);
    if (options.time) words.add_long("time", message(*options.time, 's'));
    if (settings.shadow_rays != usual.shadow_rays)
        words.add_long("shadow-rays", settings.shadow_rays);
    if (settings.light_sampler)
        words.add_long("light-sampler",
                       Kinds<LightSampler>::infos[settings.light_sampler->index()]->name);
    if (settings.integrator)
        words.add_long("integrator",
                       Kinds<IntegratorSettings>::infos[settings.integrator->index()]->name);
    if (settings.seed != usual.seed) words.add_long("seed", settings.seed);
}

void add_film(Words& words, const std::vector<FilmChange>& changes) {
    constexpr std::string_view glare = "glare.";
    for (const FilmChange& each : changes) {
        std::string option = each.name, value = each.value;
        if (option.starts_with(glare)) {
            value = message(option.substr(glare.size()), '=', value);
            option = "glare";
        }
        std::ranges::replace(option, '_', '-');
        words.add_long(option, value);
    }
}

/// Adds the options that select this frame alone.
void add_frame(Words& words, const Options& options) {
    const AnimationSettings& animation = options.animation;
    const AnimationSettings usual;
    if (options.facts.initial_frame == 0 && options.facts.final_frame == 0) {
        if (options.facts.clock_given) words.add("+K", options.facts.clock);
        return;
    }
    words.add_given("+KFI", animation.initial_frame);
    words.add_given("+KFF", animation.final_frame);
    words.add_changed("+KI", animation.initial_clock, usual.initial_clock);
    words.add_changed("+KF", animation.final_clock, usual.final_clock);
    if (animation.cyclic) words.add("+KC");
    words.add("+SF", options.facts.frame_number);
    words.add("+EF", options.facts.frame_number);
}

void add_region(Words& words, const Options& options) {
    const Region region = region_of(options);
    if (region.left > 0) words.add("+SC", region.left + 1);
    if (region.right < options.render.width) words.add("+EC", region.right);
    if (region.top > 0) words.add("+SR", region.top + 1);
    if (region.bottom < options.render.height) words.add("+ER", region.bottom);
}

}  // namespace

std::string command_line(const Options& options) {
    Words words;
    words.add("candelabra");
    add_scene(words, options.scene.value_or("-"));
    words.add("+W", options.render.width);
    words.add("+H", options.render.height);
    add_sampling(words, options);
    words.add_changed("+Q", options.render.quality, RenderSettings().quality);
    if (options.render.ambient_luminaires) words.add("--ambient-luminaires");
    if (const auto& above = options.render.luminaires_above)
        words.add_long("luminaires", std::isinf(*above) ? message("none") : message(*above));
    for (const auto& [name, value] : options.declares) {
        const auto* text = std::get_if<std::string>(&value);
        words.add("Declare=", name, '=',
                  text ? message('"', *text, '"') : message(std::get<double>(value)));
    }
    add_frame(words, options);
    if (!options.facts.header.empty())
        words.add("+HI", std::filesystem::path(options.facts.header).filename().string());
    words.add_given("+MV", options.facts.version);
    add_region(words, options);
    add_film(words, options.render.film);
    if (options.denoise) words.add("--denoise");
    if (options.alpha) words.add("+UA");
    if (options.file_gamma > 0) words.add("File_Gamma=", options.file_gamma);
    if (!options.layers.empty()) words.add_long("layers", layer_list(options.layers));
    return words.take();
}

}  // namespace candelabra

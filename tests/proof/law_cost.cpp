// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/colour.h"
#include "proof/laws.h"
#include "render/render.h"

#include <regex>

namespace candelabra::proof {

namespace {

/// What a sample has to be, in means of its pixel, to be seen as an error of its own.
constexpr double glaring = 50;
/// Glaring samples in a picture that chance may bring.
constexpr int by_chance = 10;

Image one(double value) {
    Image image(1, 1);
    image.pixels.front() = Rgb(value);
    return image;
}

/// A number that a picture of the script has.
Term number(const Script& script, View view) {
    Term term = picture(script).front();
    term.view = std::move(view);
    return term;
}

Image none(const Prepared&, int, int, const Deadline&) { return one(0); }

/// Samples, each of them as a picture.
std::optional<std::vector<Image>> samples_of(const Prepared& scene, const Deadline& end) {
    std::vector<Image> all;
    for (int seed = 1; seed <= 32; ++seed) {
        all.push_back(scene.render(1, seed, end));
        if (all.back().pixels.empty()) return {};
    }
    return all;
}

double glaring_samples(const std::vector<Image>& samples, const Image& mean) {
    double count = 0;
    for (const Image& sample : samples)
        for (std::size_t i = 0; i < sample.pixels.size(); ++i)
            count += grey(sample.pixels[i]) > glaring * grey(mean.pixels[i]);
    return count;
}

Image mean_of(const std::vector<Image>& one_way, const std::vector<Image>& other_way) {
    Image mean(one_way.front().width, one_way.front().height);
    for (const auto* samples : {&one_way, &other_way})
        for (const Image& sample : *samples)
            for (std::size_t i = 0; i < mean.pixels.size(); ++i)
                mean.pixels[i] +=
                    abs(sample.pixels[i]) / static_cast<double>(one_way.size() + other_way.size());
    return mean;
}

std::string without_finishes(const std::string& text) {
    static const std::regex finish(R"(finish \{[^{}]*(\{[^{}]*\}[^{}]*)*\})");
    static const std::regex emission(R"(emission [-+0-9.e]+( no_luminaire)?)");
    std::string dull;
    auto rest = text.cbegin();
    for (std::sregex_iterator i(text.begin(), text.end(), finish), last; i != last; ++i) {
        dull.append(rest, text.cbegin() + i->position());
        const std::string words = i->str();
        std::smatch found;
        const bool glows = std::regex_search(words, found, emission);
        dull += "finish { ambient 0 diffuse 0 " + (glows ? found.str() : "") + " }";
        rest = text.cbegin() + i->position() + i->length();
    }
    return dull.append(rest, text.cend());
}

Image shadow_rays(const Prepared& scene, int, int, const Deadline& end) {
    const RenderSettings wanted = scene.settings(2, 1);
    RenderHooks hooks;
    hooks.cancelled = [&end] { return end.over(); };
    RenderState state = begin_picture(wanted);
    LightLedger ledger;
    if (!advance(plan_of(scene.shot(), wanted), state, ledger, hooks)) return {};
    return one(static_cast<double>(ledger.shadow));
}

}  // namespace

Claims no_glaring_samples(const Script& script, Dice&) {
    const Script usual = with_setting(script, "light_sampler", "light_octree"),
                 plain = with_setting(script, "light_sampler", "every_light");
    const auto more = [plain](const Prepared& scene, int, int, const Deadline& end) {
        const Prepared opponent({}, written(plain), plain.options);
        const auto own = samples_of(scene, end), others = samples_of(opponent, end);
        if (!own || !others) return Image();
        const Image mean = mean_of(*own, *others);
        const double fewer = 3 * glaring_samples(*others, mean) + by_chance;
        return one(std::fmax(glaring_samples(*own, mean) - fewer, 0));
    };
    return {same_bytes("no more glaring samples than with every_light", {number(usual, more)},
                       {number(usual, none)})};
}

Claims free_in_the_dark(const Script& script, Dice&) {
    Term dark = number(script, shadow_rays);
    dark.text = without_finishes(dark.text);
    return {same_bytes("no shadow rays", {dark}, {number(script, none)})};
}

}  // namespace candelabra::proof

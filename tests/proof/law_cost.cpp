// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/colour.h"
#include "proof/laws.h"
#include "render/render.h"

#include <regex>

namespace candelabra::proof {

namespace {

/// What a sample has to be, in means of the others of its pixel, to be seen as an error of its own:
/// 50 times the mean of 128 samples that it is one of.
constexpr double glaring = 50 * 127.0 / (128 - 50);
/// Glaring samples in a picture that chance may bring.
constexpr int by_chance = 10;
/// Samples of a first look, which goes on where one way has more glaring ones; and of all.
constexpr int few = 8, all = 32;

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

/// Samples of two ways, each of them as a picture.
struct TwoWays {
    std::vector<Image> own = {}, other = {};

    /// Adds samples until each way has so many; returns false if it takes too long.
    bool take(std::size_t count, const Prepared& scene, const Prepared& opponent,
              const Deadline& end) {
        while (own.size() < count) {
            const int seed = static_cast<int>(own.size()) + 1;
            own.push_back(scene.render(1, seed, end));
            other.push_back(opponent.render(1, seed, end));
            if (own.back().pixels.empty() || other.back().pixels.empty()) return false;
        }
        return true;
    }
    /// The sum of all samples of each pixel.
    Image sum() const {
        Image sum(own.front().width, own.front().height);
        for (const auto* samples : {&own, &other})
            for (const Image& sample : *samples)
                for (std::size_t i = 0; i < sum.pixels.size(); ++i)
                    sum.pixels[i] += abs(sample.pixels[i]);
        return sum;
    }
    /// How many of the samples are glaring beside all others of their pixels.
    double glaring_ones(const std::vector<Image>& samples) const {
        const Image total = sum();
        const double others = static_cast<double>(own.size() + other.size() - 1);
        double count = 0;
        for (const Image& sample : samples)
            for (std::size_t i = 0; i < sample.pixels.size(); ++i) {
                const double value = grey(sample.pixels[i]);
                count += value * others > glaring * (grey(total.pixels[i]) - value);
            }
        return count;
    }
};

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
    const auto plan = plan_of(scene.shot(), wanted, hooks.cancelled);
    if (!plan || !advance(*plan, state, ledger, hooks)) return {};
    return one(static_cast<double>(ledger.shadow));
}

}  // namespace

Claims no_glaring_samples(const Script& script, Dice&) {
    const Script usual = with_setting(script, "light_sampler", "light_octree"),
                 plain = with_setting(script, "light_sampler", "every_light");
    const auto more = [plain](const Prepared& scene, int, int, const Deadline& end) {
        const Prepared opponent({}, written(plain), plain.options);
        TwoWays ways;
        if (!ways.take(few, scene, opponent, end)) return Image();
        if (ways.glaring_ones(ways.own) <= ways.glaring_ones(ways.other) + 1) return one(0);
        if (!ways.take(all, scene, opponent, end)) return Image();
        const double fewer = 3 * ways.glaring_ones(ways.other) + by_chance;
        return one(std::fmax(ways.glaring_ones(ways.own) - fewer, 0));
    };
    return {same_bytes("no more glaring samples than with every_light", {number(usual, more)},
                       {number(usual, none)})};
}

Claims free_in_the_dark(const Script& drawn, Dice&) {
    Script script = drawn;
    for (Element& each : script.elements) each = with_plain_models(std::move(each));
    Term dark = number(script, shadow_rays);
    dark.text = without_finishes(dark.text);
    return {same_bytes("no shadow rays", {dark}, {number(script, none)})};
}

}  // namespace candelabra::proof

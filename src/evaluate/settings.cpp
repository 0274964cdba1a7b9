// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/settings.h"

#include "base/gamma.h"
#include "evaluate/item_block.h"
#include "text/message.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace {

struct BackgroundColour {
    Colour colour;

    static const ItemInfo vocabulary;
};

const ItemInfo BackgroundColour::vocabulary = described<BackgroundColour>([] {
    return schema<BackgroundColour>(
        "background", "What rays see that meet nothing.",
        Field<BackgroundColour>{"colour", &BackgroundColour::colour, positional,
                                "the colour in all directions"});
});

std::string sampler_form() {
    std::string names;
    for (const ItemInfo* sampler : Kinds<LightSampler>::infos)
        if (sampler != &LightOctree::vocabulary)
            names += message(names.empty() ? "" : ", ", sampler->name);
    return message("{ light_octree [threshold n] ... }, or one of: ", names);
}

/// Parameters of light_octree that only the paper's version looks at, and those that it does not.
constexpr auto words_of_paper =
    std::to_array<std::string_view>({"threshold", "white", "max_bright", "representatives"});
constexpr auto words_of_cuts = std::to_array<std::string_view>({"eta", "cut", "outlook", "alone"});

/// The name of a sampler, alone, with its parameters behind it or in braces.
class SamplerReader {
public:
    SamplerReader(OpenBlock& block, LightSampler& sampler)
        : block_(block), sampler_(sampler), fields_(block, EveryLight::vocabulary, &sampler) {}

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants(); }

    bool take(const Element& element) {
        const bool named =
            element.kind == Element::Kind::word || element.kind == Element::Kind::block;
        const std::size_t kind = !fields_.waiting() && element.word != no_name
                                     ? Kinds<LightSampler>::find(block_.spelling(element.word))
                                     : Kinds<LightSampler>::count;
        if (kind == Kinds<LightSampler>::count) return chosen_ && fields_.take(element);
        // A name that the scene has declared as something else arrives as its value.
        if (!named && element.kind != Element::Kind::value) return false;
        if (chosen_) {
            block_.report(error(Fault::duplicate, element.word_span,
                                "`light_sampler` has one strategy, and this is a second")
                              .with_help(block_.help()));
            return true;
        }
        chosen_ = true;
        sampler_ = Kinds<LightSampler>::make(kind);
        fields_.rebind(*Kinds<LightSampler>::infos[kind], Kinds<LightSampler>::address(sampler_));
        if (element.kind == Element::Kind::block)
            read_parameters(element, *Kinds<LightSampler>::infos[kind]);
        return true;
    }

    void finish() {
        fields_.finish();
        warn_of_idle(fields_, block_.span);
        if (!chosen_ && !block_.broken)
            block_.report(
                error(Fault::missing, block_.span, "`light_sampler` needs the name of a strategy")
                    .with_help(block_.help()));
    }

    void add_words(WordList& words) const {
        for (const ItemInfo* info : Kinds<LightSampler>::infos) words.push_back(info->name);
        fields_.add_words(words);
    }

private:
    void read_parameters(const Element& element, const ItemInfo& info) {
        OpenBlock inner(block_.binder, info.name, element.word_span);
        inner.item = &info;
        ItemReader fields(inner, info, Kinds<LightSampler>::address(sampler_));
        inner.read(element.body, fields);
        block_.broken |= inner.broken;
        warn_of_idle(fields, element.word_span);
    }

    /// Tells of parameters that the others leave without effect.
    void warn_of_idle(const ItemReader& fields, Span span) {
        const auto* octree = std::get_if<LightOctree>(&sampler_);
        if (!octree) return;
        const auto check = [&](std::string_view word, std::string_view why) {
            if (fields.given(word))
                block_.report(
                    warning(Fault::no_effect, span,
                            message('`', word, "` of `light_octree` has no effect ", why)));
        };
        for (const std::string_view word : words_of_paper)
            if (!octree->paper) check(word, "without `paper`");
        for (const std::string_view word : words_of_cuts)
            if (octree->paper) check(word, "with `paper`");
        if (octree->alone && !octree->paper) check("outlook", "with `alone`");
    }

    OpenBlock& block_;
    LightSampler& sampler_;
    ItemReader fields_;
    bool chosen_ = false;
};

/// light_sampler { ... } in global_settings.
class SamplerBlock : public SimpleReader {
public:
    SamplerBlock(OpenBlock& block, LightSampler& sampler) : block_(block), sampler_(sampler) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block ||
            block_.spelling(element.word) != "light_sampler")
            return false;
        OpenBlock inner(block_.binder, "light_sampler", element.word_span);
        const std::string form = sampler_form();
        inner.form = form;
        SamplerReader reader(inner, sampler_);
        inner.read(element.body, reader);
        return true;
    }
    void add_words(WordList& words) const { words.push_back("light_sampler"); }

private:
    OpenBlock& block_;
    LightSampler& sampler_;
};

/// The fields; `assumed_gamma srgb` is the one that has a word for its value.
class SettingsFields {
public:
    SettingsFields(OpenBlock& block, GlobalSettings& settings)
        : block_(block),
          settings_(settings),
          fields_(block, GlobalSettings::vocabulary, &settings) {}

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants(); }
    bool given(std::string_view field) const { return fields_.given(field); }
    bool take(const Element& element) {
        const bool of_gamma = fields_.waiting() && fields_.expected() == "assumed_gamma";
        if (!of_gamma) return fields_.take(element);
        srgb_ = element.kind == Element::Kind::word && element.word == "srgb"_word;
        Element value = element;
        if (srgb_) {
            value.kind = Element::Kind::value;
            value.word = no_name;
            value.value = Numbers::scalar(1);
        }
        const bool taken = fields_.take(value);
        // Colours behind it in the block are in its space.
        block_.binder.evaluator.set_working_gamma(gamma());
        return taken;
    }
    double gamma() const { return srgb_ ? srgb_gamma : settings_.assumed_gamma; }
    void finish() { fields_.finish(); }
    void add_words(WordList& words) const { fields_.add_words(words); }

private:
    OpenBlock& block_;
    GlobalSettings& settings_;
    ItemReader fields_;
    bool srgb_ = false;
};

/// luminaires ambient
class LuminairesReader : public SimpleReader {
public:
    LuminairesReader(OpenBlock& block, bool& ambient) : block_(block), ambient_(ambient) {}

    bool waiting() const { return waiting_; }
    bool wants() const { return waiting_; }
    bool take(const Element& element) {
        const bool word = element.kind == Element::Kind::word;
        if (!waiting_) return waiting_ = word && block_.spelling(element.word) == "luminaires";
        if (!word || (element.word != "ambient"_word && element.word != "emission"_word))
            return false;
        ambient_ = element.word == "ambient"_word;
        waiting_ = false;
        return true;
    }
    void finish() {
        if (waiting_ && !block_.broken)
            block_.report(error(Fault::missing, block_.span,
                                "`luminaires` needs to know what makes one: `ambient` as well, or "
                                "`emission` only")
                              .with_help("global_settings { luminaires ambient }"));
    }
    void add_words(WordList& words) const { words.push_back("luminaires"); }

private:
    OpenBlock& block_;
    bool& ambient_;
    bool waiting_ = false;
};

}  // namespace

void read_global_settings(Binder& binder, const Element& element, GlobalSettings& settings,
                          GivenSettings& before) {
    OpenBlock block(binder, "global_settings", element.word_span);
    block.item = &GlobalSettings::vocabulary;
    block.effectless =
        "charset utf8 ascii sys hf_gray_16 max_intersections "
        "radiosity photons";
    const double gamma = settings.assumed_gamma;
    SettingsFields fields(block, settings);
    SamplerBlock sampler(block, settings.light_sampler);
    LuminairesReader luminaires(block, settings.ambient_luminaires);
    ItemBlock subsurface(block, SubsurfaceSettings::vocabulary, &settings.subsurface,
                         &settings.subsurface.on, "radiosity");
    block.read(element.body, luminaires, fields, sampler, subsurface);
    settings.max_trace_level = std::max(settings.max_trace_level, 1);
    if (fields.given("noise_generator"))
        binder.evaluator.noise()->given = noise_generator(settings.noise_generator);
    if (!fields.given("assumed_gamma")) return;
    settings.assumed_gamma = fields.gamma();
    if (before.gamma) {
        block.report(warning(Fault::duplicate, element.word_span,
                             "`assumed_gamma` has been given before; the first one counts"));
        settings.assumed_gamma = gamma;
    }
    before.gamma = true;
    binder.working_gamma = settings.assumed_gamma;
    binder.evaluator.set_working_gamma(settings.assumed_gamma);
}

void read_background(Binder& binder, const Element& element, Background& background) {
    OpenBlock block(binder, "background", element.word_span);
    block.item = &BackgroundColour::vocabulary;
    BackgroundColour made;
    ItemReader fields(block, *block.item, &made);
    block.read(element.body, fields);
    if (!block.broken) background.colour = made.colour;
}

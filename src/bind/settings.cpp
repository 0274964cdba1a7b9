// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/settings.h"

#include "base/gamma.h"
#include "reading/choice_block.h"
#include "reading/item_block.h"
#include "text/message.h"
#include "vocabulary/schema.h"

#include <algorithm>

namespace candelabra {

namespace {

std::string sampler_form() {
    std::string names;
    for (const ItemInfo* sampler : Kinds<LightSampler>::infos)
        if (sampler != &LightOctree::vocabulary)
            names += message(names.empty() ? "" : ", ", sampler->name);
    return message("{ light_octree [threshold n] ... }, or one of: ", names);
}

/// Warns of parameters that have no effect in combination with others.
void warn_of_idle(OpenBlock& block, const LightSampler& sampler, const ItemReader& fields,
                  Span span) {
    const std::string_view strategy = Kinds<LightSampler>::infos[sampler.index()]->name;
    for (const IdleField& idle : idle_fields(sampler))
        if (fields.given(idle.name))
            block.report(
                warning(Fault::no_effect, span,
                        message('`', idle.name, "` of `", strategy, "` has no effect ", idle.why)));
}

/// Parameters of radiosity that control POV-Ray's cache.
constexpr auto words_of_cache = std::to_array<std::string_view>(
    {"count", "error_bound", "nearest_count", "low_error_factor", "minimum_reuse", "maximum_reuse",
     "pretrace_start", "pretrace_end", "adc_bailout", "always_sample", "subsurface", "save_file",
     "load_file"});

/// Parameters of photons that control POV-Ray's photon map.
constexpr auto words_of_map = std::to_array<std::string_view>(
    {"jitter", "autostop", "expand_thresholds", "save_file", "load_file"});

ChoiceBlock<LightSampler> sampler_block(OpenBlock& block, LightSampler& sampler) {
    return {block, {"light_sampler", "strategy", sampler_form()}, warn_of_idle, sampler};
}

/// Check for choices whose parameters always have an effect.
template <class Variant>
void all_have_effect(OpenBlock&, const Variant&, const ItemReader&, Span) {}

ChoiceBlock<RayIndex> index_block(OpenBlock& block, RayIndex& index) {
    return {block,
            {"index", "structure", "{ kd_tree [node_cost n] ... }, or { bounding_boxes }"},
            all_have_effect<RayIndex>,
            index};
}

ChoiceBlock<IntegratorSettings> integrator_block(OpenBlock& block, IntegratorSettings& integrator) {
    return {block,
            {"integrator", "way of following light", "{ pov_ray }, or { path_traced [bounces n] }"},
            all_have_effect<IntegratorSettings>,
            integrator};
}

/// Reads the fields, among which `assumed_gamma` may have the word `srgb` as its value.
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
        // Subsequent colours in the block are in this colour space.
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

/// Reads luminaires emission, luminaires ambient, luminaires none, luminaires above 0.5.
class LuminairesReader : public SimpleReader {
public:
    LuminairesReader(OpenBlock& block, GlobalSettings& settings)
        : block_(block), settings_(settings) {}

    bool waiting() const { return state_ != State::none; }
    bool wants() const { return waiting(); }
    bool take(const Element& element) {
        if (state_ == State::above) return take_number(element);
        if (element.kind != Element::Kind::word) return false;
        const std::string_view word = block_.spelling(element.word);
        if (state_ == State::none) {
            if (word == "luminaires") state_ = State::which;
            return waiting();
        }
        if (word == "above") {
            state_ = State::above;
            return true;
        }
        if (word != "ambient" && word != "emission" && word != "none") return false;
        settings_.ambient_luminaires = word == "ambient";
        set(word == "none" ? INFINITY : 0);
        return true;
    }
    void finish() {
        if (waiting() && !block_.broken)
            block_.report(
                error(Fault::missing, block_.span,
                      "`luminaires` needs to know what makes one: `emission` (the "
                      "default), `ambient` as well, `none`, or what is `above` a radiance")
                    .with_help("global_settings { luminaires above 0.5 }"));
    }
    void add_words(WordList& words) const { words.push_back("luminaires"); }

private:
    enum class State { none, which, above };

    bool take_number(const Element& element) {
        const Numbers* value =
            element.kind == Element::Kind::value ? element.value.numbers() : nullptr;
        if (!value || !value->is_scalar()) return false;
        set(std::fmax(value->at[0], 0));
        return true;
    }
    void set(double above) {
        settings_.luminaires_above = above;
        settings_.luminaires_said = true;
        state_ = State::none;
    }

    OpenBlock& block_;
    GlobalSettings& settings_;
    State state_ = State::none;
};

/// As in POV-Ray, no photons are gathered if the most are fewer than the least.
void check_photons(OpenBlock& block, PhotonSettings& photons, Span span) {
    if (photons.gather <= photons.gather_most) return;
    photons.on = false;
    block.report(warning(Fault::no_effect, span,
                         "there are no photons: the second number of `gather` is below the first")
                     .with_help("global_settings { photons { count 20000 gather 20, 100 } }"));
}

}  // namespace

void read_global_settings(Binder& binder, const Element& element, GlobalSettings& settings,
                          GivenSettings& before) {
    OpenBlock block(binder, "global_settings", element.word_span);
    block.item = &GlobalSettings::vocabulary;
    block.ignored = "charset utf8 ascii sys hf_gray_16 hf_grey_16 max_intersections";
    // Strings are read as UTF-8, which contains ASCII, so `charset` needs no warning.
    if (!binder.evaluator.has_foreign_strings()) binder.warned.emplace("charset");
    const double gamma = settings.assumed_gamma;
    SettingsFields fields(block, settings);
    auto sampler = sampler_block(block, settings.light_sampler);
    auto index = index_block(block, settings.index);
    auto integrator = integrator_block(block, settings.integrator);
    LuminairesReader luminaires(block, settings);
    ItemBlock photometry(block, PhotometricUnits::vocabulary, &settings.photometry);
    ItemBlock subsurface(block, SubsurfaceSettings::vocabulary, &settings.subsurface,
                         &settings.subsurface.on, "radiosity");
    ItemBlock radiosity(block, Radiosity::vocabulary, &settings.radiosity, &settings.radiosity.on,
                        "importance brilliance");
    radiosity.without_effect(words_of_cache, "light is gathered without a cache");
    ItemBlock photons(block, PhotonSettings::vocabulary, &settings.photons, &settings.photons.on);
    photons.without_effect(words_of_map, "photons are shot anew again and again");
    block.read(element.body, luminaires, fields, sampler, index, integrator, photometry, subsurface,
               radiosity, photons);
    if (!binder.evaluator.set_light_units(settings.light_units()))
        block.report(error(Fault::misplaced, element.word_span,
                           "amounts of light have been converted by other units before")
                         .with_help("put `global_settings { photometry { unit 0.01 } }` before the "
                                    "first lumen(), candela(), lux(), nit() or watt()"));
    check_photons(block, settings.photons, element.word_span);
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

}  // namespace candelabra

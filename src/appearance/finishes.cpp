// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/finishes.h"

#include "appearance/media.h"
#include "appearance/webs.h"
#include "base/elementary.h"
#include "reading/item_block.h"
#include "reading/item_reader.h"
#include "text/message.h"
#include "vocabulary/manual.h"

#include <algorithm>
#include <set>

namespace candelabra {

namespace {

/// Reads reflection amount, reflection { ... } and reflection_exponent.
class ReflectionReader {
public:
    ReflectionReader(OpenBlock& block, Reflection& reflection)
        : block_(block), reflection_(reflection) {}

    bool waiting() const { return waiting_ || awaits_exponent_; }
    bool wants() const { return waiting(); }

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value && awaits_exponent_) {
            awaits_exponent_ = false;
            const auto value =
                converted(block_, element, FieldType::number,
                          {[] { return std::string("`reflection_exponent` of `finish`"); },
                           [] { return std::string("reflection_exponent 1"); }});
            if (!value) return true;
            constexpr double least = 1e-6;
            const double given = std::get<double>(*value);
            reflection_.exponent = std::max(given, least);
            if (!(given > 0))
                block_.report(warning(Fault::no_effect, element.span,
                                      message("`reflection_exponent` of `finish` should be above "
                                              "0, but it is ",
                                              given, ": ", least, " counts"))
                                  .with_help("reflection_exponent 1"));
            return true;
        }
        if (element.kind == Element::Kind::value && waiting_) {
            waiting_ = false;
            const auto value = converted(block_, element, FieldType::rgb,
                                         {[] { return std::string("`reflection` of `finish`"); },
                                          [] { return usage(Reflection::vocabulary); }});
            if (value) reflection_.least = reflection_.greatest = rgb_of(std::get<Vec3>(*value));
            return true;
        }
        const bool named =
            (element.kind == Element::Kind::word || element.kind == Element::Kind::block) &&
            element.word == "reflection"_word;
        const bool unknown = element.kind == Element::Kind::word &&
                             !block_.binder.evaluator.names().reserved(element.word);
        if (waiting() && !unknown) finish();
        if (element.kind == Element::Kind::word && element.word == "reflection_exponent"_word) {
            span_ = element.word_span;
            return awaits_exponent_ = true;
        }
        if (!named) return false;
        span_ = element.word_span;
        if (element.kind == Element::Kind::block)
            read(element);
        else
            waiting_ = true;
        return true;
    }

    void finish() {
        if (std::exchange(awaits_exponent_, false))
            block_.report(error(Fault::missing, span_, "`reflection_exponent` needs a number")
                              .with_help("reflection_exponent 1"));
        if (!std::exchange(waiting_, false)) return;
        block_.report(
            error(Fault::missing, span_, "`reflection` of `finish` needs a colour or a block")
                .with_help(usage(Reflection::vocabulary)));
    }

    void add_words(WordList& words) const {
        words.insert(words.end(), {"reflection", "reflection_exponent"});
    }

private:
    void read(const Element& element) {
        OpenBlock inner(block_.binder, "reflection", element.word_span);
        inner.item = &Reflection::vocabulary;
        // As in POV-Ray, fields that are not given keep their values in the finish.
        Reflection made = reflection_;
        ItemReader fields(inner, *inner.item, &made);
        fields.alone("metallic", 1);
        inner.read(element.body, fields);
        if (fields.positional_given() < 2) {
            made.greatest = made.least;
            if (made.fresnel && fields.given("fresnel")) made.least = Rgb(0);
        }
        block_.broken |= inner.broken;
        reflection_ = made;
    }

    OpenBlock& block_;
    Reflection& reflection_;
    bool waiting_ = false, awaits_exponent_ = false;
    Span span_;
};

/// Reads subsurface { ... }.
class SubsurfaceReader : public ItemBlock {
public:
    SubsurfaceReader(OpenBlock& block, Subsurface& subsurface)
        : ItemBlock(block, Subsurface::vocabulary, &subsurface),
          block_(block),
          subsurface_(subsurface) {}

    bool take(const Element& element) {
        if (!ItemBlock::take(element)) return false;
        if (min_component(subsurface_.translucency) < 0)
            block_.report(error(Fault::out_of_range, element.word_span,
                                "`translucency` of `subsurface` must be at least 0 in each channel")
                              .with_help(usage(Subsurface::vocabulary)));
        return true;
    }

private:
    OpenBlock& block_;
    Subsurface& subsurface_;
};

/// Reads the fields of a finish. Some amounts may be given as `albedo`, which depends on other
/// fields.
class FinishFields {
public:
    FinishFields(OpenBlock& block, Finish& finish)
        : fields_(block, Finish::vocabulary, &finish), finish_(finish) {
        fields_.alone("metallic", 1);
    }

    bool waiting() const { return fields_.waiting(); }
    bool wants() const { return fields_.wants(); }

    bool take(const Element& element) {
        const bool word = element.kind == Element::Kind::word;
        const std::string_view expected = fields_.expected();
        if (word && element.word == "albedo"_word &&
            (expected == "diffuse" || expected == "phong" || expected == "specular")) {
            albedo_.emplace(expected);
            return true;
        }
        return fields_.take(element);
    }

    void finish() {
        fields_.finish();
        for (const std::string_view amount : albedo_) convert(amount);
    }

    void add_words(WordList& words) const { fields_.add_words(words); }

private:
    /// Converts an albedo, the total fraction of scattered light, to the amount in POV-Ray's
    /// formula.
    void convert(std::string_view amount) {
        if (amount == "diffuse") finish_.diffuse *= (finish_.brilliance + 1) / 2;
        if (amount == "diffuse") finish_.diffuse_back *= (finish_.brilliance + 1) / 2;
        if (amount == "phong") finish_.phong *= (finish_.phong_size + 1) / 2;
        if (amount == "specular") {
            const double exponent = 1 / finish_.roughness;
            finish_.specular *= (exponent + 2) / (4 * (2 - math::exp2(-exponent / 2)));
        }
    }

    ItemReader fields_;
    Finish& finish_;
    std::set<std::string_view> albedo_;
};

template <class Content>
bool read_content(OpenBlock& block, const Content& content, Finish& finish) {
    block.item = &Finish::vocabulary;
    auto declared = named<Finish>(block, [&](const Handle<Finish>& other) { finish = *other; });
    FinishFields fields(block, finish);
    ReflectionReader reflection(block, finish.reflection);
    ItemBlock irid(block, Irid::vocabulary, &finish.irid);
    ItemBlock microfacet(block, Microfacet::vocabulary, &finish.microfacet, &finish.microfacet.on);
    SubsurfaceReader subsurface(block, finish.subsurface);
    LampReader lamp(block, finish.lamp);
    block.read(content, declared, microfacet, fields, reflection, irid, subsurface, lamp);
    if (finish.use_alpha && finish.microfacet.on)
        block.report(warning(Fault::no_effect, block.span,
                             "`use_alpha` has no effect on `microfacet`: over a clear pigment its "
                             "facets reflect as they are"));
    if (lamp.given()) finish.emission = lamp_emission(*finish.lamp, finish.emission);
    return !block.broken;
}

}  // namespace

bool read_finish(Binder& binder, const Element& element, Finish& finish) {
    OpenBlock block(binder, "finish", element.word_span);
    return read_content(block, element.body, finish);
}

bool read_legacy_finish(Binder& binder, const ElementList& words, Span span, Finish& finish) {
    OpenBlock block(binder, "texture", span);
    return read_content(block, words, finish);
}

bool read_interior(Binder& binder, const Element& element, Interior& interior) {
    OpenBlock block(binder, "interior", element.word_span);
    block.item = &Interior::vocabulary;
    // In POV-Ray, only the finish determines the transmitted light.
    block.ignored = "photons refraction";
    auto declared =
        named<Interior>(block, [&](const Handle<Interior>& other) { interior = *other; });
    ItemReader fields(block, *block.item, &interior);
    MediaReader media(block, interior.media);
    block.read(element.body, declared, fields, media);
    const auto emits = [](const Media& each) { return each.emission != Rgb(0); };
    if (interior.luminaire && fields.given("luminaire") &&
        std::ranges::none_of(interior.media, emits))
        block.report(warning(Fault::no_effect, element.word_span,
                             "`luminaire` has no effect: no media of the interior emit light")
                         .with_help("interior { media { emission 2 } luminaire }"));
    return !block.broken;
}

}  // namespace candelabra

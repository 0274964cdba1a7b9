// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/media.h"

#include "appearance/textures.h"
#include "reading/item_block.h"
#include "reading/item_reader.h"
#include "reading/transforms.h"

#include <array>

namespace candelabra {

namespace {

/// Words that control POV-Ray's sampling methods; here `intervals` and `samples` set the effort.
constexpr auto words_of_sampling = std::to_array<std::string_view>(
    {"method", "aa_level", "aa_threshold", "confidence", "variance", "ratio", "jitter"});

/// Reads scattering { type, colour ... }; the last one counts.
class ScatteringReader : public SimpleReader {
public:
    ScatteringReader(OpenBlock& block, Scattering& scattering)
        : block_(block), scattering_(scattering) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || element.word != "scattering"_word) return false;
        OpenBlock inner(block_.binder, "scattering", element.word_span);
        inner.item = &Scattering::vocabulary;
        Scattering made;
        ItemReader fields(inner, *inner.item, &made);
        inner.read(element.body, fields);
        if (fields.given("eccentricity") &&
            made.type != static_cast<int>(PhaseKind::henyey_greenstein))
            inner.report(error(Fault::misplaced, element.word_span,
                               "`eccentricity` belongs to scattering of type 5")
                             .with_help("scattering { 5, rgb 0.1 eccentricity 0.4 }"));
        block_.broken |= inner.broken;
        scattering_ = made;
        return true;
    }

    void add_words(WordList& words) const { words.push_back("scattering"); }

private:
    OpenBlock& block_;
    Scattering& scattering_;
};

/// Reads density { ... } blocks.
class DensityReader : public SimpleReader {
public:
    DensityReader(OpenBlock& block, Media& media) : block_(block), media_(media) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block || element.word != "density"_word) return false;
        Pigment density;
        density.colour.rgb = Rgb(1);
        block_.broken |= !read_density(block_.binder, element, density);
        media_.densities.push_back(std::move(density));
        return true;
    }

    void add_words(WordList& words) const { words.push_back("density"); }

private:
    OpenBlock& block_;
    Media& media_;
};

}  // namespace

bool read_media(Binder& binder, const Element& element, Media& media) {
    OpenBlock block(binder, "media", element.word_span);
    block.item = &Media::vocabulary;
    auto declared = named<Media>(block, [&](const Handle<Media>& other) { media = *other; });
    ItemReader fields(block, *block.item, &media);
    fields.repeatable();
    fields.alone("collect", 1);
    ScatteringReader scattering(block, media.scattering);
    DensityReader densities(block, media);
    // As in POV-Ray, later densities are not transformed.
    const auto apply = [&](const Transform& transform) {
        media = transformed(std::move(media), transform);
    };
    TransformReader moves(block, apply);
    block.read(element.body, declared, fields, scattering, densities, moves);
    warn_of_idle_fields(
        block, block.name, fields,
        {words_of_sampling, "light between surfaces is estimated without bias in any case"},
        element.word_span);
    return !block.broken;
}

bool MediaReader::take(const Element& element) {
    if (element.kind != Element::Kind::block || element.word != "media"_word) return false;
    Media media;
    block_.broken |= !read_media(block_.binder, element, media);
    media_.push_back(std::move(media));
    return true;
}

}  // namespace candelabra

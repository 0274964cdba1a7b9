// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/backdrops.h"

#include "appearance/colour_maps.h"
#include "appearance/textures.h"
#include "reading/transforms.h"
#include "text/message.h"
#include "vocabulary/schema.h"

namespace candelabra {

namespace {

struct BackgroundColour {
    Colour colour;

    static const ItemInfo vocabulary;
};

const ItemInfo BackgroundColour::vocabulary = described<BackgroundColour>([] {
    return schema<BackgroundColour>(
        "background", "What rays see that meet nothing.",
        maybe(Field<BackgroundColour>{"colour", &BackgroundColour::colour, positional,
                                      "the colour in all directions; without it black"}));
});

/// Reads the pigments of a sky, each over the preceding one.
class SkyPigments : public SimpleReader {
public:
    SkyPigments(OpenBlock& block, SkySphere& sky) : block_(block), sky_(sky) {}

    bool take(const Element& element) {
        if (element.kind == Element::Kind::value) {
            const auto pigment = element.value.handle<Pigment>();
            if (pigment) sky_.pigments.push_back(*pigment);
            return pigment != nullptr;
        }
        if (element.kind != Element::Kind::block || element.word != "pigment"_word) return false;
        Pigment pigment = block_.binder.default_texture->pigment;
        block_.broken |= !read_pigment(block_.binder, element, pigment);
        sky_.pigments.push_back(std::move(pigment));
        return true;
    }

    void finish() {
        if (!block_.broken && sky_.pigments.empty())
            block_.report(error(Fault::missing, block_.span, "`sky_sphere` needs a pigment")
                              .with_help(block_.help()));
    }

    void add_words(WordList& words) const { words.push_back("pigment"); }

private:
    OpenBlock& block_;
    SkySphere& sky_;
};

/// Reads the colours of a rainbow, from its inner edge to its outer edge.
class RainbowColours : public SimpleReader {
public:
    RainbowColours(OpenBlock& block, ColourMap& map) : block_(block), map_(map) {}

    bool take(const Element& element) {
        if (element.kind != Element::Kind::block ||
            (element.word != "color_map"_word && element.word != "colour_map"_word))
            return false;
        ColourMap map;
        block_.broken |= !read_colour_map(block_.binder, element, map);
        map_ = std::move(map);
        return true;
    }
    void finish() {
        if (block_.broken || !map_.empty()) return;
        map_.push_back({0, {Rgb(0), 0, 1}});
        block_.report(warning(Fault::missing, block_.span,
                              "this rainbow is not seen: `rainbow` needs a `color_map`")
                          .with_help(block_.help()));
    }
    void add_words(WordList& words) const { words.push_back("color_map"); }

private:
    OpenBlock& block_;
    ColourMap& map_;
};

}  // namespace

bool read_sky_sphere(Binder& binder, const Element& element, SkySphere& sky) {
    OpenBlock block(binder, "sky_sphere", element.word_span);
    block.item = &SkySphere::vocabulary;
    block.form = "{ pigment { ... } [emission rgb 1] [transformations] }";
    auto declared = named<SkySphere>(block, [&](const Handle<SkySphere>& other) { sky = *other; });
    ItemReader fields(block, *block.item, &sky);
    SkyPigments pigments(block, sky);
    const auto apply = [&](const Transform& transform) {
        for (Pigment& pigment : sky.pigments) pigment.transform = pigment.transform.then(transform);
    };
    TransformReader moves(block, apply);
    block.read(element.body, declared, pigments, fields, moves);
    return !block.broken;
}

bool read_fog(Binder& binder, const Element& element, Fog& fog) {
    OpenBlock block(binder, "fog", element.word_span);
    block.item = &Fog::vocabulary;
    auto declared = named<Fog>(block, [&](const Handle<Fog>& other) { fog = *other; });
    ItemReader fields(block, *block.item, &fog);
    const auto apply = [&](const Transform& transform) { fog.up = transform.direction(fog.up); };
    TransformReader moves(block, apply);
    block.read(element.body, declared, fields, moves);
    if (!block.broken && fog.fog_type == 2 && fog.up == Vec3(0))
        block.report(warning(Fault::degenerate, element.word_span,
                             "`up` of `fog` is 0: as in POV-Ray, everything in this fog is black")
                         .with_help("`up y` measures heights along y"));
    return !block.broken;
}

bool read_rainbow(Binder& binder, const Element& element, Rainbow& rainbow) {
    OpenBlock block(binder, "rainbow", element.word_span);
    block.item = &Rainbow::vocabulary;
    auto declared = named<Rainbow>(block, [&](const Handle<Rainbow>& other) { rainbow = *other; });
    ItemReader fields(block, *block.item, &rainbow);
    RainbowColours colours(block, rainbow.map);
    const auto apply = [&](const Transform& transform) {
        rainbow.direction = transform.direction(rainbow.direction);
        rainbow.up = transform.direction(rainbow.up);
    };
    TransformReader moves(block, apply);
    block.read(element.body, declared, colours, fields, moves);
    const std::string wrong = problem(rainbow);
    if (!block.broken && !wrong.empty())
        block.report(error(Fault::degenerate, element.word_span, wrong).with_help(block.help()));
    if (!block.broken && (rainbow.width == 0 || rainbow.distance == 0))
        block.report(warning(Fault::no_effect, element.word_span,
                             message("this rainbow is not seen: its `",
                                     rainbow.width == 0 ? "width" : "distance", "` is 0"))
                         .with_help(block.help()));
    return !block.broken;
}

void read_background(Binder& binder, const Element& element, Background& background) {
    OpenBlock block(binder, "background", element.word_span);
    block.item = &BackgroundColour::vocabulary;
    BackgroundColour made;
    ItemReader fields(block, *block.item, &made);
    block.read(element.body, fields);
    if (!block.broken) background.colour = made.colour;
}

}  // namespace candelabra

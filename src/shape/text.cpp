// SPDX-License-Identifier: GPL-3.0-or-later
#include "shape/text.h"

#include "vocabulary/schema.h"

namespace candelabra {

const ItemInfo Text::vocabulary = described<Text>([] {
    using F = Field<Text>;
    return schema<Text>(
        "text",
        {"Letters of a font with a thickness.",
         "text { ttf \"timrom.ttf\" \"Abc\" 0.3, 0 scale 1.5 translate <-1.2, 0.4, 0> }",
         "text { internal 1 \"Abc\" 0.3, 0 scale 1.5 translate <-1.2, 0.4, 0> }"},
        F{"text", &Text::text, positional, "what is written, in UTF-8"},
        F{"thickness", &Text::thickness, positional, "from z = 0 backwards"},
        F{"offset", &Text::offset, positional, "added from letter to letter: <x, y>"},
        F{"ttf", &Text::font, item, "name of the font's file"},
        F{"internal", &Text::internal, item,
          "one of POV-Ray's fonts instead: 1 timrom, 2 cyrvetic, 3 crystal, 4 povlogo"});
});

namespace {

Vec3 exchanged(const Vec3& v) { return {v.x, v.z, v.y}; }

}  // namespace

std::string problem(const Text& text) {
    if (text.font.empty() && text.internal == 0) return "a `text` needs `ttf` or `internal`";
    return {};
}

std::string vanishes(const Text& text) {
    return text.letters && !text.letters->loops.empty() ? "" : "it has no visible letter";
}

BuiltText build(const Text& text) {
    return {{Outline(text.letters->loops), std::fmin(0, text.thickness),
             std::fmax(0, text.thickness), false, false}};
}

Box bounds(const BuiltText& text) {
    const Box box = bounds(text.prism);
    return {exchanged(box.low), exchanged(box.high)};
}

void crossings(const BuiltText& text, const Ray& ray, Crossings& found) {
    Crossings met;
    crossings(text.prism, {exchanged(ray.origin), exchanged(ray.direction)}, met);
    for (std::size_t i = 0; i < met.size(); ++i)
        found.add({met[i].t, exchanged(met[i].normal), met[i].entering});
}

bool inside(const BuiltText& text, const Vec3& point) {
    return inside(text.prism, exchanged(point));
}

}  // namespace candelabra

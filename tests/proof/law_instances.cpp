// SPDX-License-Identifier: GPL-3.0-or-later
#include "proof/laws.h"
#include "scene/settings.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace candelabra::proof {

namespace {

/// Every union that stands in two places or more is stored once, if its look moves with it.
const Studio& sharing() {
    static const Studio studio = [] {
        Studio made;
        made.instances = {2, std::numeric_limits<std::size_t>::max(), 2};
        return made;
    }();
    return studio;
}

/// A random number of few digits.
std::string short_number(Dice& dice, double low, double high) {
    return text_of(std::round(1000 * dice.between(low, high)) / 1000);
}

/// A part of the union in a colour of its own, with a pattern that moves with the part, or clear.
Element coloured(Element shape, Dice& dice, const std::string& glow = "") {
    const std::string red = short_number(dice, 0, 1), green = short_number(dice, 0, 1);
    const std::string colour = "rgb <" + red + ", " + green + ", 0.7>";
    const std::string finish = " finish { diffuse 0.7 " + glow + "}";
    std::string look = "pigment { " + colour + " }" + finish;
    if (glow.empty() && dice.chance(0.5)) {
        const std::string map = " color_map { [0 rgb 0.1] [1 " + colour + "] } scale 0.2 }";
        // No map jumps on a face of the parts: there rounding would decide between its ends.
        const std::vector<std::string> patterns = {
            "pigment { wood turbulence 0.1" + map + finish,
            "pigment { granite" + map + " normal { bumps 0.6 scale 0.1 }" + finish,
            "texture { gradient y texture_map { [0 pigment { " + colour +
                " } normal { dents 0.5 scale 0.1 }" + finish + "] [1 pigment { onion" + map +
                finish + "] } scale 0.31 translate 0.013*y }",
            "pigment { slope y" + map + " normal { ripples 0.4 scale 0.1 }" + finish,
            "pigment { " + colour + " transmit 0.7 } interior { ior 1.3 }" + finish,
            "pigment { checker rgb 0.4 rgbf <1, 0.9, 0.6, 0.8> scale 0.13 }" + finish,
        };
        look = patterns[dice.below(patterns.size())];
    }
    shape.inner.push_back(words(look));
    return shape;
}

/// A map for one of the places: a similarity, as lamps need, or any other one.
std::string map_of_copy(Dice& dice) {
    std::string map = "scale " + short_number(dice, 0.7, 1.3);
    if (dice.chance(0.3)) {
        const std::string tall = short_number(dice, 0.6, 1.5), shear = short_number(dice, -0.4, 0.4);
        map =
            "scale <1, " + tall + ", -1> matrix <1, " + shear + ", 0, 0, 1, 0, 0.2, 0, 1, 0, 0, 0>";
    }
    map += " rotate " + short_number(dice, -60, 60) + "*x rotate " + short_number(dice, 0, 360) + "*y";
    for (const char* axis : {"x", "y", "z"}) {
        const bool up = *axis == 'y';
        map += " translate " + short_number(dice, up ? 0.3 : -1.5, 1.5) + "*" + axis;
    }
    return map;
}

}  // namespace

/// A union that stands in some places, with lamps or without, beside all else.
Script with_copies(Draft& draft) {
    Script script = staged(draft);
    Dice& dice = draft.dice;
    std::vector<Element> parts = {coloured(block("sphere", "0, 0.25"), dice),
                                  coloured(block("box", "<-0.3, -0.3, -0.1>, <0, 0, 0.1>"), dice)};
    const std::string glow = "emission 2 ";
    if (dice.chance(0.7))
        parts.push_back(coloured(block("sphere", "<0.1, 0.4, 0>, 0.06"), dice, glow));
    if (dice.chance(0.4))
        parts.push_back(coloured(block("box", "<0.2, -0.3, 0>, <0.3, 0.1, 0.05>"), dice, glow));
    if (dice.chance(0.5)) {
        Element shape = draft.shape;
        shape.inner.push_back(words("scale 0.5"));
        parts.push_back(coloured(shape, dice, dice.chance(0.3) ? glow : ""));
    }
    script.elements.push_back(needed(words("#declare Copied =")));
    script.elements.push_back(needed(block("union", "", parts)));
    for (std::size_t places = 2 + dice.below(4); places > 0; --places)
        script.elements.push_back(block("object", "Copied " + map_of_copy(dice)));
    return script;
}

namespace {

/// What the script looks like if unions are stored once.
std::vector<Term> seen_once(const Script& script) {
    std::vector<Term> terms = picture(script);
    Term& term = terms.front();
    term.view = [text = term.text, options = term.options](const Prepared&, int samples, int seed,
                                                           const Deadline& end) {
        const Prepared shared(sharing(), text, options);
        return shared.render(samples, seed, end);
    };
    return terms;
}

/// The script without light: the colours of its surfaces are seen, and have no noise.
Script without_light(Script script) {
    const auto& fields = RenderSettings::vocabulary.fields;
    const auto quality = std::ranges::find(fields, "quality", &FieldInfo::name);
    script.options.push_back({static_cast<std::size_t>(quality - fields.begin()), 1});
    return script;
}

}  // namespace

/// A pattern that does not move with its union hardly changes the mean of a block, so colours are
/// compared one by one.
Claims stored_once(const Script& script, Dice&) {
    const Script colours = without_light(script);
    return {
        same_bytes("colours stored once = taken apart", seen_once(colours), picture(colours), 1e-3),
        same_mean("stored once = taken apart", seen_once(script), picture(script))};
}

}  // namespace candelabra::proof

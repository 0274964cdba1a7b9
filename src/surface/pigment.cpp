// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pigment.h"

#include "surface/map_place.h"
#include "surface/pigment_map.h"

#include <algorithm>

namespace {

bool passes_light(const Colour& c) { return c.filter != 0 || c.transmit != 0; }

Colour averaged(const PigmentMap& map, const Vec3& place, const PatternScene& scene) {
    Colour sum;
    double total = 0;
    for (const PigmentStop& stop : map) {
        const Colour colour = evaluate(stop.pigment, place, scene);
        sum.rgb += stop.value * colour.rgb;
        sum.filter += stop.value * colour.filter;
        sum.transmit += stop.value * colour.transmit;
        total += stop.value;
    }
    return {sum.rgb / total, sum.filter / total, sum.transmit / total};
}

Colour colour_at(const PatternedPigment& pigment, const Vec3& point, const PatternScene& scene) {
    const Vec3 place = pigment.use.place(point);
    const auto* colours = std::get_if<ColourMap>(&pigment.map);
    if (colours) return look_up(*colours, pigment.use.value(place, scene));
    const auto& pigments = std::get<PigmentMap>(pigment.map);
    if (std::holds_alternative<Average>(pigment.use.pattern))
        return averaged(pigments, place, scene);
    const MapPlace at = place_in(pigments, pigment.use.value(place, scene));
    const Colour below = evaluate(pigments[at.below].pigment, place, scene);
    if (at.share == 0) return below;
    return mixed(below, evaluate(pigments[at.above].pigment, place, scene), at.share);
}

}  // namespace

Colour evaluate(const Pigment& pigment, const Vec3& point, const PatternScene& scene) {
    if (!pigment.pattern) return pigment.colour;
    return colour_at(*pigment.pattern, pigment.transform.inverse_point(point), scene);
}

PatternedPigment::PatternedPigment(PatternUse the_use, Map the_map)
    : use(std::move(the_use)), map(std::move(the_map)) {
    brightest = Vec3(-std::numeric_limits<double>::infinity());
    nesting = {1, 0};
    const auto add = [&](const Vec3& greatest, bool passes, const Nesting& inner) {
        brightest = glm::max(brightest, greatest);
        clear |= passes;
        nesting.add(inner);
    };
    if (const auto* colours = std::get_if<ColourMap>(&map))
        for (const ColourStop& stop : *colours) add(stop.colour.rgb, passes_light(stop.colour), {});
    else
        for (const PigmentStop& stop : std::get<PigmentMap>(map))
            add(::brightest(stop.pigment), transparent(stop.pigment), ::nesting(stop.pigment));
    if (const auto* grey = std::get_if<PigmentGrey>(&use.pattern))
        nesting.add({grey->depth, grey->entries});
}

Nesting nesting(const Pigment& pigment) {
    return pigment.pattern ? pigment.pattern->nesting : Nesting();
}

Vec3 brightest(const Pigment& pigment) {
    return pigment.pattern ? pigment.pattern->brightest : pigment.colour.rgb;
}

bool transparent(const Pigment& pigment) {
    return pigment.pattern ? pigment.pattern->clear : passes_light(pigment.colour);
}

PigmentGrey grey_of(Pigment pigment) {
    const Nesting inner = nesting(pigment);
    const auto code = [](const void* data, const Vec3& point, const PatternScene& scene) {
        return grey(evaluate(*static_cast<const Pigment*>(data), point, scene).rgb);
    };
    return {
        {std::make_shared<const Pigment>(std::move(pigment)), code}, inner.depth, inner.entries};
}

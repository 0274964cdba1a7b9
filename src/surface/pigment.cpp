// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface/pigment.h"

#include "surface/map_place.h"
#include "surface/pigment_map.h"

#include <algorithm>

namespace candelabra {

namespace {

bool passes_light(const Colour& c) { return c.filter != 0 || c.transmit != 0; }

/// Cubic interpolation overshoots the values that it interpolates, by up to this factor.
constexpr double overshoot = 1.6;

Rgb greatest(const ImageMap& map) {
    if (!map.texels) return Rgb(0);
    const Rgb result = max(map.texels->greatest, Rgb(map.once ? 1 : 0));
    return map.interpolate == 3 ? overshoot * result : result;
}

bool passes_light(const ImageMap& map) {
    if (map.once || map.filter != 0 || map.transmit != 0) return true;
    return map.texels && (map.texels->transparent() ||
                          std::ranges::any_of(map.texels->table,
                                              [](const Colour& c) { return passes_light(c); }));
}

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
    if (const auto* image = std::get_if<ImageMap>(&pigment.use.pattern))
        return colour_at(*image, place).value_or(Colour{Rgb(1), 0, 1});
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

Vec3 own_place(const Pigment& pigment, const Vec3& point, const PatternScene& scene) {
    return pigment.transform.inverse_point(pigment.uv ? uv_place(scene) : point);
}

/// Whether there is no colour at a point, because it is outside an image that is not repeated.
bool misses(const Pigment& pigment, const Vec3& point, const PatternScene& scene) {
    if (!pigment.pattern) return false;
    const PatternUse& use = pigment.pattern->use;
    const auto* image = std::get_if<ImageMap>(&use.pattern);
    return image && image->once && !colour_at(*image, use.place(own_place(pigment, point, scene)));
}

}  // namespace

Colour evaluate(const Pigment& pigment, const Vec3& point, const PatternScene& scene) {
    if (!pigment.pattern) return pigment.colour;
    return colour_at(*pigment.pattern, own_place(pigment, point, scene), scene);
}

PatternedPigment::PatternedPigment(PatternUse the_use, Map the_map)
    : use(std::move(the_use)), map(std::move(the_map)) {
    brightest = Rgb(-std::numeric_limits<double>::infinity());
    nesting = candelabra::nesting(use);
    const auto add = [&](const Rgb& greatest, bool passes, const Nesting& inner) {
        brightest = max(brightest, greatest);
        clear |= passes;
        nesting.add(inner);
    };
    if (const auto* image = std::get_if<ImageMap>(&use.pattern)) {
        brightest = greatest(*image);
        clear = passes_light(*image);
    } else if (const auto* colours = std::get_if<ColourMap>(&map))
        for (const ColourStop& stop : *colours) add(stop.colour.rgb, passes_light(stop.colour), {});
    else
        for (const PigmentStop& stop : std::get<PigmentMap>(map))
            add(candelabra::brightest(stop.pigment), transparent(stop.pigment),
                candelabra::nesting(stop.pigment));
}

Nesting nesting(const Pigment& pigment) {
    if (!pigment.pattern) return {};
    Nesting result = pigment.pattern->nesting;
    result.uv |= pigment.uv;
    return result;
}

Rgb brightest(const Pigment& pigment) {
    return pigment.pattern ? pigment.pattern->brightest : pigment.colour.rgb;
}

bool transparent(const Pigment& pigment) {
    return pigment.pattern ? pigment.pattern->clear : passes_light(pigment.colour);
}

PigmentGrey grey_of(Pigment pigment) {
    const Nesting inner = nesting(pigment);
    const auto code = [](const void* data, const Vec3& point, const PatternScene& scene) {
        const auto& inner = *static_cast<const Pigment*>(data);
        return misses(inner, point, scene) ? 0 : grey(evaluate(inner, point, scene).rgb);
    };
    return {{std::make_shared<const Pigment>(std::move(pigment)), code}, inner};
}

}  // namespace candelabra

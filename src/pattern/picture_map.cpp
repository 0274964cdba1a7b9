// SPDX-License-Identifier: GPL-3.0-or-later
#include "pattern/picture_map.h"

#include "base/elementary.h"
#include "base/revolution.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <numbers>

namespace candelabra {

namespace {

/// Returns the vocabulary of one of the four kinds: the common fields, then its own.
template <class T, class... Own>
consteval auto picture_schema(std::string_view name, ItemText text, Own... own) {
    using F = Field<T>;
    return schema<T>(
        name, text,
        maybe(F{"function", &T::function, positional,
                "`function width, height { ... }` of x and y from 0 to 1, instead of a file"}),
        maybe(F{"file", &T::file, positional, "name of a picture; its kind may come before it"}),
        F{"picture", &T::picture, item,
          "of a model in the place of the file: the number of its picture, from 0", at_least(0)},
        F{"gamma", &T::gamma, item,
          "of the file's values, in place of its own; or `srgb`, `bt709`, `bt2020`"},
        F{"premultiplied", &T::premultiplied, flag, "the file's colours are stored times alpha"},
        F{"map_type", &T::map_type, item,
          "0: on the plane of x and y, 1: around a sphere, 2: around a cylinder, 5: around a ring, "
          "7: an angular probe",
          between(0, 7)},
        F{"interpolate", &T::interpolate, item,
          "0: pixels are squares, 2: bilinear, 3: bicubic, 4: by distance", between(0, 4)},
        F{"once", &T::once, flag, "the picture is not repeated"},
        F{"repeat", &T::repeat, item, "how often it is there in each square of size 1"},
        F{"offset", &T::offset, item, "by how much it is moved, in pictures"},
        F{"use_color", &T::use_color, flag, "accepted: colours are used anyway"},
        F{"use_colour", &T::use_color, flag, "another spelling of use_color"},
        F{"use_index", &T::use_index, flag, "heights are the numbers of the file's colours"},
        F{"use_alpha", &T::use_alpha, flag, "values are the transparency"}, own...);
}

}  // namespace

const ItemInfo ImageMap::vocabulary = described<ImageMap>([] {
    using F = Field<ImageMap>;
    return picture_schema<ImageMap>(
        "image_map",
        {"The colours of a picture, in braces. `filter all n` and "
         "`transmit all n` make it clear, `filter i, n` and "
         "`transmit i, n` one colour of the file's table.",
         "pigment { image_map { png \"test.png\" interpolate 2 } translate -0.5 scale <3, 2, 1> }",
         "pigment { image_map { png \"test.png\" map_type 1 gamma 1.0 transmit all 0.3 } }",
         "pigment { image_map { png \"test.png\" once offset <0.2, 0.1> premultiplied off } }",
         "pigment { image_map { png \"test.png\" tint rgb <1, 0.6, 0.3> alpha_cutoff 0.5 } }",
         "pigment { image_map { \"gems.gltf\" picture 0 } }"},
        F{"tint", &ImageMap::tint, item, "all colours are multiplied by it"},
        F{"alpha_cutoff", &ImageMap::alpha_cutoff, item,
          "the picture is clear where its alpha is below this, and opaque elsewhere", at_least(0)});
});

const ItemInfo ImagePattern::vocabulary = described<ImagePattern>([] {
    return picture_schema<ImagePattern>(
        "image_pattern",
        {"The brightness of a picture, in braces.",
         "pigment { image_pattern { png \"fract003.png\" } translate -0.5 scale <3, 2, 1> "
         "color_map { [0 rgb <0.1, 0.3, 0.7>] [0.4 rgb <0.2, 0.6, 0.2>] [1 rgb 1] } }",
         "pigment { image_pattern { png \"fract003.png\" use_color repeat <2, 2> } }",
         "pigment { image_pattern { png \"test.png\" use_alpha } }",
         "pigment { image_pattern { png \"fract003.png\" use_colour } }"});
});

const ItemInfo BumpMap::vocabulary = described<BumpMap>([] {
    return picture_schema<BumpMap>(
        "bump_map",
        {"Bumps as high as a picture is bright, in braces; for normals only.",
         "normal { bump_map { png \"bumpmap_.png\" bump_size 4 } translate -0.5 scale 2 }",
         "normal { uv_mapping bump_map { function 16, 16 { 0.5 + 0.2*sin(4*pi*(x + y)) } "
         "tangent_space interpolate 2 } scale 0.2 }"},
        Field<BumpMap>{"bump_size", &BumpMap::bump_size, item, "height of the bumps"},
        Field<BumpMap>{
            "tangent_space", &BumpMap::tangent_space, flag,
            "the colours are normals, as in glTF: red to the right of the picture, "
            "green upwards, blue outwards; bump_size multiplies the slope, and is 1 if left out"});
});

const ItemInfo MaterialMap::vocabulary = described<MaterialMap>([] {
    return picture_schema<MaterialMap>(
        "material_map", {"Textures by the numbers of a picture's colours, or by their red from 0 "
                         "to 255, in braces; "
                         "for textures only.",
                         "texture { material_map { png \"test.png\" use_index texture { pigment { "
                         "rgb 1 } } texture { pigment { rgb <0.9, 0.4, 0.2> } } } }"});
});

namespace {

using std::numbers::pi;

constexpr double tiny = 1e-10;

/// Components of a texel in the form in which they are interpolated: red, green, blue, transmit,
/// and filter.
struct Mixture {
    Vec4 rgbt = Vec4(0);
    double filter = 0;

    Mixture operator*(double weight) const { return {weight * rgbt, weight * filter}; }
    Mixture& operator+=(const Mixture& other) {
        rgbt += other.rgbt;
        filter += other.filter;
        return *this;
    }
    Colour colour() const { return {Rgb(rgbt.x, rgbt.y, rgbt.z), filter, rgbt.w}; }
};

Mixture texel(const Texels& texels, int x, int y) {
    const std::size_t at = texels.at(x, y);
    if (!texels.numbers.empty()) {
        const Colour& c = texels.table[texels.numbers[at]];
        return {Vec4(c.rgb.r, c.rgb.g, c.rgb.b, c.transmit), c.filter};
    }
    const double transmit = texels.alpha.empty() ? 0 : 1 - double{texels.alpha[at]};
    if (texels.channels == 1) {
        const double grey = texels.values[at];
        return {Vec4(grey, grey, grey, transmit), 0};
    }
    const float* const v = &texels.values[3 * at];
    return {Vec4(v[0], v[1], v[2], transmit), 0};
}

double floor_mod(double x, double m) {
    const double rest = x - m * std::floor(x / m);
    return rest >= m || !(rest >= 0) ? 0 : rest;
}

/// The place of a direction in a picture of a mirrored ball, in which equal angles to z are equal
/// lengths from its middle.
Vec2 probed(const Vec3& towards, const Vec2& size) {
    const double aside = math::hypot(towards.x, towards.y);
    const double scale =
        aside > 0 ? math::acos(std::clamp(towards.z, -1.0, 1.0)) / (pi * aside) : 0;
    return {size.x * (0.5 + 0.5 * scale * towards.x), size.y * (0.5 + 0.5 * scale * towards.y)};
}

/// Maps a point to the picture, in pixels, before offset and repetition; y points up.
std::optional<Vec2> unrolled(const PictureMap& map, const Vec3& p, const Vec2& size) {
    const bool off_plane = map.once && (p.x < 0 || p.x > 1),
               off_height = map.once && (p.y < 0 || p.y > 1);
    const double around = p.x == 0 && p.z == 0 ? 0 : turn(p.x, p.z);
    const double from_axis = math::hypot(p.x, p.z), distance = length(p);
    const Vec2 flat(std::fmod(p.x * size.x, size.x), std::fmod(p.y * size.y, size.y));
    switch (map.map_type) {
        case 0:
            if (off_plane || off_height) return std::nullopt;
            return flat;
        case 1:
            if (distance == 0) return std::nullopt;
            return Vec2(size.x * around, size.y * (0.5 + math::asin(p.y / distance) / pi));
        case 2:
            if (off_height || from_axis == 0) return std::nullopt;
            return Vec2(size.x * around, flat.y);
        case 7:
            if (distance == 0) return std::nullopt;
            return probed(p / distance, size);
        default:
            if (from_axis == 0) return std::nullopt;
            return Vec2(size.x * around, size.y * turn_of_tube(from_axis - 1, p.y));
    }
}

/// Returns the position on the picture, in pixels from its upper left corner; nothing where the
/// point misses it.
std::optional<Vec2> place_on(const PictureMap& map, const Vec3& point) {
    if (!map.texels) return std::nullopt;
    const Vec2 size(map.texels->width, map.texels->height);
    std::optional<Vec2> at = unrolled(map, point, map.repeat * size);
    if (!at || !std::isfinite(at->x) || !std::isfinite(at->y)) return std::nullopt;
    *at += Vec2(tiny) - map.offset * size;
    if (map.once && (at->x < 0 || at->x >= size.x || at->y < 0 || at->y >= size.y))
        return std::nullopt;
    return Vec2(floor_mod(at->x, size.x), floor_mod(-at->y, size.y));
}

/// Wraps or clamps the index of a pixel that may be outside the picture.
int within(const PictureMap& map, int i, int count) {
    if (map.once) return std::clamp(i, 0, count - 1);
    return i < 0 ? (i % count + count) % count : i % count;
}

std::array<double, 4> cubic_weights(double p) {
    const double q = 1 - p;
    return {-p * q * q / 2, q / 2 * (q * (3 * p + 1) + 1), p / 2 * (p * (3 * q + 1) + 1),
            -q * p * p / 2};
}

std::array<double, 4> weights_of(int interpolate, double p, double q) {
    if (interpolate != 4) return {p * q, (1 - p) * q, p * (1 - q), (1 - p) * (1 - q)};
    const auto near = [](double x, double y) { return 1 / std::fmax(x * x + y * y, 1e-300); };
    std::array<double, 4> result = {near(1 - p, 1 - q), near(p, 1 - q), near(1 - p, q), near(p, q)};
    const double sum = result[0] + result[1] + result[2] + result[3];
    for (double& weight : result) weight /= sum;
    return result;
}

/// Interpolates fetch(x, y) at a place by the map's method.
template <class Fetch>
auto mixed_at(const PictureMap& map, const Vec2& place, Fetch fetch) {
    const int width = map.texels->width, height = map.texels->height;
    const auto at = [&](int x, int y) {
        return fetch(within(map, x, width), within(map, y, height));
    };
    if (map.interpolate < 2) return at(static_cast<int>(place.x), static_cast<int>(place.y));
    const double x = place.x + 0.5, y = place.y + 0.5;
    const int i = static_cast<int>(x), j = static_cast<int>(y);
    decltype(at(0, 0)) sum{};
    if (map.interpolate == 3) {
        const auto across = cubic_weights(x - i), down = cubic_weights(y - j);
        for (std::size_t row = 0; row < 4; ++row)
            for (std::size_t column = 0; column < 4; ++column)
                sum += at(i - 2 + static_cast<int>(column), j - 2 + static_cast<int>(row)) *
                       (across[column] * down[row]);
        return sum;
    }
    const auto weights = weights_of(map.interpolate, x - i, y - j);
    for (std::size_t k = 0; k < 4; ++k)
        sum += at(i - static_cast<int>(k % 2), j - static_cast<int>(k / 2)) * weights[k];
    return sum;
}

/// Multiplies the colour of a texel by its alpha, or by the reciprocal to undo that.
Mixture times_alpha(Mixture m, double alpha) {
    return {Vec4(m.rgbt.x * alpha, m.rgbt.y * alpha, m.rgbt.z * alpha, m.rgbt.w), m.filter};
}

Colour sampled(const PictureMap& map, const Vec2& place) {
    const auto at = [&](int x, int y) { return texel(*map.texels, x, y); };
    if (!map.premultiplied || map.interpolate < 2) return mixed_at(map, place, at).colour();
    // Interpolate the colours as they are stored.
    const Mixture mixed = mixed_at(map, place, [&](int x, int y) {
        const Mixture m = at(x, y);
        const double own = 1 - m.rgbt.w;
        return times_alpha(m, own > 0 ? own : 1);
    });
    const double alpha = 1 - mixed.rgbt.w;
    return (alpha == 0 ? mixed : times_alpha(mixed, 1 / alpha)).colour();
}

double grey_at(const PictureMap& map, const Vec3& point) {
    const auto place = place_on(map, point);
    return place ? std::clamp(grey(sampled(map, *place).rgb), 0.0, 1.0) : 0;
}

/// Returns the index of a colour in the file's table. As in POV-Ray, indices are interpolated like
/// colours. Returns nothing if the file has no table, or for an interpolated index of -1, which
/// POV-Ray treats likewise.
std::optional<int> number_at(const PictureMap& map, const Vec2& place) {
    const Texels& texels = *map.texels;
    if (texels.numbers.empty()) return std::nullopt;
    const int number = static_cast<int>(mixed_at(map, place, [&](int x, int y) {
        return static_cast<double>(texels.numbers[texels.at(x, y)]);
    }));
    return number == -1 ? std::nullopt : std::optional(number);
}

/// Returns the number of a texture. Red is interpolated before its conversion to a number, in
/// single precision as in POV-Ray.
int texture_number_at(const PictureMap& map, const Vec2& place) {
    if (const auto number = number_at(map, place)) return *number;
    const auto red = static_cast<float>(sampled(map, place).rgb.r);
    constexpr float last = 65535;
    return static_cast<int>(std::fmin(std::fmax(red * 255.0F, 0.0F), last));
}

/// Returns the heights at three places: colour indices if they are requested and available at all
/// of them, otherwise brightnesses.
std::array<double, 3> heights_at(const BumpMap& map, const std::array<Vec2, 3>& places) {
    std::array<double, 3> heights{};
    bool numbered = map.use_index;
    for (std::size_t i = 0; numbered && i < places.size(); ++i) {
        const auto number = number_at(map, places[i]);
        numbered = number.has_value();
        heights[i] = number.value_or(0);
    }
    for (std::size_t i = 0; !numbered && i < places.size(); ++i)
        heights[i] = grey(sampled(map, places[i]).rgb);
    return heights;
}

}  // namespace

namespace {

/// Multiplies the colours, and sets alpha to 0 or 1 if there is a cutoff.
void change(Texels& made, const Rgb& tint, const std::optional<double>& cutoff) {
    const auto is_there = [&](double opacity) { return opacity >= *cutoff; };
    if (cutoff && *cutoff <= 0) made.alpha.clear();
    if (cutoff)
        for (float& alpha : made.alpha) alpha = is_there(alpha) ? 1.0F : 0.0F;
    for (Colour& colour : made.table) {
        colour.rgb *= tint;
        if (cutoff) colour.transmit = is_there(1 - colour.transmit) ? 0 : 1;
    }
    const bool grey = tint.r == tint.g && tint.g == tint.b;
    if (made.channels == 1 && !grey) {
        std::vector<float> coloured;
        coloured.reserve(3 * made.values.size());
        for (const float value : made.values) coloured.insert(coloured.end(), 3, value);
        made.values = std::move(coloured);
        made.channels = 3;
    }
    const auto channels = static_cast<std::size_t>(made.channels);
    for (std::size_t i = 0; i < made.values.size(); ++i) {
        const auto channel = static_cast<int>(i % channels);
        made.values[i] = static_cast<float>(made.values[i] * tint[channel]);
    }
    made.greatest = Rgb(0);
    made.measure();
}

}  // namespace

void ImageMap::adjust() {
    if (tint != Rgb(1) || alpha_cutoff) change(texels.edit(), tint, alpha_cutoff);
    for (const Adjustment& each : adjustments) {
        if (each.number < 0) (each.filter ? filter : transmit) = each.amount;
        if (texels->table.empty()) continue;
        std::vector<Colour>& table = texels.edit().table;
        for (std::size_t i = 0; i < table.size(); ++i)
            if (each.number < 0 || static_cast<std::size_t>(each.number) == i)
                (each.filter ? table[i].filter : table[i].transmit) = each.amount;
    }
    if (!texels->table.empty()) filter = transmit = 0;
}

std::optional<Colour> colour_at(const ImageMap& map, const Vec3& point) {
    const auto place = place_on(map, point);
    if (!place) return std::nullopt;
    Colour colour = sampled(map, *place);
    colour.filter += map.filter;
    colour.transmit += map.transmit;
    return colour;
}

std::optional<Vec3> bump_at(const BumpMap& map, const Vec3& point, double height) {
    const auto place = place_on(map, point);
    if (!place) return std::nullopt;
    const Vec2 size(map.texels->width, map.texels->height);
    const auto moved = [&](double x, double y) {
        return Vec2(floor_mod(place->x + x, size.x), floor_mod(place->y + y, size.y));
    };
    const auto heights = heights_at(map, {moved(0, 0), moved(-1, 1), moved(1, 1)});
    const Vec3 here(0, height * heights[0], 0), left(-1, height * heights[1], 1),
        right(1, height * heights[2], 1);
    return unit(cross(right - left, here - left));
}

std::optional<Vec3> direction_at(const BumpMap& map, const Vec3& point) {
    const auto place = place_on(map, point);
    if (!place) return std::nullopt;
    return 2.0 * vec3_of(sampled(map, *place).rgb) - Vec3(1);
}

double evaluate(const ImageMap& map, const Vec3& point) { return grey_at(map, point); }

double evaluate(const ImagePattern& map, const Vec3& point) {
    if (!map.use_alpha) return grey_at(map, point);
    const auto place = place_on(map, point);
    if (!place) return 0;
    const Colour colour = sampled(map, *place);
    const bool clear = map.texels->transparent() || !map.texels->numbers.empty();
    return std::clamp(clear ? colour.transmit : colour.rgb.r, 0.0, 1.0);
}

double evaluate(const BumpMap& map, const Vec3& point) { return grey_at(map, point); }

double evaluate(const MaterialMap& map, const Vec3& point) {
    const auto place = place_on(map, point);
    if (!place) return 0;
    const int number = texture_number_at(map, *place);
    if (number == map.textures) return map.textures - 1;
    return number > map.textures ? number % map.textures : number;
}

}  // namespace candelabra

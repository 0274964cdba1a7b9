// SPDX-License-Identifier: GPL-3.0-or-later
#include "camera/film_settings.h"

#include "base/elementary.h"
#include "text/ascii.h"
#include "text/decimal.h"
#include "text/message.h"
#include "text/printable.h"
#include "vocabulary/manual.h"
#include "vocabulary/schema.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

constexpr auto responses = std::to_array<std::string_view>({"linear", "filmic", "agx"});
constexpr auto filters =
    std::to_array<std::string_view>({"box", "triangle", "mitchell", "blackman_harris"});

constexpr std::string_view glare_prefix = "glare.";

/// The enumerator with this name, or the first one if there is none.
template <class Enum>
Enum named(std::string_view name, std::span<const std::string_view> names) {
    const auto found = std::ranges::find(names, name);
    return found == names.end() ? Enum{} : static_cast<Enum>(found - names.begin());
}

bool among(std::string_view name, std::span<const std::string_view> names) {
    return std::ranges::find(names, name) != names.end();
}

std::string list_of(std::span<const std::string_view> names) {
    std::string text;
    for (const std::string_view name : names)
        text += message(text.empty() ? "" : name == names.back() ? " or " : ", ", '`', name, '`');
    return text;
}

std::string not_among(std::string_view noun, std::string_view name,
                      std::span<const std::string_view> names) {
    return message("there is no ", noun, " `", printable(std::string(name)), "`, but ",
                   list_of(names));
}

std::string_view without_plus(std::string_view number) {
    return number.substr(number.starts_with('+') ? 1 : 0);
}

/// Sets the field to a number or a name; returns an error as a sentence.
std::string set_field(const ItemInfo& info, void* item, std::size_t index,
                      const FilmChange& change) {
    const FieldInfo& field = info.fields[index];
    if (field.type == FieldType::text) {
        info.set(item, index, change.value);
        return {};
    }
    const std::optional<double> value = change.value == "on"    ? 1
                                        : change.value == "off" ? 0
                                                                : finite_number(change.value);
    const bool whole = field.type == FieldType::integer;
    if (!value || !field.range.contains(*value) ||
        (whole && (*value != std::trunc(*value) || std::abs(*value) > 0x1p30)))
        return message(change.name, " must be a ", takes(field));
    info.set(item, index, *value);
    return {};
}

std::string set_named(const ItemInfo& info, void* item, std::string_view name,
                      const FilmChange& change) {
    const auto found = std::ranges::find(info.fields, name, &FieldInfo::name);
    if (found == info.fields.end()) return message("a film has no `", printable(change.name), "`");
    return set_field(info, item, static_cast<std::size_t>(found - info.fields.begin()), change);
}

std::string value_text(const FieldValue& value) {
    if (const auto* text = std::get_if<std::string>(&value)) return *text;
    return message(std::get<double>(value));
}

void add_changed(std::string& text, const ItemInfo& info, const void* item,
                 std::string_view prefix) {
    for (std::size_t i = 0; i < info.fields.size(); ++i) {
        const FieldValue value = info.get(item, i);
        if (value == info.default_value(i)) continue;
        text += message(' ', prefix, info.fields[i].name, '=', value_text(value));
    }
}

}  // namespace

const ItemInfo Glare::vocabulary = described<Glare>([] {
    using F = Field<Glare>;
    return schema<Glare>(
        "glare",
        {"Light that lenses and eyes scatter: shares of all light, which is kept. What a share "
         "does was measured in eyes.",
         "film { exposure auto response agx glare { } }",
         "film { exposure auto response agx glare { veil 0.4 halo 0.03 star 0 } }",
         "film { exposure auto response agx glare { veil 0.1 halo 0 star 0.12 blades 6 angle 10 } "
         "}",
         "film { exposure auto response agx glare { star 0.2 length 0.3 field 40 } }"},
        F{"veil", &Glare::veil, item,
          "share that is scattered around each light; 0.62 in an eye by day", between(0, 1)},
        F{"halo", &Glare::halo, item,
          "share in a coloured ring of three degrees around each light; 0.033 in an eye by night",
          between(0, 1)},
        F{"star", &Glare::star, item, "share in rays by the edges of the aperture", between(0, 1)},
        F{"blades", &Glare::blades, item,
          "edges of the aperture: an even number makes as many rays, an odd one twice as many; 0: "
          "it is round and makes none",
          between(0, 64)},
        F{"angle", &Glare::angle, item, "degrees by which the aperture is turned"},
        F{"length", &Glare::length, item,
          "degrees from a light at which a ray has half its brightness", above(0)},
        F{"field", &Glare::field, item,
          "degrees from the left edge of the picture to the right; 0: as the camera sees it",
          between(0, 170)});
});

const ItemInfo FilmSettings::vocabulary = described<FilmSettings>([] {
    using F = Field<FilmSettings>;
    return schema<FilmSettings>(
        "film",
        {"What is made of the light that the camera gathers, in pictures that people look at. "
         "OpenEXR and Radiance HDR files keep the light as it is.",
         "film { exposure 2 }", "film { exposure auto }", "film { exposure auto key 0.06 }",
         "film { exposure auto response filmic }", "film { exposure auto response agx }",
         "film { exposure auto response agx contrast 1.3 }",
         "film { exposure auto response agx saturation 0.4 }",
         "film { exposure auto response agx white_balance 3400 }",
         "film { exposure auto response agx white_balance 9000 }",
         "film { exposure auto response agx vignette 0.8 }",
         "film { exposure auto response agx grain 0.08 grain_seed 2 }",
         "film { pixel_filter mitchell smooth_edges }", "film { auto_exposure exposure 1.5 }"},
        F{"exposure", &FilmSettings::exposure, item,
          "stops, each of which doubles the light; `exposure auto` is `auto_exposure`",
          between(-40, 40)},
        F{"auto_exposure", &FilmSettings::auto_exposure, flag,
          "exposure from the picture's own luminance, to which `exposure` is added"},
        F{"key", &FilmSettings::key, item,
          "luminance that `auto_exposure` gives to the whole picture: 0.18 is a middle grey, 0.09 "
          "a stop darker, for nights; 0.36 a stop brighter, for white rooms",
          between(0.001, 0.9)},
        F{"white_balance", &FilmSettings::white_balance, item,
          "kelvins: light of a black body so hot becomes white (1000 to 15000); 0: colours stay "
          "what they are",
          between(0, 15000)},
        F{"response", &FilmSettings::response, item,
          "what becomes of bright light: `linear` (clipped at 1), `filmic` (a shoulder for each "
          "channel), or `agx` (highlights lose their colour)"},
        F{"contrast", &FilmSettings::contrast, item,
          "exponent of the light around a grey of 0.18, before the response: 1.2 is lively, 0.8 "
          "soft",
          between(0.1, 5)},
        F{"saturation", &FilmSettings::saturation, item,
          "factor on the distance of each colour from its grey, after the response; 0: black and "
          "white",
          between(0, 4)},
        F{"pixel_filter", &FilmSettings::pixel_filter, item,
          "how samples count in a pixel: `box`, `triangle`, `mitchell` or `blackman_harris`"},
        F{"smooth_edges", &FilmSettings::smooth_edges, flag,
          "samples are compressed before they are averaged, so that edges of lamps are smooth; a "
          "linear response stays exact without"},
        F{"vignette", &FilmSettings::vignette, item, "share of the light that corners lose",
          between(0, 1)},
        F{"grain", &FilmSettings::grain, item,
          "size of the grains against a pixel: 0.05 is seen, 0 is none", between(0, 1)},
        F{"grain_seed", &FilmSettings::grain_seed, item,
          "seed of the grain's pattern; each frame of an animation has a pattern of its own",
          at_least(0)});
});

std::span<const std::string_view> response_names() { return responses; }
std::span<const std::string_view> filter_names() { return filters; }

ResponseCurve FilmSettings::curve() const { return named<ResponseCurve>(response, responses); }
FilterShape FilmSettings::filter() const {
    return on ? named<FilterShape>(pixel_filter, filters) : FilterShape::box;
}
bool FilmSettings::smooths_edges() const {
    return on && smooth_edges && curve() != ResponseCurve::linear;
}
double FilmSettings::exposure_factor() const { return on ? math::exp2(exposure) : 1; }

std::string problem(const FilmSettings& film) {
    if (!among(film.response, responses))
        return not_among("response of a film", film.response, responses);
    if (!among(film.pixel_filter, filters))
        return not_among("pixel filter", film.pixel_filter, filters);
    if (film.white_balance > 0 && film.white_balance < 1000)
        return "a white balance is between 1000 and 15000 kelvins, or 0 for none";
    if (film.glares && film.glare.share() > 1)
        return "the shares of `glare` are more than all light together";
    return {};
}

std::string change(FilmSettings& film, const FilmChange& wanted) {
    if (wanted.name == "film" || wanted.name == "glare") {
        if (wanted.value != "on" && wanted.value != "off")
            return message(wanted.name, " must be `on` or `off`");
        const bool on = wanted.value == "on";
        (wanted.name == "film" ? film.on : film.glares) = on;
        film.on |= on;
        return {};
    }
    FilmSettings changed = film;
    changed.on = true;
    std::string wrong;
    if (wanted.name.starts_with(glare_prefix)) {
        changed.glares = true;
        wrong = set_named(Glare::vocabulary, &changed.glare,
                          std::string_view(wanted.name).substr(glare_prefix.size()), wanted);
    } else if (wanted.name == "exposure" && wanted.value.starts_with("auto")) {
        const std::string_view more = std::string_view(wanted.value).substr(4);
        changed.auto_exposure = true;
        const FilmChange stops{wanted.name, more.empty() ? "0" : std::string(without_plus(more))};
        wrong = set_named(FilmSettings::vocabulary, &changed, wanted.name, stops);
    } else {
        if (wanted.name == "exposure") changed.auto_exposure = false;
        wrong = set_named(FilmSettings::vocabulary, &changed, wanted.name, wanted);
    }
    if (wrong.empty()) wrong = problem(changed);
    if (wrong.empty()) film = changed;
    return wrong;
}

std::string to_text(const FilmSettings& film) {
    if (!film.on) return {};
    std::string text = "film=on";
    // Fields are ordered with exposure before auto_exposure, which a number would turn off.
    add_changed(text, FilmSettings::vocabulary, &film, "");
    if (!film.glares) return text;
    text += " glare=on";
    add_changed(text, Glare::vocabulary, &film.glare, glare_prefix);
    return text;
}

std::optional<FilmSettings> film_from_text(std::string_view text) {
    FilmSettings film;
    while (!text.empty()) {
        const std::string_view one = take_until(text, " ");
        const std::size_t sign = one.find('=');
        if (sign == one.npos) return std::nullopt;
        const FilmChange setting{std::string(one.substr(0, sign)),
                                 std::string(one.substr(sign + 1))};
        if (!change(film, setting).empty()) return std::nullopt;
    }
    return film;
}

}  // namespace candelabra

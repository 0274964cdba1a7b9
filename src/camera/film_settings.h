// SPDX-License-Identifier: GPL-3.0-or-later
// Settings of the camera's film: how the light that falls on it is exposed and developed, and its
// glare. The rendered picture is not changed; film/develop.h makes files for viewing from it. Set
// in `camera { film { ... } }` and on the command line.
#pragma once

#include "vocabulary/item_info.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// How exposures, from zero to more than the film can hold, are mapped to the picture.
enum class ResponseCurve { linear, filmic, agx };

/// How the samples around a pixel are weighted.
enum class FilterShape { box, triangle, mitchell, blackman_harris };

/// Fractions of all light that are scattered.
struct Glare {
    double veil = 0.15;   ///< scattered around each light, as in the eye
    double halo = 0.01;   ///< in the ring caused by the lens of the eye
    double star = 0.02;   ///< in the rays caused by the edges of an aperture
    int blades = 6;       ///< edges of the aperture; below 3: round
    double angle = 0;     ///< rotation of the aperture, in degrees
    double length = 0.4;  ///< degrees from a light at which a ray has half its brightness
    double field = 0;     ///< horizontal field of view of the picture, in degrees; 0: unknown

    /// Total fraction of the light that is scattered.
    double share() const { return veil + halo + star; }

    static const ItemInfo vocabulary;
};

struct FilmSettings {
    bool on = false;             ///< false: no film; the picture is clipped and encoded
    double exposure = 0;         ///< in stops, each of which doubles the light
    bool auto_exposure = false;  ///< measured from the picture, plus `exposure` stops
    double key = 0.18;           ///< luminance that an automatic exposure gives to the whole
    double white_balance = 0;    ///< colour temperature of light that looks white, in K; 0: off
    std::string response = "linear";   ///< a name of ResponseCurve
    double contrast = 1;               ///< exponent of light around a grey of 0.18
    double saturation = 1;             ///< distance of displayed colours from their grey
    std::string pixel_filter = "box";  ///< a name of FilterShape
    bool smooth_edges = true;          ///< see smooths_edges()
    double vignette = 0;               ///< fraction of the light that corners lose
    double grain = 0;                  ///< size of a grain relative to a pixel
    int grain_seed = 0;
    bool glares = false;
    Glare glare = {};

    static const ItemInfo vocabulary;

    ResponseCurve curve() const;
    FilterShape filter() const;
    /// Whether samples are compressed before they are averaged, so that the edges of lamps are
    /// smooth. A linear response stays exact.
    bool smooths_edges() const;
    /// Factor of light in noise estimates. An automatic exposure is not known when they are made.
    double exposure_factor() const;
};

/// Error in the film as a whole, as a sentence; empty when there is none.
std::string problem(const FilmSettings&);

/// Names of the response curves and filters, in the order of the enumerators.
std::span<const std::string_view> response_names();
std::span<const std::string_view> filter_names();

/// The name of a setting and its value as text; a field of the glare is called `glare.veil`.
struct FilmChange {
    std::string name, value;
    friend bool operator==(const FilmChange&, const FilmChange&) = default;
};

/// Changes one setting. Returns an error as a sentence, or an empty string. A change of any setting
/// turns the film on; `film` itself is `on` or `off`. `exposure` may be `auto`, or `auto+1` with
/// stops to add; a number alone turns automatic exposure off. `glare` is `on` or `off`.
std::string change(FilmSettings&, const FilmChange&);

/// All settings that differ from their defaults, as name=value separated by blanks. Empty: no film.
std::string to_text(const FilmSettings&);
/// Inverse of to_text(); empty for a text that it cannot return.
std::optional<FilmSettings> film_from_text(std::string_view);

}  // namespace candelabra

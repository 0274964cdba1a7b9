// SPDX-License-Identifier: GPL-3.0-or-later
// What the camera's film does with the light that falls on it: how it is exposed and developed, and
// what glares. The picture that is rendered stays as it is; files that people look at are made of
// it by film/develop.h. Set in `camera { film { ... } }` and on the command line.
#pragma once

#include "vocabulary/item_info.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// What becomes of an exposure, from none to more than the film can hold.
enum class ResponseCurve { linear, filmic, agx };

/// How the samples around a pixel count in it.
enum class FilterShape { box, triangle, mitchell, blackman_harris };

/// Shares of all light that do not stay where they belong.
struct Glare {
    double veil = 0.15;   ///< scattered around each light, as in the eye
    double halo = 0.01;   ///< in the ring that the lens of the eye makes
    double star = 0.02;   ///< in the rays that the edges of an aperture make
    int blades = 6;       ///< of the aperture, which have one edge each; below 3: it is round
    double angle = 0;     ///< by which the aperture is turned, in degrees
    double length = 0.4;  ///< degrees from a light at which a ray has half its brightness
    double field = 0;     ///< degrees from the left edge of the picture to the right; 0: unknown

    /// Of the light, altogether.
    double share() const { return veil + halo + star; }

    static const ItemInfo vocabulary;
};

struct FilmSettings {
    bool on = false;             ///< false: no film; the picture is clipped and encoded
    double exposure = 0;         ///< in stops: doublings of the light
    bool auto_exposure = false;  ///< in stops that the picture itself asks for, and those
    double white_balance = 0;    ///< kelvins of a light that looks white; 0: values are as they are
    std::string response = "linear";   ///< a name of ResponseCurve
    std::string pixel_filter = "box";  ///< a name of FilterShape
    bool smooth_edges = true;          ///< see smooths_edges()
    double vignette = 0;               ///< share of the light that corners lose
    double grain = 0;                  ///< size of a grain against a pixel
    int grain_seed = 0;
    bool glares = false;
    Glare glare = {};

    static const ItemInfo vocabulary;

    ResponseCurve curve() const;
    FilterShape filter() const;
    /// Whether samples are compressed before they are averaged, so that edges of lamps are smooth.
    /// A linear response stays exact.
    bool smooths_edges() const;
    /// By which light counts in measures of noise. What an automatic exposure will be is not known
    /// when they are made.
    double exposure_factor() const;
};

/// What is wrong with the film as a whole, as a sentence; empty when nothing is.
std::string problem(const FilmSettings&);

/// Names of the response curves and filters, in the order of the enumerators.
std::span<const std::string_view> response_names();
std::span<const std::string_view> filter_names();

/// One setting by its name, and its value as a text; a field of the glare is called `glare.veil`.
struct FilmChange {
    std::string name, value;
    friend bool operator==(const FilmChange&, const FilmChange&) = default;
};

/// Changes one setting; an error as a sentence, empty when there is none. A change of any setting
/// puts a film in; `film` itself is `on` or `off`. `exposure` may be `auto`, or `auto+1` with stops
/// that are added, and a number alone is no automatic exposure any more. `glare` is `on` or `off`.
std::string change(FilmSettings&, const FilmChange&);

/// All settings that are not what they are without being said, in the form name=value with blanks
/// between. Empty: no film.
std::string to_text(const FilmSettings&);
/// The inverse; nothing for a text that no film gives.
std::optional<FilmSettings> film_from_text(std::string_view);

}  // namespace candelabra

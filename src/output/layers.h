// SPDX-License-Identifier: GPL-3.0-or-later
// The output files of a film: the picture, and named layers beside its colours in an OpenEXR file.
// Called when a picture is finished, and by merge.
#pragma once

#include "camera/film_settings.h"
#include "options/picture_layers.h"
#include "picture/write.h"
#include "transport/aovs.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

class Film;
struct LayeredPicture;
struct Negative;
class SourceStore;
class World;

/// Outputs made from a film besides its layers.
struct Extras {
    bool smooth = false;   ///< compressed samples for a response that needs smooth edges
    bool denoise = false;  ///< a denoised picture
};

/// Returns the sums that the film must gather for these layers.
Aovs aovs_for(std::span<const PictureLayer>, bool alpha, const Extras& = {});

/// Returns a name for each of Provenance::light_statements: the declared name or the macro in the
/// statement, or else its first word. Equal names are numbered.
std::vector<std::string> light_names(const World&, const SourceStore&);

struct FilmFiles {
    std::string path;  ///< of the picture
    PictureFormat format;
    bool alpha = false;
    std::vector<PictureLayer> layers = {};
    std::vector<std::string> lights = {};  ///< names of statements, if there are layers of light
    FilmSettings film = {};                ///< develops pictures for display
    bool denoise = false;                  ///< also makes a denoised picture
    bool draft = false;                    ///< the picture itself is denoised, instead
    int threads = 1;                       ///< for developing pictures

    /// Returns the sums that the film must gather.
    Aovs aovs() const;
};

/// Names of the denoised layer, of the layer of compressed samples, and of the text attribute with
/// the film's settings in OpenEXR files.
inline constexpr std::string_view denoised_layer = "denoised";
inline constexpr std::string_view smooth_layer = "film";
inline constexpr std::string_view film_text_name = "candelabraFilm";

/// Returns the path of the layers: the picture itself if it is an OpenEXR file, otherwise
/// "a.layers.exr" beside "a.png". Empty if there are none.
std::string layers_path(const FilmFiles&);

/// Returns the path of the denoised picture if it is no layer of the picture: "a.denoised.png"
/// beside "a.png". Empty if there is none.
std::string denoised_path(const FilmFiles&);

/// Whether the picture is developed for display: the film is on, and the format is neither OpenEXR
/// nor Radiance HDR.
bool is_developed(const FilmFiles&);

/// Develops the picture to display values from 0 to 1 and writes it. Returns false, with a
/// diagnostic, on failure.
bool write_developed(Negative, const FilmFiles&, Diagnostics&);

/// Returns the interleaved channels of the picture as a PNG file with 8 bits a channel has them:
/// red, green, blue, and alpha if there is any.
std::vector<std::uint8_t> shown_bytes(Negative, const FilmFiles&);
std::vector<std::uint8_t> shown_bytes(const Film&, const FilmFiles&);

/// Returns the picture and its layers, as an OpenEXR file has them.
LayeredPicture layered_picture(const Film&, const FilmFiles&);

/// Returns how many bytes of memory write_film() takes for each pixel of the picture, at most.
std::size_t bytes_to_write(const FilmFiles&);

/// Writes the picture and its layers. Returns false, with a diagnostic, on failure.
bool write_film(const Film&, const FilmFiles&, Diagnostics&);

}  // namespace candelabra

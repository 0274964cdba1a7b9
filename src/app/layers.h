// SPDX-License-Identifier: GPL-3.0-or-later
// What a film becomes as files: the picture, and named layers beside its colours, in an OpenEXR
// file. Called when a picture is finished, and by merge.
#pragma once

#include "camera/film_settings.h"
#include "picture/write.h"
#include "transport/aovs.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

class Film;
struct Negative;
class SourceStore;
class World;

enum class PictureLayer { albedo, normal, depth, object, lights, variance, samples, shadow_rays };

struct LayerInfo {
    PictureLayer layer;
    std::string_view name;
    std::string_view help;
};

/// All of them, in the order of the type.
std::span<const LayerInfo> all_layers();

/// Names with commas between them, or `all`; each layer once. Nothing when a name is none of them.
std::optional<std::vector<PictureLayer>> read_layer_list(std::string_view);
std::string layer_list(std::span<const PictureLayer>);

/// What is made of a film beside layers.
struct Extras {
    bool smooth = false;   ///< a response whose edges are to be smooth
    bool denoise = false;  ///< a picture with less noise
};

/// What the film has to gather for these layers.
Aovs aovs_for(std::span<const PictureLayer>, bool alpha, const Extras& = {});

/// Names of the layers of light, one for each of Provenance::light_statements: of the declared name
/// or the macro that a statement shows, or of its first word; a number tells equal ones apart.
std::vector<std::string> light_names(const World&, const SourceStore&);

struct FilmFiles {
    std::string path;  ///< of the picture
    PictureFormat format;
    bool alpha = false;
    std::vector<PictureLayer> layers = {};
    std::vector<std::string> lights = {};  ///< names of statements, when there are layers of light
    FilmSettings film = {};                ///< how pictures that people look at are developed
    bool denoise = false;                  ///< a picture with less noise is made, too
    int threads = 1;                       ///< that develop pictures

    /// What the film has to have.
    Aovs aovs() const;
};

/// Layers of OpenEXR files, of the picture with less noise and of compressed samples, and the text
/// with the film's settings.
inline constexpr std::string_view denoised_layer = "denoised";
inline constexpr std::string_view smooth_layer = "film";
inline constexpr std::string_view film_text_name = "candelabraFilm";

/// Where the layers go: into the picture, if that is an OpenEXR file; otherwise beside it,
/// "a.png" to "a.layers.exr". Empty: there are none.
std::string layers_path(const FilmFiles&);

/// Where the picture with less noise goes when it is no layer of the picture itself: beside it,
/// "a.png" to "a.denoised.png". Empty: there is none.
std::string denoised_path(const FilmFiles&);

/// Whether the picture is one that people look at: neither OpenEXR nor Radiance HDR.
bool is_developed(const FilmFiles&);

/// The picture as its film develops it, with values from 0 to 1 for a display, and how its file is
/// encoded then.
bool write_developed(const Negative&, const FilmFiles&, Diagnostics&);

/// Writes picture and layers. False, with a diagnostic, when that fails.
bool write_film(const Film&, const FilmFiles&, Diagnostics&);

}  // namespace candelabra

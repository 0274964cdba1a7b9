// SPDX-License-Identifier: GPL-3.0-or-later
// Encodes and writes pictures. Formats of 8 or 16 bits are clipped to 0..1, encoded as sRGB and
// rounded, as POV-Ray 3.7 does; OpenEXR and Radiance HDR keep linear values. The bytes depend only
// on the picture and the format.
#pragma once

#include "base/image.h"
#include "text/diagnostic.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

enum class PictureType { png, exr, hdr, ppm, tga, jpeg, bmp };

struct PictureFormat {
    PictureType type = PictureType::png;
    int bits = 8;             ///< per channel; 16 for png only
    bool compressed = false;  ///< tga only
    bool grey = false;        ///< one channel; png and ppm only
    double gamma = 1;         ///< raising the picture's values to this power makes them linear
    double file_gamma = -1;   ///< the same for the file's values; below 0: the sRGB curve
    /// If false, values are neither linearised nor encoded, as before POV-Ray 3.7.
    bool encoded = true;
    std::string description = {};  ///< the picture's origin, for formats that can store a text
};

/// Returns the file name extension without its dot, such as "png".
std::string_view extension(PictureType);

/// Whether a file of that type may hold an alpha channel, or a single grey channel.
bool has_alpha(PictureType);
bool has_grey(PictureType);

/// Whether files of that type can be written on this computer; reports a diagnostic if not. Meant
/// to be asked before the picture is made.
bool can_write(PictureType, Diagnostics&);

/// Returns the type for a file name's extension, ignoring case; nothing if the extension is
/// unknown.
std::optional<PictureType> type_of_name(std::string_view path);

/// Converts the value to an integer in 0..most: clips, linearises, encodes and rounds it. Returns 0
/// for not-a-number.
unsigned quantised(double value, unsigned most, const PictureFormat& = {});

/// Returns the nearest float that is a number and finite; 0 for not-a-number.
float finite_float(double);

/// Linearises the values as an OpenEXR file would store them.
Image linear(Image, const PictureFormat&);

/// Encodes the picture as a file of that format; returns nothing, with a diagnostic, if the picture
/// does not fit into it. `alpha` has one value per pixel, by which the pixel's colours have been
/// multiplied; empty if there is no alpha.
std::optional<std::string> encode(const Image&, const PictureFormat&, Diagnostics&,
                                  std::span<const double> alpha = {});

/// Encodes the picture and writes it as write_file() does.
bool write_picture(const Image&, const std::string& path, const PictureFormat&, Diagnostics&,
                   std::span<const double> alpha = {});

}  // namespace candelabra

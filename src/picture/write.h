// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures to files. Formats of 8 or 16 bits are clipped to 0..1, encoded as sRGB and rounded, as
// POV-Ray 3.7 does; OpenEXR and Radiance HDR keep linear values. The bytes depend on the picture
// and the format only.
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
    double gamma = 1;         ///< the picture's values to this power are linear
    double file_gamma = -1;   ///< the file's to this power are; below 0: the curve of sRGB
    /// False: values are neither made linear nor encoded, as before POV-Ray 3.7.
    bool encoded = true;
    std::string description = {};  ///< what made the picture, where the format has room for a text
};

/// Without the dot: "png".
std::string_view extension(PictureType);

/// What a file of that type may have besides three channels of colours.
bool has_alpha(PictureType);
bool has_grey(PictureType);

/// Whether files of that type can be written here; a diagnostic when they cannot. For those who
/// would rather know before the picture is made.
bool can_write(PictureType, Diagnostics&);

/// The type that a file's name ends in, in any case of letters; nothing when it is none of them.
std::optional<PictureType> type_of_name(std::string_view path);

/// The value as a whole number of 0..most: clipped, made linear, encoded, rounded. Not-a-number
/// gives 0.
unsigned quantised(double value, unsigned most, const PictureFormat& = {});

/// The values as OpenEXR has them: linear.
Image linear(Image, const PictureFormat&);

/// The bytes of a file of that format; nothing, with a diagnostic, when the picture does not fit
/// into it. `alpha`: of each pixel, by which its colours have been multiplied; empty: there is
/// none.
std::optional<std::string> encode(const Image&, const PictureFormat&, Diagnostics&,
                                  std::span<const double> alpha = {});

/// Encodes and writes the file as write_file() does.
bool write_picture(const Image&, const std::string& path, const PictureFormat&, Diagnostics&,
                   std::span<const double> alpha = {});

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// Encodes and writes pictures. Formats of 8 or 16 bits are clipped to 0..1, encoded as sRGB and
// rounded, as POV-Ray 3.7 does; OpenEXR and Radiance HDR keep linear values. The bytes depend only
// on the picture and the format.
#pragma once

#include "base/function_ref.h"
#include "base/image.h"
#include "text/diagnostic.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

enum class PictureType { png, exr, hdr, ppm, tga, jpeg, bmp, tiff, webp };

/// What is known of a type. A type is added by its row in write.cpp.
struct PictureTypeInfo {
    PictureType type;
    std::string_view name;              ///< for people
    std::string_view extension;         ///< of file names, without its dot
    std::string_view other;             ///< an alternative extension
    char letter;                        ///< of the option +F
    bool linear;                        ///< stores 32 bits or a shared exponent, and linear values
    bool alpha, grey;                   ///< whether these channels are offered
    bool wide;                          ///< whether it may have 16 bits in each channel
    std::string_view compression = {};  ///< in OpenImageIO's terms; empty: its default
};

/// Returns all types, in the order in which messages list them.
std::span<const PictureTypeInfo> picture_types();
const PictureTypeInfo& info(PictureType);
inline std::string_view extension(PictureType type) { return info(type).extension; }

struct PictureFormat {
    PictureType type = PictureType::png;
    int bits = 8;             ///< per channel; 16 for wide types
    bool compressed = false;  ///< tga only
    bool grey = false;        ///< one channel
    double gamma = 1;         ///< raising the picture's values to this power makes them linear
    double file_gamma = -1;   ///< the same for the file's values; below 0: the sRGB curve
    /// If false, values are neither linearised nor encoded, as before POV-Ray 3.7.
    bool encoded = true;
    std::string description = {};  ///< the picture's origin, for formats that can store a text
};

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

/// A picture whose rows are made one by one when it is written, so that it takes no memory itself.
struct PictureRows {
    int width = 0, height = 0;
    bool alpha = false;
    /// Sets the pixels of a row. If there is alpha, also sets its values, by which the pixel's
    /// colours have been multiplied; otherwise these are empty. Called for all rows from the top.
    FunctionRef<void(int y, std::span<Rgb> pixels, std::span<double> alpha)> row;
};

/// Encodes the picture as a file of that format; returns nothing, with a diagnostic, if the picture
/// does not fit into it. `alpha` has one value per pixel, by which the pixel's colours have been
/// multiplied; empty if there is no alpha.
std::optional<std::string> encode(const Image&, const PictureFormat&, Diagnostics&,
                                  std::span<const double> alpha = {});
std::optional<std::string> encode(const PictureRows&, const PictureFormat&, Diagnostics&);

/// Returns the interleaved channels of the pixels as a file of 8 bits a channel has them.
std::vector<std::uint8_t> bytes_of(const PictureRows&, const PictureFormat&);

/// Encodes the picture and writes it as write_file() does.
bool write_picture(const Image&, const std::string& path, const PictureFormat&, Diagnostics&,
                   std::span<const double> alpha = {});
bool write_picture(const PictureRows&, const std::string& path, const PictureFormat&, Diagnostics&);

}  // namespace candelabra

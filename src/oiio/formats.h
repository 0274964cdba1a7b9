// SPDX-License-Identifier: GPL-3.0-or-later
// Picture files as they are stored, without interpretation; picture/ is built on this. It uses
// OpenImageIO, whose many libraries take longer to load than most scenes take to read. So this
// module is a separate library, loaded when the first picture that is not a PNG file is read or
// written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

/// The contents of a file. Integers are scaled to 0..1. Alpha is separate, and colours are not
/// multiplied by it, unless the file does not tell how they were stored.
struct StoredPicture {
    int width = 0;
    int height = 0;
    int channels = 3;                    ///< 1 or 3
    int bits = 8;                        ///< per channel
    std::vector<float> values;           ///< row by row from the top, with interleaved channels
    std::vector<float> alpha;            ///< of each pixel; empty: none
    std::vector<std::uint16_t> numbers;  ///< palette index of each pixel; empty: none or not known
    bool linear = false;                 ///< declared by the file, or floating-point values
    double gamma = 0;                    ///< of the values, if declared; otherwise 0
    std::string format;                  ///< in OpenImageIO's terms: "png", "pnm", "openexr" ...
};

/// The contents of a file to write: 1 or 3 channels of colours, and one more for alpha. Integer
/// colours are not multiplied by alpha, others are.
struct RawPicture {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> values;
    std::string_view extension;    ///< selects the format
    std::string_view compression;  ///< in OpenImageIO's terms; empty: the format's default
    std::string description = {};  ///< of its origin, for formats that support one
    double gamma = -1;             ///< exponent that makes the values linear; below 0: sRGB
};

/// A named plane of a picture: 32 bits for each pixel, row by row from the top.
struct ChannelPlane {
    std::string name;    ///< as OpenEXR names channels: "albedo.R"
    bool whole = false;  ///< unsigned integers; otherwise the bits of floats
    std::vector<std::uint32_t> bits;
};

/// An OpenEXR file with any planes, and text attributes.
struct LayeredPicture {
    int width = 0;
    int height = 0;
    std::vector<ChannelPlane> planes;
    std::vector<std::pair<std::string, std::string>> texts;
};

/// The entry points. Each returns an error message, or an empty string.
struct Formats {
    /// Decodes the bytes of a file. A picture of more than `max_pixels` is rejected, since its file
    /// is considered damaged.
    std::string (*read)(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);
    std::string (*write)(const RawPicture&, std::string& bytes);
    /// Reads the text attributes that the picture already names, and all planes, which must have 32
    /// bits, or all be floats.
    std::string (*read_layers)(std::string_view bytes, std::int64_t max_pixels, LayeredPicture&);
    std::string (*write_layers)(const LayeredPicture&, std::string& bytes);
};

/// The file name of the library, and its only function: `const Formats* candelabra_formats()`.
inline constexpr auto formats_library = "libcandelabra_oiio.so";
inline constexpr auto formats_function = "candelabra_formats";

}  // namespace candelabra

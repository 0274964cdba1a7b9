// SPDX-License-Identifier: GPL-3.0-or-later
// Picture files as they are stored, before any meaning: what picture/ is built on. OpenImageIO is
// behind it, whose many libraries take longer to load than most scenes take to read; so this module
// is a library of its own, opened when the first picture that is no PNG file is read or written.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

/// What a file holds. Whole numbers come as 0..1; alpha comes apart, and colours are as they would
/// be without it, unless the file says nothing of how they were stored.
struct StoredPicture {
    int width = 0;
    int height = 0;
    int channels = 3;                    ///< 1 or 3
    int bits = 8;                        ///< of a channel
    std::vector<float> values;           ///< row by row from the top, channels side by side
    std::vector<float> alpha;            ///< of each pixel; empty: the file has none
    std::vector<std::uint16_t> numbers;  ///< of each pixel's colour in the file's table; empty: it
                                         ///< has none, or whoever read it does not tell
    bool linear = false;                 ///< the file says so, or holds floating-point numbers
    double gamma = 0;                    ///< of the values, if the file says it; otherwise 0
    std::string format;                  ///< in OpenImageIO's words: "png", "pnm", "openexr" ...
};

/// What a file shall hold: 1 or 3 channels of colours, and one more for alpha. Colours of whole
/// numbers are as they would be without alpha, others are multiplied by it.
struct RawPicture {
    int width = 0;
    int height = 0;
    int channels = 3;
    std::variant<std::vector<std::uint8_t>, std::vector<std::uint16_t>, std::vector<float>> values;
    std::string_view extension;    ///< names the format
    std::string_view compression;  ///< in OpenImageIO's words; empty for the format's own
    std::string description = {};  ///< of what made it, for formats that have room for one
    double gamma = -1;             ///< the values to this power are linear; below 0: sRGB
};

/// One plane of a picture with named planes: 32 bits for each pixel, row by row from the top.
struct ChannelPlane {
    std::string name;    ///< as OpenEXR names channels: "albedo.R"
    bool whole = false;  ///< unsigned whole numbers; otherwise the bits of floats
    std::vector<std::uint32_t> bits;
};

/// An OpenEXR file with any planes, and texts in its head.
struct LayeredPicture {
    int width = 0;
    int height = 0;
    std::vector<ChannelPlane> planes;
    std::vector<std::pair<std::string, std::string>> texts;
};

/// The entry points. Each returns what went wrong, or an empty string.
struct Formats {
    /// From the bytes of a file. A picture of more than `max_pixels` is refused: its file is taken
    /// for a damaged one.
    std::string (*read)(std::string_view bytes, std::int64_t max_pixels, StoredPicture&);
    std::string (*write)(const RawPicture&, std::string& bytes);
    /// Reads the texts that the picture names already, and all planes, which must have 32 bits, or
    /// all be floats.
    std::string (*read_layers)(std::string_view bytes, std::int64_t max_pixels, LayeredPicture&);
    std::string (*write_layers)(const LayeredPicture&, std::string& bytes);
};

/// The name of the library, and of its one function: `const Formats* candelabra_formats()`.
inline constexpr auto formats_library = "libcandelabra_oiio.so";
inline constexpr auto formats_function = "candelabra_formats";

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/write.h"

#include "base/colour.h"
#include "base/gamma.h"
#include "base/video_gamma.h"
#include "picture/file.h"
#include "picture/formats.h"
#include "text/ascii.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <type_traits>
#include <vector>

namespace candelabra {

namespace {

constexpr auto types = std::array{
    PictureTypeInfo{PictureType::png, "png", "png", "png", 'N', false, true, true, true},
    PictureTypeInfo{PictureType::exr, "OpenEXR", "exr", "exr", 'E', true, true, false, false,
                    "zip"},
    PictureTypeInfo{PictureType::hdr, "Radiance HDR", "hdr", "rgbe", 'H', true, false, false,
                    false},
    PictureTypeInfo{PictureType::ppm, "ppm", "ppm", "pnm", 'P', false, false, true, false},
    PictureTypeInfo{PictureType::tga, "tga", "tga", "tpic", 'T', false, true, false, false},
    PictureTypeInfo{PictureType::jpeg, "jpeg", "jpg", "jpeg", 'J', false, false, false, false,
                    "jpeg:95"},
    PictureTypeInfo{PictureType::bmp, "bmp", "bmp", "dib", 'B', false, false, false, false},
    PictureTypeInfo{PictureType::tiff, "tiff", "tif", "tiff", 'I', false, true, true, true},
    PictureTypeInfo{PictureType::webp, "webp", "webp", "webp", 'W', false, true, false, false,
                    "webp:100"},
};

/// Radiance's shared exponents cannot represent negative values.
float representable(double value, const PictureFormat& format) {
    if (format.encoded) value = to_linear(value, format.gamma);
    if (format.type != PictureType::hdr) return finite_float(value);
    return value > 0 ? static_cast<float>(std::min(value, 1e37)) : 0.0f;
}

/// Divides a pixel by its alpha, for integer formats, which store unmultiplied colours. The alpha
/// of a pixel that is brighter than its alpha allows is raised, as in POV-Ray 3.7.
Rgb divided(const Rgb& pixel, double& alpha) {
    alpha = std::max(alpha, std::min(grey(pixel), 1.0));
    return alpha > 0 ? pixel / alpha : Rgb(0);
}

/// Appends the interleaved channels of a row.
template <class Value, class Convert>
void add_channels(std::span<const Rgb> pixels, std::span<const double> alpha, bool in_grey,
                  const Convert& convert, std::vector<Value>& result) {
    constexpr bool whole = std::is_integral_v<Value>;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        double opaque = alpha.empty() ? 1 : alpha[i];
        // Alpha above 1 may occur in input files. Not-a-number becomes 0.
        if (whole) opaque = std::fmin(1, std::fmax(0, opaque));
        const Rgb pixel = whole && !alpha.empty() ? divided(pixels[i], opaque) : pixels[i];
        if (in_grey)
            result.push_back(convert(grey(pixel)));
        else
            for (int c = 0; c < 3; ++c) result.push_back(convert(pixel[c]));
        if (alpha.empty()) continue;
        constexpr double most = whole ? static_cast<double>(static_cast<Value>(~0u)) : 1;
        result.push_back(static_cast<Value>(whole ? std::floor(most * opaque + 0.5) : opaque));
    }
}

std::size_t pixels_of(const PictureRows& rows) {
    return static_cast<std::size_t>(rows.width) * static_cast<std::size_t>(rows.height);
}

int channels_of(const PictureRows& rows, const PictureFormat& format) {
    return (format.grey ? 1 : 3) + (rows.alpha ? 1 : 0);
}

/// Returns the interleaved channels of all rows.
template <class Value, class Convert>
std::vector<Value> channels_of(const PictureRows& rows, const PictureFormat& format,
                               const Convert& convert) {
    std::vector<Value> result;
    result.reserve(pixels_of(rows) * static_cast<std::size_t>(channels_of(rows, format)));
    std::vector<Rgb> pixels(static_cast<std::size_t>(rows.width));
    std::vector<double> alpha(rows.alpha ? pixels.size() : 0);
    for (int y = 0; y < rows.height; ++y) {
        rows.row(y, pixels, alpha);
        add_channels<Value>(pixels, alpha, format.grey, convert, result);
    }
    return result;
}

/// Lookup table from values to bytes; faster than computing powers for large pictures.
class ByteTable {
public:
    explicit ByteTable(const PictureFormat& format) {
        for (unsigned byte = 1; byte <= borders_.size(); ++byte) {
            double below = 0, there = 1, middle = 0.5;
            while (middle != below && middle != there) {
                (quantised(middle, 255, format) >= byte ? there : below) = middle;
                middle = 0.5 * (below + there);
            }
            borders_[byte - 1] = there;
        }
        for (std::size_t i = 0; i < parts; ++i)
            first_[i] = up_from(0, static_cast<double>(i) / parts);
    }

    std::uint8_t operator()(double value) const {
        if (!(value > 0)) return 0;
        return value < 1 ? up_from(first_[static_cast<std::size_t>(value * parts)], value) : 255;
    }

private:
    static constexpr std::size_t parts = 4096;  ///< so many that few parts contain two borders

    std::uint8_t up_from(std::uint8_t byte, double value) const {
        while (byte < borders_.size() && borders_[byte] <= value) ++byte;
        return byte;
    }

    std::array<double, 255> borders_;             ///< the least values that map to 1, 2, ...
    std::array<std::uint8_t, parts> first_ = {};  ///< the bytes at the lower ends of the parts
};

template <class Integer>
std::vector<Integer> integers(const PictureRows& rows, const PictureFormat& format) {
    if constexpr (sizeof(Integer) == 1) {
        constexpr std::size_t large = 50'000;
        if (pixels_of(rows) > large) return channels_of<Integer>(rows, format, ByteTable(format));
    }
    return channels_of<Integer>(rows, format, [&](double value) {
        return static_cast<Integer>(quantised(value, static_cast<Integer>(~0u), format));
    });
}

RawPicture raw_picture(const PictureRows& rows, const PictureFormat& format) {
    const PictureTypeInfo& type = info(format.type);
    RawPicture raw{rows.width,
                   rows.height,
                   channels_of(rows, format),
                   {},
                   type.extension,
                   {},
                   format.description,
                   !format.encoded                  ? srgb_gamma
                   : format.file_gamma < srgb_gamma ? video_power
                                                    : format.file_gamma};
    if (type.linear)
        raw.values = channels_of<float>(rows, format,
                                        [&](double value) { return representable(value, format); });
    else if (format.bits == 16)
        raw.values = integers<std::uint16_t>(rows, format);
    else
        raw.values = integers<std::uint8_t>(rows, format);
    raw.compression = type.compression;
    if (format.type == PictureType::tga) raw.compression = format.compressed ? "rle" : "none";
    return raw;
}

/// Inserts the description as a comment after the first line of PPM and Radiance files, which the
/// library does not do.
void describe(std::string& bytes, const PictureFormat& format) {
    if (format.type != PictureType::ppm && format.type != PictureType::hdr) return;
    const std::size_t end = bytes.find('\n');
    if (!format.description.empty() && end != bytes.npos)
        bytes.insert(end + 1, message("# ", format.description, "\n"));
}

}  // namespace

float finite_float(double value) {
    constexpr double most = std::numeric_limits<float>::max();
    return std::isnan(value) ? 0.0f : static_cast<float>(std::clamp(value, -most, most));
}

std::span<const PictureTypeInfo> picture_types() { return types; }

const PictureTypeInfo& info(PictureType type) {
    return *std::ranges::find(types, type, &PictureTypeInfo::type);
}

bool can_write(PictureType type, Diagnostics& diagnostics) {
    return writes_itself(info(type).extension) || picture_formats(diagnostics);
}

std::optional<PictureType> type_of_name(std::string_view path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string_view::npos || path[dot] == '/') return std::nullopt;
    const std::string_view ending = path.substr(dot + 1);
    for (const PictureTypeInfo& type : types)
        if (same_letters(ending, type.extension) || same_letters(ending, type.other))
            return type.type;
    return std::nullopt;
}

unsigned quantised(double value, unsigned most, const PictureFormat& format) {
    if (!(value > 0)) return 0;
    double shown = std::min(value, 1.0);
    if (format.encoded)
        shown = std::min(value_of(to_linear(shown, format.gamma), format.file_gamma), 1.0);
    return static_cast<unsigned>(std::floor(most * shown + 0.5));
}

Image linear(Image image, const PictureFormat& format) {
    for (Rgb& pixel : image.pixels)
        for (int c = 0; c < 3; ++c) pixel[c] = representable(pixel[c], format);
    return image;
}

std::optional<std::string> encode(const PictureRows& rows, const PictureFormat& format,
                                  Diagnostics& diagnostics) {
    std::optional<std::string> bytes = write_stored(raw_picture(rows, format), diagnostics);
    if (bytes) describe(*bytes, format);
    return bytes;
}

std::optional<std::string> encode(const Image& image, const PictureFormat& format,
                                  Diagnostics& diagnostics, std::span<const double> alpha) {
    const auto row = [&](int y, std::span<Rgb> pixels, std::span<double> opaque) {
        const std::size_t first = static_cast<std::size_t>(y) * pixels.size();
        std::ranges::copy(std::span(image.pixels).subspan(first, pixels.size()), pixels.begin());
        if (!opaque.empty()) std::ranges::copy(alpha.subspan(first, pixels.size()), opaque.begin());
    };
    return encode(PictureRows{image.width, image.height, !alpha.empty(), row}, format, diagnostics);
}

std::vector<std::uint8_t> bytes_of(const PictureRows& rows, const PictureFormat& format) {
    return integers<std::uint8_t>(rows, format);
}

bool write_picture(const PictureRows& rows, const std::string& path, const PictureFormat& format,
                   Diagnostics& diagnostics) {
    const auto bytes = encode(rows, format, diagnostics);
    return bytes && write_file(path, *bytes, diagnostics);
}

bool write_picture(const Image& image, const std::string& path, const PictureFormat& format,
                   Diagnostics& diagnostics, std::span<const double> alpha) {
    const auto bytes = encode(image, format, diagnostics, alpha);
    return bytes && write_file(path, *bytes, diagnostics);
}

}  // namespace candelabra

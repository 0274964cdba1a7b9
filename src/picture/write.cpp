// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/write.h"

#include "base/colour.h"
#include "picture/file.h"
#include "picture/formats.h"
#include "picture/gamma.h"
#include "text/message.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

namespace {

struct TypeInfo {
    PictureType type;
    std::string_view extension;
    std::string_view other;  ///< another extension that is understood
    bool linear;
};

constexpr auto types = std::array{
    TypeInfo{PictureType::png, "png", "png", false},
    TypeInfo{PictureType::exr, "exr", "exr", true},
    TypeInfo{PictureType::hdr, "hdr", "rgbe", true},
    TypeInfo{PictureType::ppm, "ppm", "pnm", false},
    TypeInfo{PictureType::tga, "tga", "tpic", false},
    TypeInfo{PictureType::jpeg, "jpg", "jpeg", false},
    TypeInfo{PictureType::bmp, "bmp", "dib", false},
};

const TypeInfo& info(PictureType type) {
    return *std::find_if(types.begin(), types.end(),
                         [&](const TypeInfo& each) { return each.type == type; });
}

template <class Integer>
std::vector<Integer> integers(const Image& image, const PictureFormat& format) {
    constexpr unsigned most = static_cast<Integer>(~0u);
    std::vector<Integer> result;
    result.reserve(image.pixels.size() * 3);
    for (const Vec3& pixel : image.pixels)
        for (int i = 0; i < 3; ++i)
            result.push_back(static_cast<Integer>(quantised(pixel[i], most, format)));
    return result;
}

/// Radiance's shared exponents have no room for negative, infinite or undefined values.
float representable(double value, const PictureFormat& format) {
    if (format.encoded) value = to_linear(value, format.gamma);
    if (format.type != PictureType::hdr) return static_cast<float>(value);
    return value > 0 ? static_cast<float>(std::min(value, 1e37)) : 0.0f;
}

std::vector<float> floats(const Image& image, const PictureFormat& format) {
    std::vector<float> result;
    result.reserve(image.pixels.size() * 3);
    for (const Vec3& pixel : image.pixels)
        for (int i = 0; i < 3; ++i) result.push_back(representable(pixel[i], format));
    return result;
}

RawPicture raw_picture(const Image& image, const PictureFormat& format, const TypeInfo& type) {
    RawPicture raw{image.width, image.height, {}, type.extension, {}, format.description};
    if (type.linear)
        raw.values = floats(image, format);
    else if (format.bits == 16)
        raw.values = integers<std::uint16_t>(image, format);
    else
        raw.values = integers<std::uint8_t>(image, format);
    if (format.type == PictureType::exr) raw.compression = "zip";
    if (format.type == PictureType::jpeg) raw.compression = "jpeg:95";
    if (format.type == PictureType::tga) raw.compression = format.compressed ? "rle" : "none";
    return raw;
}

}  // namespace

std::string_view extension(PictureType type) { return info(type).extension; }

std::optional<PictureType> type_of_name(std::string_view path) {
    const std::size_t dot = path.find_last_of("./");
    if (dot == std::string_view::npos || path[dot] == '/') return std::nullopt;
    std::string ending(path.substr(dot + 1));
    for (char& c : ending)
        if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    for (const TypeInfo& type : types)
        if (ending == type.extension || ending == type.other) return type.type;
    return std::nullopt;
}

unsigned quantised(double value, unsigned most, const PictureFormat& format) {
    if (!(value > 0)) return 0;
    double shown = std::min(value, 1.0);
    if (format.encoded) shown = std::min(srgb_encode(to_linear(shown, format.gamma)), 1.0);
    return static_cast<unsigned>(std::floor(most * shown + 0.5));
}

std::optional<std::string> encode(const Image& image, const PictureFormat& format,
                                  Diagnostics& diagnostics) {
    const TypeInfo& type = info(format.type);
    const Formats* formats = picture_formats(diagnostics);
    if (!formats) return std::nullopt;
    std::string bytes;
    const std::string problem = formats->write(raw_picture(image, format, type), bytes);
    if (problem.empty()) return bytes;
    diagnostics.add(error(Fault::io, {},
                          message("cannot make a ", type.extension, " file of ", image.width,
                                  " by ", image.height, " pixels: ", problem)));
    return std::nullopt;
}

bool write_picture(const Image& image, const std::string& path, const PictureFormat& format,
                   Diagnostics& diagnostics) {
    const auto bytes = encode(image, format, diagnostics);
    return bytes && write_file(path, *bytes, diagnostics);
}

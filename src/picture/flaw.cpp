// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/flaw.h"

#include "picture/formats.h"
#include "picture/layers.h"
#include "picture/write.h"
#include "png/png.h"
#include "text/loader.h"
#include "text/message.h"

#include <cstdint>
#include <optional>
#include <string_view>

namespace candelabra {

namespace {

struct PictureSize {
    int width = 0, height = 0;
};

std::uint32_t four_bytes(std::string_view bytes, std::size_t at) {
    std::uint32_t number = 0;
    for (std::size_t i = 0; i < 4; ++i)
        number = number << 8 | static_cast<unsigned char>(bytes[at + i]);
    return number;
}

/// Returns the size of a PNG file whose chunks follow each other to the last one, at its end. (The
/// PNG specification, sections 5.3 and 11.2.)
std::optional<PictureSize> size_of_png(std::string_view bytes) {
    constexpr std::size_t signature = 8, around = 12;
    if (!is_png(bytes)) return std::nullopt;
    PictureSize size;
    for (std::size_t at = signature; at + around <= bytes.size();) {
        const std::size_t length = four_bytes(bytes, at), rest = bytes.size() - at - around;
        const std::string_view name = bytes.substr(at + 4, 4);
        if (length > rest) return std::nullopt;
        if (name == "IHDR" && length >= 8)
            size = {static_cast<int>(four_bytes(bytes, at + 8)),
                    static_cast<int>(four_bytes(bytes, at + 12))};
        if (name == "IEND") return rest == length ? std::optional(size) : std::nullopt;
        at += around + length;
    }
    return std::nullopt;
}

/// Whether the file has the end that the program gives to such files, and that readers may not
/// miss: the footer of Targa files of version 2, and the marker at the end of JPEG files.
bool has_end(PictureType type, std::string_view bytes) {
    using namespace std::literals;
    if (type == PictureType::tga) return bytes.ends_with("TRUEVISION-XFILE.\0"sv);
    return type != PictureType::jpeg || bytes.ends_with("\xFF\xD9"sv);
}

/// Reads the whole file; nothing if a part of it is missing.
std::optional<PictureSize> size_by_reading(const std::string& path, std::string text) {
    Diagnostics unsaid;
    const auto type = type_of_name(path);
    if (type && !has_end(*type, text)) return std::nullopt;
    if (type == PictureType::exr) {
        const auto picture = read_layers(path, {}, unsaid);
        if (!picture) return std::nullopt;
        return PictureSize{picture->width, picture->height};
    }
    const auto picture = read_stored({path, std::move(text)}, unsaid, {});
    if (!picture) return std::nullopt;
    return PictureSize{picture->width, picture->height};
}

}  // namespace

std::string flaw_of_picture(const std::string& path, int width, int height) {
    std::optional<std::string> text = disk_reader()(path);
    if (!text) return "it cannot be read";
    if (text->empty()) return "it is empty";
    const std::optional<PictureSize> size = type_of_name(path) == PictureType::png
                                                ? size_of_png(*text)
                                                : size_by_reading(path, std::move(*text));
    if (!size) return "it ends early, or is no such picture";
    if (size->width == width && size->height == height) return {};
    return message("it has ", size->width, "x", size->height, " pixels and not ", width, "x",
                   height);
}

}  // namespace candelabra

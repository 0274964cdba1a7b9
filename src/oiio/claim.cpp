// SPDX-License-Identifier: GPL-3.0-or-later
#include "oiio/claim.h"

#include "oiio/exr_claim.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace candelabra {

namespace {

using namespace std::string_view_literals;

struct Signature {
    std::string_view format, bytes;
};
constexpr auto signatures = std::to_array<Signature>({{"gif", "GIF87a"},
                                                      {"gif", "GIF89a"},
                                                      {"png", "\x89PNG\r\n\x1a\n"},
                                                      {"jpeg", "\xff\xd8\xff"},
                                                      {"bmp", "BM"},
                                                      {"tiff", "II*\0"sv},
                                                      {"tiff", "MM\0*"sv},
                                                      {"tiff", "II+\0"sv},
                                                      {"tiff", "MM\0+"sv},
                                                      {"webp", "RIFF"},
                                                      {"openexr", "\x76\x2f\x31\x01"},
                                                      {"hdr", "#?RADIANCE"},
                                                      {"hdr", "#?RGBE"},
                                                      {"pnm", "P1"},
                                                      {"pnm", "P2"},
                                                      {"pnm", "P3"},
                                                      {"pnm", "P4"},
                                                      {"pnm", "P5"},
                                                      {"pnm", "P6"}});

unsigned byte_of(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 0;
}
double low_first(std::string_view bytes, std::size_t at, std::size_t count) {
    double number = 0;
    for (std::size_t i = count; i-- > 0;) number = 256 * number + byte_of(bytes, at + i);
    return number;
}
double high_first(std::string_view bytes, std::size_t at) {
    return 256.0 * byte_of(bytes, at) + byte_of(bytes, at + 1);
}

/// Targa files have no signature, so the fields of the header must be consistent. Files with
/// palette indices are handled by a reader of their own.
bool is_targa(std::string_view bytes) {
    constexpr std::size_t head = 18;
    const unsigned kind = byte_of(bytes, 2), bits = byte_of(bytes, 16);
    const bool grey = (kind & 7) == 3 && bits == 8;
    const bool coloured = (kind & 7) == 2 && (bits == 15 || bits == 16 || bits == 24 || bits == 32);
    return bytes.size() > head && byte_of(bytes, 1) <= 1 && (kind & ~8u) <= 3 && (grey || coloured);
}

std::string targa_problem(std::string_view bytes) {
    const double pixels = low_first(bytes, 12, 2) * low_first(bytes, 14, 2);
    const double step = std::ceil(byte_of(bytes, 16) / 8.0);
    const bool packed = (byte_of(bytes, 2) & 8) != 0;
    // A packet of one byte and one pixel repeats the pixel up to 128 times.
    return too_large(pixels * step, packed ? 128 * step / (1 + step) : 1, bytes.size());
}

std::string gif_problem(std::string_view bytes) {
    constexpr double with_alpha = 4;
    return too_large(with_alpha * low_first(bytes, 6, 2) * low_first(bytes, 8, 2),
                     max_growth("gif", {}), bytes.size());
}

std::string bmp_problem(std::string_view bytes) {
    constexpr double old_head = 12;
    const bool old = low_first(bytes, 14, 4) == old_head;
    const double width = low_first(bytes, 18, old ? 2 : 4);
    double height = low_first(bytes, old ? 20 : 22, old ? 2 : 4);
    // A negative height means that rows are stored from the top.
    if (!old && height >= 0x1p31) height = 0x1p32 - height;
    const double bits = low_first(bytes, old ? 24 : 28, 2);
    const double coding = old ? 0 : low_first(bytes, 30, 4);
    const bool runs = coding == 1 || coding == 2;
    return too_large(width * height * (runs ? 1 : bits / 8), runs ? 128 : 1, bytes.size());
}

/// Finds the size in the segment that begins the frame.
std::string jpeg_problem(std::string_view bytes) {
    for (std::size_t at = 2; at + 9 < bytes.size();) {
        const unsigned mark = byte_of(bytes, at + 1);
        if (byte_of(bytes, at) != 0xff || mark == 0xff) {
            ++at;
            continue;
        }
        const bool frame =
            mark >= 0xc0 && mark <= 0xcf && mark != 0xc4 && mark != 0xc8 && mark != 0xcc;
        if (frame)
            return too_large(
                high_first(bytes, at + 5) * high_first(bytes, at + 7) * byte_of(bytes, at + 9),
                max_growth("jpeg", {}), bytes.size());
        const bool bare = mark <= 1 || (mark >= 0xd0 && mark <= 0xd8);
        at += bare ? 2 : 2 + static_cast<std::size_t>(high_first(bytes, at + 2));
    }
    return "it has no size";
}

/// Returns the stated width times the height; 0 if there is no head of one of the three kinds. (RFC
/// 9649, sections 2.5 to 2.7.)
double webp_pixels(std::string_view bytes) {
    constexpr double sides = 0x1p14;  // of 14 bits; what follows them are flags
    const std::string_view kind = bytes.substr(std::min<std::size_t>(bytes.size(), 12), 4);
    if (kind == "VP8X") return (1 + low_first(bytes, 24, 3)) * (1 + low_first(bytes, 27, 3));
    if (kind == "VP8 ")
        return std::fmod(low_first(bytes, 26, 2), sides) *
               std::fmod(low_first(bytes, 28, 2), sides);
    if (kind != "VP8L") return 0;
    const double both = low_first(bytes, 21, 4);
    return (1 + std::fmod(both, sides)) * (1 + std::fmod(std::floor(both / sides), sides));
}

/// A WebP file of one colour needs no bytes for its pixels, so the least is granted to each file.
std::string webp_problem(std::string_view bytes) {
    if (bytes.substr(std::min<std::size_t>(bytes.size(), 8), 4) != "WEBP")
        return "it is no picture";
    constexpr double granted = 1 << 24, growth = 8192;
    const double pixels = webp_pixels(bytes);
    if (pixels <= granted) return pixels > 0 ? std::string() : "it has no size";
    return too_large(pixels, growth, bytes.size());
}

}  // namespace

Claim claim_of(std::string_view bytes) {
    for (const auto& [format, start] : signatures) {
        if (!bytes.starts_with(start)) continue;
        if (format == "gif") return {format, gif_problem(bytes)};
        if (format == "bmp") return {format, bmp_problem(bytes)};
        if (format == "jpeg") return {format, jpeg_problem(bytes)};
        if (format == "webp") return {format, webp_problem(bytes)};
        if (format == "openexr") return {format, exr_problem(bytes)};
        return {format, {}};
    }
    if (is_targa(bytes)) return {"targa", targa_problem(bytes)};
    return {{}, "it is of no format that the language names"};
}

double max_growth(std::string_view format, std::string_view compression) {
    struct Known {
        std::string_view name;
        double growth;
    };
    // Deflate expands two bits to 258 bytes; full LZW tables, twelve bits to 3839 bytes; a JPEG
    // frame, a bit to 64 pixels; zstd, four bytes to a block of 2^17; DWA, a value of deflate's
    // output to 64. The factors include expansion by a reader (palette indices to colours, all
    // channels to the largest type).
    constexpr double deflate = 1032, lzw = 2560, zstd = 32768;
    static constexpr auto compressions = std::to_array<Known>({{"none", 3},
                                                               {"packbits", 64},
                                                               {"rle", 64},
                                                               {"lzw", lzw},
                                                               {"zip", deflate},
                                                               {"zips", deflate},
                                                               {"deflate", deflate},
                                                               {"piz", deflate},
                                                               {"pxr24", 1376},
                                                               {"b44", 5},
                                                               {"b44a", 22},
                                                               {"jpeg", 2048},
                                                               {"dwaa", 64 * deflate},
                                                               {"dwab", 64 * deflate}});
    static constexpr auto formats = std::to_array<Known>({{"gif", 4 * lzw},
                                                          {"jpeg", 2048},
                                                          {"png", deflate},
                                                          {"pnm", 8},
                                                          {"hdr", 192},
                                                          {"webp", 0x1p60},  // see webp_problem()
                                                          {"bmp", 384},
                                                          {"targa", 128}});
    const auto* const by_format = std::ranges::find(formats, format, &Known::name);
    if (by_format != formats.end()) return by_format->growth;
    // The name may be followed by a quality, as in "dwaa:45".
    const std::string_view name = compression.substr(0, compression.find(':'));
    const auto* const found = std::ranges::find(compressions, name, &Known::name);
    return found != compressions.end() ? found->growth : zstd;
}

double covered(double width, double height, double tile_width, double tile_height) {
    constexpr double usual = 1 << 20;
    const double tile = tile_width * tile_height;
    return tile <= usual ? width * height
                         : std::max(width, tile_width) * std::max(height, tile_height);
}

std::string too_large(double pixel_bytes, double growth, std::size_t file_bytes) {
    if (pixel_bytes <= growth * static_cast<double>(file_bytes)) return {};
    return "its header is for a larger picture than its " + std::to_string(file_bytes) +
           " bytes can hold";
}

}  // namespace candelabra

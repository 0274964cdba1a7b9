// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/tga.h"

#include "base/size_product.h"

#include <cstddef>

namespace candelabra {

namespace {

using Rgba = std::array<std::uint8_t, 4>;

constexpr std::size_t head = 18;
constexpr std::uint8_t opaque_byte = 255;

/// The fields of the header that matter here.
struct Head {
    explicit Head(std::string_view bytes) : bytes_(bytes) {}

    unsigned byte(std::size_t at) const {
        return at < bytes_.size() ? static_cast<unsigned char>(bytes_[at]) : 0;
    }
    unsigned word(std::size_t at) const { return byte(at) | byte(at + 1) << 8; }

    bool packed() const { return (byte(2) & 8) != 0; }
    bool numbered() const { return byte(1) == 1 && (byte(2) & 7) == 1 && byte(16) == 8; }
    bool short_colours() const { return (byte(2) & 7) == 2 && (bits() == 15 || bits() == 16); }
    unsigned bits() const { return byte(16); }
    unsigned table_bits() const { return byte(7); }
    std::size_t table_size() const { return byte(1) == 1 ? word(5) : 0; }
    std::size_t table_at() const { return head + byte(0); }
    std::size_t pixels_at() const { return table_at() + table_size() * ((table_bits() + 7) / 8); }
    bool from_top() const { return (byte(17) & 0x20) != 0; }
    bool from_right() const { return (byte(17) & 0x10) != 0; }

    /// Reads a colour. Five-bit channels become the upper bits of a byte. The sixteenth bit marks
    /// the colour as opaque, whatever the header says about it.
    Rgba colour(std::size_t at, unsigned bits) const {
        const auto five = [&](unsigned shift) {
            return static_cast<std::uint8_t>((word(at) >> shift & 31) << 3);
        };
        const auto eight = [&](std::size_t i) { return static_cast<std::uint8_t>(byte(at + i)); };
        if (bits > 16) return {eight(2), eight(1), eight(0), bits == 32 ? eight(3) : opaque_byte};
        const bool opaque = bits == 15 || (word(at) & 0x8000) != 0;
        return {five(10), five(5), five(0), opaque ? opaque_byte : std::uint8_t{0}};
    }

private:
    std::string_view bytes_;
};

/// Returns the byte offset of each pixel in file order; empty if the file ends too early.
std::vector<std::size_t> places(const Head& file, std::size_t count, std::size_t end) {
    std::vector<std::size_t> result;
    constexpr std::size_t max_in_packet = 128;
    const std::size_t fitting = file.packed() ? size_product(max_in_packet, end) : end;
    if (count > fitting) return result;
    const std::size_t step = file.numbered() ? 1 : 2;
    std::size_t at = file.pixels_at();
    while (result.size() < count) {
        std::size_t run = file.packed() ? 1 + (file.byte(at) & 0x7f) : count;
        const bool same = file.packed() && (file.byte(at) & 0x80) != 0;
        if (file.packed()) ++at;
        for (; run > 0 && result.size() < count; --run) {
            if (at + step > end) return {};
            result.push_back(at);
            if (!same) at += step;
        }
        if (same) at += step;
    }
    return result;
}

}  // namespace

bool is_tga(std::string_view path) { return path.ends_with(".tga") || path.ends_with(".TGA"); }

std::vector<Rgba> tga_table(std::string_view bytes) {
    const Head file(bytes);
    std::vector<Rgba> table;
    if (!file.numbered() || file.pixels_at() > bytes.size()) return table;
    for (std::size_t i = 0; i < file.table_size(); ++i)
        table.push_back(
            file.colour(file.table_at() + i * ((file.table_bits() + 7) / 8), file.table_bits()));
    return table;
}

bool reads_tga(std::string_view bytes) {
    const Head file(bytes);
    return file.numbered() || file.short_colours();
}

bool read_tga(std::string_view bytes, std::int64_t max_pixels, StoredPicture& picture) {
    const Head file(bytes);
    const std::size_t width = file.word(12), height = file.word(14);
    if (!reads_tga(bytes)) return false;
    if (static_cast<std::int64_t>(width * height) > max_pixels) return false;
    const std::vector<Rgba> table = tga_table(bytes);
    const std::vector<std::size_t> found = places(file, width * height, bytes.size());
    if (found.empty()) return false;

    StoredPicture made;
    made.width = static_cast<int>(width);
    made.height = static_cast<int>(height);
    made.format = "targa";
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::size_t x = i % width, y = i / width;
        const std::size_t at = found[(file.from_top() ? y : height - 1 - y) * width +
                                     (file.from_right() ? width - 1 - x : x)];
        const unsigned number = file.byte(at);
        if (file.numbered() && number >= table.size()) return false;
        const Rgba colour = file.numbered() ? table[number] : file.colour(at, file.bits());
        if (file.numbered()) made.numbers.push_back(static_cast<std::uint16_t>(number));
        for (std::size_t channel = 0; channel < 3; ++channel)
            made.values.push_back(static_cast<float>(colour[channel]) / 255);
        made.alpha.push_back(static_cast<float>(colour[3]) / 255);
    }
    picture = std::move(made);
    return true;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/tiff_writer.h"

#include "raster/bytes.h"

#include <cstddef>
#include <cstdint>
#include <vector>

#include <zlib.h>

namespace candelabra {

namespace {

/// Types of the numbers in a directory.
enum TiffType : std::uint16_t { text_type = 2, word_type = 3, long_type = 4 };

/// A directory of entries in the order of their tags. What does not fit into an entry follows the
/// directory.
class TiffDirectory {
public:
    /// `start`: place of the directory in the file.
    explicit TiffDirectory(std::uint32_t start, std::uint16_t entries)
        : after_(start + 2 + 12U * entries + 4) {
        append_low_first(entries_, entries, 2);
    }

    void add(std::uint16_t tag, TiffType type, const std::vector<std::uint32_t>& numbers) {
        const int size = type == long_type ? 4 : 2;
        std::string value;
        for (const std::uint32_t each : numbers) append_low_first(value, each, size);
        add_bytes(tag, type, static_cast<std::uint32_t>(numbers.size()), std::move(value));
    }
    void add(std::uint16_t tag, std::string text) {
        text += '\0';
        const auto count = static_cast<std::uint32_t>(text.size());
        add_bytes(tag, text_type, count, std::move(text));
    }

    std::string bytes() const { return entries_ + std::string(4, '\0') + more_; }

private:
    void add_bytes(std::uint16_t tag, TiffType type, std::uint32_t count, std::string value) {
        constexpr std::size_t inside = 4;
        append_low_first(entries_, tag, 2);
        append_low_first(entries_, type, 2);
        append_low_first(entries_, count, 4);
        if (value.size() <= inside) {
            value.resize(inside);
            entries_ += value;
            return;
        }
        append_low_first(entries_, after_ + static_cast<std::uint32_t>(more_.size()), 4);
        if (value.size() % 2 != 0) value += '\0';  // numbers begin at even places
        more_ += value;
    }

    std::string entries_, more_;
    std::uint32_t after_;
};

std::string raw_bytes(const RawPicture& picture) {
    std::string bytes;
    if (const auto* small = std::get_if<std::vector<std::uint8_t>>(&picture.values))
        bytes.assign(small->begin(), small->end());
    else if (const auto* wide = std::get_if<std::vector<std::uint16_t>>(&picture.values))
        for (const std::uint16_t each : *wide) append_low_first(bytes, each, 2);
    return bytes;
}

}  // namespace

std::string write_tiff(const RawPicture& picture, std::string& bytes) {
    const std::string raw = raw_bytes(picture);
    uLongf packed_size = compressBound(raw.size());
    constexpr std::size_t head = 8, largest = 0xf0000000;  // places have 32 bits
    if (raw.size() > largest || packed_size > largest) return "a TIFF file has at most 4 GiB";
    std::string packed(packed_size, '\0');
    constexpr int level = 6;
    if (compress2(reinterpret_cast<Bytef*>(packed.data()), &packed_size,
                  reinterpret_cast<const Bytef*>(raw.data()), raw.size(), level) != Z_OK)
        return "there is not enough memory";
    packed.resize(packed_size + packed_size % 2);

    const bool grey = picture.channels < 3, alpha = picture.channels % 2 == 0,
               described = !picture.description.empty();
    const auto channels = static_cast<std::uint32_t>(picture.channels);
    const std::uint32_t bits =
        std::holds_alternative<std::vector<std::uint16_t>>(picture.values) ? 16 : 8;
    const auto start = static_cast<std::uint32_t>(head + packed.size());
    const auto height = static_cast<std::uint32_t>(picture.height);
    const auto entries = static_cast<std::uint16_t>(11 + (described ? 1 : 0) + (alpha ? 1 : 0));
    TiffDirectory directory(start, entries);
    directory.add(256, long_type, {static_cast<std::uint32_t>(picture.width)});
    directory.add(257, long_type, {height});
    directory.add(258, word_type, std::vector<std::uint32_t>(channels, bits));
    directory.add(259, word_type, {8});  // Deflate
    directory.add(262, word_type, {grey ? 1U : 2U});
    if (described) directory.add(270, picture.description);
    directory.add(273, long_type, {static_cast<std::uint32_t>(head)});
    directory.add(277, word_type, {channels});
    directory.add(278, long_type, {height});
    directory.add(279, long_type, {static_cast<std::uint32_t>(packed_size)});
    directory.add(284, word_type, {1});  // channels side by side
    directory.add(305, "Candelabra");
    if (alpha) directory.add(338, word_type, {2});  // colours are not multiplied by it

    bytes = std::string("II*\0", 4);
    append_low_first(bytes, start, 4);
    bytes += packed + directory.bytes();
    return {};
}

}  // namespace candelabra

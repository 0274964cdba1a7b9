// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/tiff.h"

#include "raster/bytes.h"
#include "raster/lzw.h"

#include <algorithm>
#include <array>

#include <zlib.h>

namespace candelabra {

namespace {

enum TiffTag : std::uint32_t {
    width_tag = 256,
    height_tag = 257,
    bits_tag = 258,
    compression_tag = 259,
    meaning_tag = 262,
    fill_order_tag = 266,
    strips_tag = 273,
    orientation_tag = 274,
    samples_tag = 277,
    rows_tag = 278,
    lengths_tag = 279,
    planes_tag = 284,
    predictor_tag = 317,
    table_tag = 320,
    tile_tag = 322,
    extra_tag = 338,
    number_kind_tag = 339,
};

enum TiffPacking : std::uint32_t {
    bare = 1,
    lzw = 5,
    deflate = 8,
    packbits = 32773,
    old_deflate = 32946,
};

/// Reads numbers in the file's byte order, and the entries of its first directory.
class TiffFile {
public:
    explicit TiffFile(std::string_view bytes)
        : bytes_(bytes), low_first_(bytes[0] == 'I'), directory_(number(4, 4)) {}

    std::string_view bytes() const { return bytes_; }
    bool low_first() const { return low_first_; }

    std::uint32_t number(std::size_t at, std::size_t size) const {
        std::uint32_t result = 0;
        for (std::size_t i = 0; i < size; ++i)
            result = result << 8 | byte_in(bytes_, at + (low_first_ ? size - 1 - i : i));
        return result;
    }

    /// Returns the numbers of an entry; none if it is missing or extends beyond the file.
    std::vector<std::uint32_t> all(TiffTag tag) const {
        constexpr std::size_t entry_size = 12, in_entry = 4;
        const std::size_t count = number(directory_, 2);
        for (std::size_t i = 0; i < count; ++i) {
            const std::size_t entry = directory_ + 2 + entry_size * i;
            if (number(entry, 2) != tag) continue;
            const std::size_t size = size_of(number(entry + 2, 2)), length = number(entry + 4, 4);
            const std::size_t inside = entry + 8;
            const std::size_t at = size * length <= in_entry ? inside : number(inside, 4);
            if (size == 0 || at > bytes_.size() || length > (bytes_.size() - at) / size) return {};
            std::vector<std::uint32_t> numbers;
            for (std::size_t k = 0; k < length; ++k) numbers.push_back(number(at + size * k, size));
            return numbers;
        }
        return {};
    }
    /// Returns the first number of an entry.
    std::uint32_t one(TiffTag tag, std::uint32_t otherwise) const {
        const std::vector<std::uint32_t> numbers = all(tag);
        return numbers.empty() ? otherwise : numbers.front();
    }

private:
    /// Returns the size of bytes, words and longs; 0 for types that are not read.
    static std::size_t size_of(std::uint32_t type) {
        constexpr std::array<std::size_t, 5> sizes = {0, 1, 0, 2, 4};
        return type < sizes.size() ? sizes[type] : 0;
    }

    std::string_view bytes_;
    bool low_first_;
    std::size_t directory_;
};

std::optional<std::string> without_lzw(std::string_view packed, std::size_t wanted) {
    constexpr unsigned first_bits = 9, max_bits = 12;
    LzwWords words(8);
    std::string output;
    std::uint32_t store = 0;
    unsigned stored = 0, width = first_bits;
    for (const char byte : packed) {
        store = store << 8 | static_cast<unsigned char>(byte);
        stored += 8;
        if (stored < width) continue;
        stored -= width;
        const std::uint32_t code = store >> stored & ((1U << width) - 1);
        if (code == words.end_code()) break;
        if (code == words.clear_code())
            words.begin();
        else if (!words.add(code, output))
            return std::nullopt;
        if (output.size() >= wanted) return output;
        // Code widths grow one code earlier than in GIF files.
        width = first_bits;
        while (width < max_bits && words.next_code() + 1 >= (1U << width)) ++width;
    }
    return std::nullopt;
}

std::optional<std::string> without_packbits(std::string_view packed, std::size_t wanted) {
    std::string output;
    while (output.size() < wanted && packed.size() > 1) {
        const int head = static_cast<signed char>(packed[0]);
        constexpr int nothing = -128;
        packed.remove_prefix(1);
        if (head == nothing) continue;
        const std::size_t count = head < 0 ? 1 : static_cast<std::size_t>(head) + 1;
        if (count > packed.size()) return std::nullopt;
        if (head < 0)
            output.append(static_cast<std::size_t>(1 - head), packed[0]);
        else
            output += packed.substr(0, count);
        packed.remove_prefix(count);
    }
    return output.size() >= wanted ? std::optional(std::move(output)) : std::nullopt;
}

std::optional<std::string> without_deflate(std::string_view packed, std::size_t wanted) {
    std::string output(wanted, '\0');
    uLongf size = wanted;
    const int result = uncompress(reinterpret_cast<Bytef*>(output.data()), &size,
                                  reinterpret_cast<const Bytef*>(packed.data()), packed.size());
    return result == Z_OK && size == wanted ? std::optional(std::move(output)) : std::nullopt;
}

std::optional<std::string> unpacked_strip(std::string_view packed, std::uint32_t packing,
                                          std::size_t wanted) {
    switch (packing) {
        case bare:
            return packed.size() >= wanted ? std::optional(std::string(packed)) : std::nullopt;
        case lzw:
            return without_lzw(packed, wanted);
        case packbits:
            return without_packbits(packed, wanted);
        default:
            return without_deflate(packed, wanted);
    }
}

/// The supported properties of a file.
struct TiffLayout {
    std::int64_t width, height, rows;  ///< `rows` per strip
    std::size_t samples, bits;
    std::uint32_t packing;
    bool differences;  ///< values are stored as differences from their left neighbours
    std::vector<std::uint32_t> table;

    std::size_t row_bytes() const { return static_cast<std::size_t>(width) * samples * bits / 8; }
};

std::optional<TiffLayout> layout_of(const TiffFile& file, std::int64_t max_pixels) {
    constexpr std::uint32_t dark_is_low = 1, colours = 2, by_table = 3, alpha_apart = 2;
    constexpr std::size_t table_size = 768;
    TiffLayout result{file.one(width_tag, 0),          file.one(height_tag, 0),
                      file.one(rows_tag, ~0U),         file.one(samples_tag, 1),
                      file.one(bits_tag, 1),           file.one(compression_tag, 1),
                      file.one(predictor_tag, 1) == 2, file.all(table_tag)};
    const std::uint32_t meaning = file.one(meaning_tag, ~0U);
    const std::vector<std::uint32_t> extra = file.all(extra_tag);
    const bool same_bits = std::ranges::all_of(
        file.all(bits_tag), [&](std::uint32_t bits) { return bits == result.bits; });
    const bool whole_numbers = std::ranges::all_of(file.all(number_kind_tag),
                                                   [](std::uint32_t kind) { return kind == 1; });
    constexpr std::array<std::uint32_t, 5> packings = {bare, lzw, deflate, packbits, old_deflate};
    const bool usual = has_size(result.width, result.height, max_pixels) &&
                       (result.bits == 8 || result.bits == 16) && same_bits && whole_numbers &&
                       std::ranges::count(packings, result.packing) == 1 &&
                       file.one(predictor_tag, 1) <= 2 && file.one(fill_order_tag, 1) == 1 &&
                       file.one(orientation_tag, 1) == 1 && file.one(planes_tag, 1) == 1 &&
                       file.all(tile_tag).empty() && result.rows > 0;
    if (!usual) return std::nullopt;
    const std::size_t usual_samples = meaning == colours ? 3 : 1;
    const bool has_alpha = extra.size() == 1 && extra[0] == alpha_apart;
    if (result.samples != usual_samples + extra.size() || (!extra.empty() && !has_alpha))
        return std::nullopt;
    if (meaning == by_table && result.bits == 8 && extra.empty() &&
        result.table.size() == table_size)
        return result;
    result.table.clear();
    return meaning == dark_is_low || meaning == colours ? std::optional(std::move(result))
                                                        : std::nullopt;
}

/// Decodes a row of values, which may be stored as differences.
std::vector<std::uint32_t> row_values(const TiffLayout& layout, bool low_first,
                                      std::string_view row) {
    const std::size_t size = layout.bits / 8;
    std::vector<std::uint32_t> values(static_cast<std::size_t>(layout.width) * layout.samples);
    const std::uint32_t mask = size == 2 ? 0xffff : 0xff;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const std::uint32_t first = byte_in(row, size * i);
        const std::uint32_t second = byte_in(row, size * i + 1);
        values[i] = size == 1 ? first : low_first ? first | second << 8 : first << 8 | second;
        if (layout.differences && i >= layout.samples)
            values[i] = (values[i] + values[i - layout.samples]) & mask;
    }
    return values;
}

void add_tiff_row(const TiffLayout& layout, const std::vector<std::uint32_t>& values,
                  StoredPicture& picture) {
    const auto value = [&](std::uint32_t number) {
        return layout.bits == 16 ? unit_value(static_cast<std::uint16_t>(number))
                                 : unit_value(static_cast<std::uint8_t>(number));
    };
    if (!layout.table.empty()) {
        constexpr std::size_t colours = 256;
        for (const std::uint32_t number : values)
            for (std::size_t channel = 0; channel < 3; ++channel)
                picture.values.push_back(unit_value(
                    static_cast<std::uint8_t>(layout.table[colours * channel + number] >> 8)));
        return;
    }
    const auto channels = static_cast<std::size_t>(picture.channels);
    for (std::size_t i = 0; i < values.size(); i += layout.samples) {
        for (std::size_t channel = 0; channel < channels; ++channel)
            picture.values.push_back(value(values[i + channel]));
        if (layout.samples > channels) picture.alpha.push_back(value(values[i + channels]));
    }
}

}  // namespace

std::optional<StoredPicture> read_tiff(std::string_view bytes, std::int64_t max_pixels) {
    const TiffFile file(bytes);
    const auto layout = layout_of(file, max_pixels);
    if (!layout) return std::nullopt;
    const std::vector<std::uint32_t> strips = file.all(strips_tag), lengths = file.all(lengths_tag);
    // Full LZW tables expand the most.
    constexpr std::size_t growth = 2560;
    const auto height = static_cast<std::size_t>(layout->height);
    if (strips.size() != lengths.size() || layout->row_bytes() * height > growth * bytes.size())
        return std::nullopt;
    StoredPicture picture;
    picture.width = static_cast<int>(layout->width);
    picture.height = static_cast<int>(layout->height);
    picture.channels = layout->samples < 3 && layout->table.empty() ? 1 : 3;
    picture.bits = static_cast<int>(layout->bits);
    picture.format = "tiff";
    std::size_t y = 0;
    for (std::size_t i = 0; i < strips.size() && y < height; ++i) {
        const std::size_t rows = std::min(height - y, static_cast<std::size_t>(layout->rows));
        if (strips[i] > bytes.size()) return std::nullopt;
        const auto strip = unpacked_strip(bytes.substr(strips[i], lengths[i]), layout->packing,
                                          rows * layout->row_bytes());
        if (!strip) return std::nullopt;
        for (std::size_t k = 0; k < rows; ++k, ++y)
            add_tiff_row(*layout,
                         row_values(*layout, file.low_first(),
                                    std::string_view(*strip).substr(k * layout->row_bytes(),
                                                                    layout->row_bytes())),
                         picture);
    }
    return y == height ? std::optional(std::move(picture)) : std::nullopt;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/gif.h"

#include "raster/bytes.h"
#include "raster/lzw.h"

#include <algorithm>
#include <array>

namespace candelabra {

namespace {

/// Removes a chain of length-prefixed blocks and returns its contents. Returns nothing if the file
/// ends within it.
std::optional<std::string> take_blocks(std::string_view& rest) {
    std::string content;
    while (!rest.empty()) {
        const std::size_t length = byte_in(rest, 0);
        if (length + 1 > rest.size()) return std::nullopt;
        content += rest.substr(1, length);
        rest.remove_prefix(length + 1);
        if (length == 0) return content;
    }
    return std::nullopt;
}

/// Removes the colour table at the front, if the flags indicate one, and returns it.
std::string_view take_table(std::string_view& rest, std::uint32_t flags) {
    constexpr std::uint32_t given = 0x80, size_bits = 7;
    if ((flags & given) == 0) return {};
    const std::string_view table = rest.substr(0, std::size_t{6} << (flags & size_bits));
    rest.remove_prefix(table.size());
    return table;
}

/// Decodes the wanted number of colour indices; they are 0 behind an early end, as in POV-Ray.
/// Returns nothing if codes are missing or wrong.
std::optional<std::string> numbers_of_codes(std::string_view codes, unsigned bits,
                                            std::size_t wanted) {
    if (bits < 2 || bits > 8) return std::nullopt;
    LzwWords words(bits);
    std::string output;
    std::uint32_t store = 0;
    unsigned stored = 0, width = bits + 1;
    constexpr unsigned max_bits = 12;
    for (const char byte : codes) {
        store |= static_cast<std::uint32_t>(static_cast<unsigned char>(byte)) << stored;
        stored += 8;
        while (stored >= width) {
            const std::uint32_t code = store & ((1U << width) - 1);
            store >>= width;
            stored -= width;
            if (code == words.end_code()) {
                output.resize(wanted);
                return output;
            }
            if (code == words.clear_code())
                words.begin();
            else if (!words.add(code, output))
                return std::nullopt;
            width = bits + 1;
            while (width < max_bits && words.next_code() >= (1U << width)) ++width;
            if (output.size() < wanted) continue;
            output.resize(wanted);  // the last word may be longer
            return output;
        }
    }
    return std::nullopt;
}

/// Returns the rows in the order of the file: sequential, or every eighth row, those between them,
/// and so on.
std::vector<int> row_order(int height, bool interlaced) {
    std::vector<int> order;
    struct Pass {
        int first, step;
    };
    constexpr std::array<Pass, 4> passes = {{{0, 8}, {4, 8}, {2, 4}, {1, 2}}};
    if (!interlaced)
        for (int y = 0; y < height; ++y) order.push_back(y);
    else
        for (const auto& [first, step] : passes)
            for (int y = first; y < height; y += step) order.push_back(y);
    return order;
}

/// Colour indices in the order of the picture's rows.
struct Indexed {
    int width, height;
    std::string_view table;
    std::string numbers;
};

std::string in_order(const std::string& stored, const std::vector<int>& rows, std::size_t width) {
    std::string result(stored.size(), '\0');
    std::size_t next = 0;
    for (const int row : rows) {
        result.replace(static_cast<std::size_t>(row) * width, width, stored, next, width);
        next += width;
    }
    return result;
}

/// Removes a picture, from after its mark. Returns nothing if it is damaged or too large.
std::optional<Indexed> take_picture(std::string_view& rest, std::string_view table,
                                    std::int64_t max_pixels) {
    constexpr std::size_t head = 9;
    constexpr std::uint32_t interlaced = 0x40;
    const auto word = [&](std::size_t at) { return static_cast<int>(low_word(rest, at)); };
    const std::uint32_t flags = byte_in(rest, 8);
    Indexed picture{word(4), word(6), table, {}};
    // With full LZW tables, a byte yields at most 2560 pixels.
    constexpr std::int64_t growth = 2560;
    if (rest.size() <= head || !has_size(picture.width, picture.height, max_pixels) ||
        std::int64_t{picture.width} * picture.height >
            growth * static_cast<std::int64_t>(rest.size()))
        return std::nullopt;
    rest.remove_prefix(head);
    const std::string_view own = take_table(rest, flags);
    if (!own.empty()) picture.table = own;
    const unsigned bits = byte_in(rest, 0);
    rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
    const auto codes = take_blocks(rest);
    const auto width = static_cast<std::size_t>(picture.width);
    const auto wanted = width * static_cast<std::size_t>(picture.height);
    const auto numbers = codes ? numbers_of_codes(*codes, bits, wanted) : std::nullopt;
    if (!numbers || picture.table.empty()) return std::nullopt;
    picture.numbers =
        in_order(*numbers, row_order(picture.height, (flags & interlaced) != 0), width);
    return picture;
}

/// The picture in colours. Those that are missing from the table are black, as in POV-Ray.
StoredPicture coloured(const Indexed& indexed, int clear) {
    StoredPicture picture;
    picture.width = indexed.width;
    picture.height = indexed.height;
    picture.format = "gif";
    picture.values.assign(3 * indexed.numbers.size(), 0);
    picture.alpha.assign(indexed.numbers.size(), 1);
    for (std::size_t pixel = 0; pixel < indexed.numbers.size(); ++pixel) {
        const std::size_t number = static_cast<unsigned char>(indexed.numbers[pixel]);
        if (static_cast<int>(number) == clear) {
            picture.alpha[pixel] = 0;
        } else if (3 * number + 3 <= indexed.table.size()) {
            for (std::size_t i = 0; i < 3; ++i)
                picture.values[3 * pixel + i] =
                    unit_value(static_cast<std::uint8_t>(byte_in(indexed.table, 3 * number + i)));
        }
    }
    // The indices cannot be recovered from the colours, since two of them may be equal.
    for (const char each : indexed.numbers)
        picture.numbers.push_back(static_cast<unsigned char>(each));
    return picture;
}

/// Returns the index of the colour that a control block makes transparent, or -1.
int clear_colour(const std::string& block) {
    return block.size() >= 4 && (block[0] & 1) != 0 ? static_cast<unsigned char>(block[3]) : -1;
}

/// What precedes the first picture of a file.
struct GifHead {
    std::string_view table;  ///< of the file
    int clear = -1;          ///< index of the transparent colour
};

/// Removes all up to the first picture, and its mark. Returns nothing if the file appears damaged.
std::optional<GifHead> take_gif_head(std::string_view& rest) {
    constexpr std::size_t head = 13;
    constexpr std::uint32_t picture_mark = ',', extension_mark = '!', control = 0xf9;
    if (rest.size() < head) return std::nullopt;
    const std::uint32_t flags = byte_in(rest, 10);
    rest.remove_prefix(head);
    GifHead found{take_table(rest, flags)};
    while (!rest.empty()) {
        const std::uint32_t mark = byte_in(rest, 0);
        rest.remove_prefix(1);
        if (mark == picture_mark) return found;
        if (mark != extension_mark) return std::nullopt;
        const std::uint32_t kind = byte_in(rest, 0);
        rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
        const auto block = take_blocks(rest);
        if (!block) return std::nullopt;
        if (kind == control) found.clear = clear_colour(*block);
    }
    return std::nullopt;
}

}  // namespace

std::optional<StoredPicture> read_gif(std::string_view bytes, std::int64_t max_pixels) {
    std::string_view rest = bytes;
    const auto head = take_gif_head(rest);
    const auto picture = head ? take_picture(rest, head->table, max_pixels) : std::nullopt;
    if (!picture) return std::nullopt;
    return coloured(*picture, head->clear);
}

GifTable gif_table(std::string_view bytes) {
    constexpr std::size_t most = 256, picture_head = 9;
    std::string_view rest = bytes;
    const auto head = take_gif_head(rest);
    if (!head || rest.size() < picture_head) return {};
    const std::uint32_t flags = byte_in(rest, 8);
    rest.remove_prefix(picture_head);
    const std::string_view own = take_table(rest, flags);
    const std::string_view colours = own.empty() ? head->table : own;
    GifTable table(most, {0, 0, 0, 255});
    for (std::size_t i = 0; 3 * i + 3 <= colours.size() && i < most; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            table[i][k] = static_cast<std::uint8_t>(byte_in(colours, 3 * i + k));
    if (head->clear >= 0) table[static_cast<std::size_t>(head->clear)][3] = 0;
    return table;
}

}  // namespace candelabra

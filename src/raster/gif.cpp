// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster/gif.h"

#include "raster/bytes.h"
#include "raster/lzw.h"

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

/// Decodes the wanted number of colour indices. Returns nothing if there are fewer.
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
            if (code == words.end_code()) return std::nullopt;
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

/// A picture placed on the canvas.
struct Placed {
    int x, y, width, height;
    bool interlaced;
    std::string_view table;
    int clear = -1;  ///< index of the transparent colour
    std::string numbers;
};

/// Paints the picture. Returns false if a colour is missing from the table.
bool paint(const Placed& placed, StoredPicture& picture) {
    const std::vector<int> order = row_order(placed.height, placed.interlaced);
    std::size_t next = 0;
    for (const int row : order)
        for (int column = 0; column < placed.width; ++column) {
            const std::size_t number = static_cast<unsigned char>(placed.numbers[next++]);
            if (static_cast<int>(number) == placed.clear) continue;
            if (3 * number + 3 > placed.table.size()) return false;
            const auto pixel =
                static_cast<std::size_t>(placed.y + row) * static_cast<std::size_t>(picture.width) +
                static_cast<std::size_t>(placed.x + column);
            for (std::size_t i = 0; i < 3; ++i)
                picture.values[3 * pixel + i] =
                    unit_value(static_cast<std::uint8_t>(byte_in(placed.table, 3 * number + i)));
            picture.alpha[pixel] = 1;
        }
    return true;
}

/// Whether all pixels of the canvas have a colour of the file's global table.
bool covers(const Placed& placed, std::string_view table, const StoredPicture& canvas) {
    return placed.table.data() == table.data() && placed.clear < 0 &&
           placed.width == canvas.width && placed.height == canvas.height;
}

/// Records the colour indices, which cannot be recovered from the colours, since two of them may be
/// equal.
void note_numbers(const Placed& placed, StoredPicture& canvas) {
    const auto width = static_cast<std::size_t>(canvas.width);
    canvas.numbers.resize(placed.numbers.size());
    std::size_t next = 0;
    for (const int row : row_order(placed.height, placed.interlaced))
        for (std::size_t x = 0; x < width; ++x)
            canvas.numbers[static_cast<std::size_t>(row) * width + x] =
                static_cast<unsigned char>(placed.numbers[next++]);
}

/// Removes a picture, from after its mark. Returns nothing if it does not lie on the canvas or is
/// damaged.
std::optional<Placed> take_picture(std::string_view& rest, std::string_view table, int clear,
                                   const StoredPicture& canvas) {
    constexpr std::size_t head = 9;
    constexpr std::uint32_t interlaced = 0x40;
    const auto word = [&](std::size_t at) { return static_cast<int>(low_word(rest, at)); };
    const std::uint32_t flags = byte_in(rest, 8);
    Placed placed{word(0), word(2), word(4), word(6), (flags & interlaced) != 0, table, clear, {}};
    if (rest.size() <= head || placed.x + placed.width > canvas.width ||
        placed.y + placed.height > canvas.height)
        return std::nullopt;
    rest.remove_prefix(head);
    const std::string_view own = take_table(rest, flags);
    if (!own.empty()) placed.table = own;
    const unsigned bits = byte_in(rest, 0);
    rest.remove_prefix(std::min<std::size_t>(1, rest.size()));
    const auto codes = take_blocks(rest);
    const auto wanted =
        static_cast<std::size_t>(placed.width) * static_cast<std::size_t>(placed.height);
    auto numbers = codes ? numbers_of_codes(*codes, bits, wanted) : std::nullopt;
    if (!numbers) return std::nullopt;
    placed.numbers = std::move(*numbers);
    return placed;
}

/// Returns the index of the colour that a control block makes transparent, or -1.
int clear_colour(const std::string& block) {
    return block.size() >= 4 && (block[0] & 1) != 0 ? static_cast<unsigned char>(block[3]) : -1;
}

}  // namespace

std::optional<StoredPicture> read_gif(std::string_view bytes, std::int64_t max_pixels) {
    constexpr std::size_t head = 13;
    constexpr std::uint32_t picture_mark = ',', extension_mark = '!', control = 0xf9;
    StoredPicture canvas;
    canvas.width = static_cast<int>(low_word(bytes, 6));
    canvas.height = static_cast<int>(low_word(bytes, 8));
    canvas.format = "gif";
    // With full LZW tables, a byte yields at most 2560 pixels.
    constexpr std::int64_t growth = 2560;
    if (bytes.size() < head || !has_size(canvas.width, canvas.height, max_pixels) ||
        std::int64_t{canvas.width} * canvas.height >
            growth * static_cast<std::int64_t>(bytes.size()))
        return std::nullopt;
    std::string_view rest = bytes.substr(head);
    const std::string_view table = take_table(rest, byte_in(bytes, 10));
    int clear = -1;
    while (!rest.empty()) {
        const std::uint32_t mark = byte_in(rest, 0);
        if (mark == picture_mark) {
            rest.remove_prefix(1);
            const auto placed = take_picture(rest, table, clear, canvas);
            if (!placed) return std::nullopt;
            const auto pixels =
                static_cast<std::size_t>(canvas.width) * static_cast<std::size_t>(canvas.height);
            canvas.values.assign(3 * pixels, 0);
            canvas.alpha.assign(pixels, 0);
            if (!paint(*placed, canvas)) return std::nullopt;
            if (covers(*placed, table, canvas)) note_numbers(*placed, canvas);
            return canvas;
        }
        if (mark != extension_mark) return std::nullopt;
        const std::uint32_t kind = byte_in(rest, 1);
        rest.remove_prefix(std::min<std::size_t>(2, rest.size()));
        const auto block = take_blocks(rest);
        if (!block) return std::nullopt;
        if (kind == control) clear = clear_colour(*block);
    }
    return std::nullopt;
}

}  // namespace candelabra

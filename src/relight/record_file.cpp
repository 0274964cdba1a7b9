// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/record_file.h"

#include "base/parallel.h"
#include "relight/byte_stream.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"
#include "text/sha256.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include <zlib.h>

namespace candelabra {

namespace {

constexpr std::string_view magic = "CANDLAMP";
constexpr std::uint32_t version = 1;
constexpr std::size_t digest_bytes = 64;  // hexadecimal
constexpr std::uint64_t most_pixels = std::uint64_t{1} << 28;
constexpr std::uint32_t most_lamps = std::uint32_t{1} << 30;
/// Most bytes that the blocks of a file of so many bytes may have together when they are unpacked.
/// The files of this program unpack to a few times their size; a dark picture to more, of little.
std::uint64_t most_unpacked(std::size_t file_bytes) {
    constexpr std::uint64_t small_file = std::uint64_t{1} << 28, factor = 128;
    return small_file + factor * file_bytes;
}

/// Returns a block with the bytes.
std::string block_of(const std::string& raw) {
    constexpr int fast = 1;
    uLongf size = compressBound(static_cast<uLong>(raw.size()));
    std::string packed(size, '\0');
    compress2(reinterpret_cast<Bytef*>(packed.data()), &size,
              reinterpret_cast<const Bytef*>(raw.data()), static_cast<uLong>(raw.size()), fast);
    packed.resize(size);
    std::string block;
    append_number(block, static_cast<std::uint64_t>(raw.size()));
    append_number(block, static_cast<std::uint64_t>(packed.size()));
    return block + packed;
}

/// Takes a block from the front of the bytes, and its size from `left`, which blocks may still
/// have. Returns nothing if there is none of at most that size.
std::optional<std::string> take_block(ByteReader& reader, std::uint64_t& left) {
    const auto size = reader.number<std::uint64_t>(), packed_size = reader.number<std::uint64_t>();
    const std::string_view packed = reader.take(packed_size);
    if (!reader.good() || size > left) return std::nullopt;
    left -= size;
    std::string raw(static_cast<std::size_t>(size), '\0');
    auto made = static_cast<uLongf>(size);
    const int result = uncompress(reinterpret_cast<Bytef*>(raw.data()), &made,
                                  reinterpret_cast<const Bytef*>(packed.data()),
                                  static_cast<uLong>(packed.size()));
    if (result != Z_OK || made != size) return std::nullopt;
    return raw;
}

void append_text(std::string& bytes, const std::string& text) {
    append_number(bytes, static_cast<std::uint32_t>(text.size()));
    bytes += text;
}

std::string head_of(const LightRecords& records) {
    std::string head;
    append_number(head, static_cast<std::uint32_t>(records.width));
    append_number(head, static_cast<std::uint32_t>(records.height));
    append_text(head, records.origin);
    append_text(head, records.film);
    append_number(head, static_cast<std::uint32_t>(records.lamps.groups().size()));
    for (const LampGroup& group : records.lamps.groups()) {
        append_text(head, group.name);
        append_number(head, group.lamps);
    }
    append_number(head, records.lamps.size());
    for (const std::uint32_t number : records.lamps.numbers()) append_number(head, number);
    for (const float power : records.lamps.powers()) append_float(head, power);
    return head;
}

std::string text_from(ByteReader& reader) {
    return std::string(reader.take(reader.number<std::uint32_t>()));
}

bool take_lamps(ByteReader& reader, LampList& lamps) {
    const auto count = reader.number<std::uint32_t>();
    constexpr std::size_t least_group = 8, lamp_bytes = 8;
    if (!reader.has(count, least_group)) return false;
    std::vector<LampGroup> groups;
    for (std::uint32_t i = 0; i < count && reader.good(); ++i) {
        std::string name = text_from(reader);
        groups.push_back({std::move(name), reader.number<std::uint32_t>()});
    }
    const auto size = reader.number<std::uint32_t>();
    if (size > most_lamps || !reader.has(size, lamp_bytes)) return false;
    std::vector<std::uint32_t> numbers(size);
    std::vector<float> powers(size);
    for (std::uint32_t& number : numbers) number = reader.number<std::uint32_t>();
    for (float& power : powers) power = reader.real();
    const auto usable = [](float power) { return power >= 1e-12F && power <= 1e12F; };
    if (!reader.good() || !std::ranges::all_of(powers, usable) || !are_numbers_of(groups, numbers))
        return false;
    lamps = LampList(std::move(groups), std::move(numbers), std::move(powers));
    return true;
}

bool take_head(const std::string& raw, LightRecords& records) {
    ByteReader reader(raw);
    const auto width = reader.number<std::uint32_t>(), height = reader.number<std::uint32_t>();
    if (width == 0 || height == 0 || width > most_pixels || height > most_pixels / width)
        return false;
    records.width = static_cast<int>(width);
    records.height = static_cast<int>(height);
    records.origin = text_from(reader);
    records.film = text_from(reader);
    return take_lamps(reader, records.lamps) && reader.left().empty();
}

bool take_alpha(const std::string& raw, LightRecords& records) {
    if (raw.empty()) return true;
    const auto pixels =
        static_cast<std::size_t>(records.width) * static_cast<std::size_t>(records.height);
    if (raw.size() != sizeof(float) * pixels) return false;
    ByteReader reader(raw);
    for (std::size_t i = 0; i < pixels; ++i) {
        const float alpha = reader.real();
        if (!(alpha >= 0 && alpha <= 1)) return false;
        records.alpha.push_back(alpha);
    }
    return true;
}

bool take_row(const std::string& raw, LightRecords& records) {
    std::string_view bytes = raw;
    for (int column = 0; column < records.tiles_across(); ++column) {
        auto tile = take_tile(bytes, records.lamps.size());
        if (!tile) return false;
        records.tiles.push_back(std::move(*tile));
    }
    return bytes.empty();
}

}  // namespace

std::uint64_t record_overhead(int width, int height, bool alpha) {
    // The origin and the film are texts; zlib adds a little to what it cannot pack.
    constexpr std::uint64_t texts = 16384, of_row = 64, of_alpha = sizeof(float) + 1;
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    return texts + of_row * static_cast<std::uint64_t>(height / light_tile + 1) +
           (alpha ? of_alpha * pixels : 0);
}

std::string encode(const LightRecords& records, int threads) {
    std::string bytes(magic);
    append_number(bytes, version);
    std::string alpha;
    for (const float value : records.alpha) append_float(alpha, value);
    const auto across = static_cast<std::size_t>(records.tiles_across());
    std::vector<std::string> blocks(static_cast<std::size_t>(records.tiles_down()));
    run_parallel(blocks.size(), threads, [&](std::size_t row) {
        std::string raw;
        for (std::size_t i = 0; i < across; ++i) append_tile(raw, records.tiles[row * across + i]);
        blocks[row] = block_of(raw);
    });
    blocks.insert(blocks.begin(), {block_of(head_of(records)), block_of(alpha)});
    std::uint64_t size = 0;
    for (const std::string& block : blocks) size += block.size();
    append_number(bytes, size);
    bytes.reserve(bytes.size() + static_cast<std::size_t>(size) + digest_bytes);
    for (const std::string& block : blocks) bytes += block;
    return bytes + sha256(bytes);
}

std::optional<LightRecords> decode_records(std::string_view bytes, std::string& problem) {
    const auto fail = [&](std::string why) {
        problem = std::move(why);
        return std::nullopt;
    };
    ByteReader reader(bytes);
    if (reader.take(magic.size()) != magic) return fail("does not keep the light of lamps");
    if (const auto made_by = reader.number<std::uint32_t>(); reader.good() && made_by != version)
        return fail(
            message("is of version ", made_by, " of its format, and this program reads ", version));
    const auto size = reader.number<std::uint64_t>();
    const std::string_view rest = reader.take(size);
    if (!reader.good() || reader.left().size() != digest_bytes) return fail("is not whole");
    if (sha256(bytes.substr(0, bytes.size() - digest_bytes)) != reader.left())
        return fail("is damaged: its bytes are not those that it had");
    ByteReader blocks(rest);
    std::uint64_t left = most_unpacked(bytes.size());
    LightRecords records;
    const auto head = take_block(blocks, left);
    if (!head || !take_head(*head, records)) return fail("has no lamps that are possible");
    const auto alpha = take_block(blocks, left);
    if (!alpha || !take_alpha(*alpha, records))
        return fail("has no alpha channel that is possible");
    for (int row = 0; row < records.tiles_down(); ++row) {
        const auto raw = take_block(blocks, left);
        if (!raw || !take_row(*raw, records)) return fail("has tiles that are not possible");
    }
    if (!blocks.left().empty()) return fail("has more than its tiles");
    return records;
}

std::optional<LightRecords> read_records(const std::string& path, Diagnostics& diagnostics) {
    const auto fail = [&](const std::string& why) {
        diagnostics.add(error(Fault::io, {}, message("`", printable(path), "` ", why))
                            .with_help("render a picture with --keep-lights FILE"));
        return std::nullopt;
    };
    const auto bytes = content_of_file(path);
    if (!bytes) return fail("cannot be read");
    std::string problem;
    auto records = decode_records(*bytes, problem);
    if (!records) return fail(problem);
    return records;
}

}  // namespace candelabra

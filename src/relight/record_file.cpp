// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/record_file.h"

#include "base/parallel.h"
#include "relight/byte_stream.h"
#include "relight/record_blocks.h"
#include "text/message.h"
#include "text/opened_file.h"
#include "text/printable.h"
#include "text/sha256.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

constexpr std::string_view magic = "CANDLAMP";
constexpr std::uint32_t version = 3;
constexpr std::size_t digest_bytes = 64;  // hexadecimal
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
    constexpr std::uint64_t texts = 16384, of_row = 64, of_alpha = sizeof(float) + 1,
                            of_normal = 3 + 1;
    const auto pixels = static_cast<std::uint64_t>(width) * static_cast<std::uint64_t>(height);
    return texts + of_row * static_cast<std::uint64_t>(height / light_tile + 1) +
           (of_normal + (alpha ? of_alpha : 0)) * pixels;
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
    blocks.insert(blocks.begin(), {block_of(head_of(records)), block_of(meters_of(records.meters)),
                                   block_of(alpha), block_of(normals_of(records.normals))});
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
    const auto meters = take_block(blocks, left);
    if (!meters || !take_meters(*meters, records.lamps.size(), records.meters))
        return fail("has no meters that are possible");
    const auto alpha = take_block(blocks, left);
    if (!alpha || !take_alpha(*alpha, records))
        return fail("has no alpha channel that is possible");
    const auto normals = take_block(blocks, left);
    if (!normals || !take_normals(*normals, records))
        return fail("has no normals that are possible");
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/fseq.h"

#include "relight/byte_stream.h"
#include "relight/light_show.h"
#include "text/message.h"

#include <array>

#include <zlib.h>

namespace candelabra {

namespace {

constexpr std::size_t head_bytes = 32, block_bytes = 8, range_bytes = 6;
constexpr std::uint64_t most_channel_bytes = std::uint64_t{1} << 33;
constexpr std::uint64_t most_deflation = 1032;

/// The head of a file of version 2.
struct FseqHead {
    std::uint16_t data = 0;  ///< where the channels begin
    std::uint8_t major = 0;
    std::uint32_t channels = 0, frames = 0;
    std::uint8_t step = 0;
    unsigned compression = 0, blocks = 0, ranges = 0;
};

FseqHead fseq_head(ByteReader& reader) {
    FseqHead head;
    reader.take(4);
    head.data = reader.number<std::uint16_t>();
    reader.number<std::uint8_t>();  // the minor version
    head.major = reader.number<std::uint8_t>();
    reader.number<std::uint16_t>();
    head.channels = reader.number<std::uint32_t>();
    head.frames = reader.number<std::uint32_t>();
    head.step = reader.number<std::uint8_t>();
    reader.number<std::uint8_t>();  // flags
    const unsigned form = reader.number<std::uint8_t>();
    head.compression = form & 0xFU;
    head.blocks = reader.number<std::uint8_t>() | (form >> 4) << 8;
    head.ranges = reader.number<std::uint8_t>();
    return head;
}

/// Appends the content of a zlib or gzip stream, which must be `size` bytes.
bool inflate_block(std::string_view packed, std::size_t size, std::string& bytes) {
    const std::size_t before = bytes.size();
    bytes.resize(before + size);
    z_stream stream{};
    constexpr int any_head = 32 + MAX_WBITS;
    if (inflateInit2(&stream, any_head) != Z_OK) return false;
    std::string input(packed);  // zlib takes no constant input
    stream.next_in = reinterpret_cast<Bytef*>(input.data());
    stream.avail_in = static_cast<uInt>(input.size());
    stream.next_out = reinterpret_cast<Bytef*>(bytes.data() + before);
    stream.avail_out = static_cast<uInt>(size);
    const int result = inflate(&stream, Z_FINISH);
    inflateEnd(&stream);
    return result == Z_STREAM_END && stream.avail_out == 0;
}

/// Unpacks the blocks, each of which has whole frames.
bool take_fseq_blocks(const FseqHead& head, ByteReader table, std::string_view data,
                      std::string& bytes) {
    struct Block {
        std::uint32_t frame, size;
    };
    std::vector<Block> blocks;
    for (unsigned i = 0; i < head.blocks; ++i) {
        const Block block{table.number<std::uint32_t>(), table.number<std::uint32_t>()};
        if (block.size > 0) blocks.push_back(block);
    }
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        const std::uint32_t next = i + 1 < blocks.size() ? blocks[i + 1].frame : head.frames;
        if (blocks[i].size > data.size() || next <= blocks[i].frame || next > head.frames ||
            blocks[i].frame * std::uint64_t{head.channels} != bytes.size())
            return false;
        const std::uint64_t size = std::uint64_t{next - blocks[i].frame} * head.channels;
        constexpr std::uint64_t most_block = std::uint64_t{1} << 31;
        if (size > most_block || size > (blocks[i].size + std::uint64_t{1}) * most_deflation ||
            !inflate_block(data.substr(0, blocks[i].size), static_cast<std::size_t>(size), bytes))
            return false;
        data.remove_prefix(blocks[i].size);
    }
    return bytes.size() == std::uint64_t{head.frames} * head.channels;
}

bool take_fseq_ranges(const FseqHead& head, ByteReader& reader, ChannelData& made) {
    std::uint64_t sum = 0;
    for (unsigned i = 0; i < head.ranges; ++i) {
        std::array<std::uint32_t, 2> numbers{};
        for (std::uint32_t& number : numbers)
            for (int byte = 0; byte < 3; ++byte)
                number |= std::uint32_t{reader.number<std::uint8_t>()} << (8 * byte);
        made.ranges.emplace_back(numbers[0], numbers[1]);
        sum += numbers[1];
    }
    return head.ranges == 0 || sum == head.channels;
}

}  // namespace

std::optional<ChannelData> read_fseq(std::string_view bytes, std::string& problem,
                                     std::string& way_out) {
    const auto fail = [&](std::string why, std::string help = {}) {
        problem = std::move(why);
        way_out = std::move(help);
        return std::nullopt;
    };
    if (bytes.starts_with("ESEQ") || bytes.starts_with("FSEQ"))
        return fail("is a file of effects, and not of frames", "export an FSEQ file of version 2");
    if (!bytes.starts_with("PSEQ")) return fail("is no FSEQ file");
    if (bytes.size() < head_bytes) return fail("is not whole");
    ByteReader reader(bytes.substr(0, head_bytes));
    const FseqHead head = fseq_head(reader);
    if (head.major != 2)
        return fail(message("is an FSEQ file of version ", unsigned{head.major}),
                    "in xLights, File > Preferences > Sequences: FSEQ version V2 zlib or "
                    "uncompressed, then save again");
    if (head.compression == 1)
        return fail("is compressed by zstd",
                    "in xLights, File > Preferences > Sequences: FSEQ version V2 zlib or "
                    "uncompressed, then save again");
    if (head.compression > 2) return fail("is compressed in an unknown way");
    const std::size_t tables = block_bytes * head.blocks + range_bytes * head.ranges;
    const std::uint64_t size = std::uint64_t{head.channels} * head.frames;
    if (head.channels == 0 || head.frames == 0) return fail("has no frames");
    if (bytes.size() - head_bytes < tables || head.data > bytes.size()) return fail("is not whole");
    if (size > most_channel_bytes || head.frames > most_show_frames)
        return fail("has more frames and channels than can be read");
    const std::string_view data = bytes.substr(head.data);
    ChannelData made;
    made.channels = head.channels;
    made.step = head.step;
    ByteReader blocks(bytes.substr(head_bytes, block_bytes * head.blocks));
    ByteReader ranges(bytes.substr(head_bytes + block_bytes * head.blocks));
    if (!take_fseq_ranges(head, ranges, made))
        return fail("is damaged: its ranges of channels are not those of a frame");
    if (head.compression == 0) {
        if (data.size() < size) return fail("is not whole");
        made.bytes = data.substr(0, static_cast<std::size_t>(size));
    } else if (!take_fseq_blocks(head, blocks, data, made.bytes)) {
        return fail("is damaged: its frames cannot be unpacked");
    }
    return made;
}

}  // namespace candelabra

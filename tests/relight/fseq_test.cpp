// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/fseq.h"

#include "base/random.h"
#include "relight/byte_stream.h"

#include <catch2/catch.hpp>

#include <zlib.h>

namespace candelabra {

namespace {

/// A file of version 2 as its format is described: 4 channels, 3 frames, 25 ms.
struct FseqFile {
    std::string content = "abcdefghijkl";
    unsigned compression = 0, major = 2;
    std::vector<std::pair<std::uint32_t, std::uint32_t>> ranges;
    bool unused_block = false;

    static std::string packed(std::string_view text) {
        uLongf size = compressBound(text.size());
        std::string made(size, '\0');
        compress(reinterpret_cast<Bytef*>(made.data()), &size,
                 reinterpret_cast<const Bytef*>(text.data()), text.size());
        made.resize(size);
        return made;
    }

    std::string bytes() const {
        std::string table, data = content;
        unsigned blocks = 0;
        if (compression == 2) {
            // Two blocks, of one frame and of two.
            const std::string first = packed(std::string_view(content).substr(0, 4)),
                              second = packed(std::string_view(content).substr(4));
            data = first + second;
            for (const auto& [frame, size] : {std::pair(0U, first.size()), {1U, second.size()}}) {
                append_number(table, frame);
                append_number(table, static_cast<std::uint32_t>(size));
            }
            blocks = 2;
            if (unused_block) table += std::string(8, '\0');
            blocks += unused_block ? 1 : 0;
        }
        for (const auto& [first, count] : ranges)
            for (const std::uint32_t number : {first, count})
                for (int byte = 0; byte < 3; ++byte)
                    table += static_cast<char>(number >> (8 * byte));
        std::string head = "PSEQ";
        const auto end = static_cast<std::uint16_t>(32 + table.size());
        append_number(head, static_cast<std::uint16_t>(end + 8));  // a variable header lies between
        append_number(head, std::uint8_t{0});
        append_number(head, static_cast<std::uint8_t>(major));
        append_number(head, end);
        append_number(head, std::uint32_t{4});
        append_number(head, std::uint32_t{3});
        append_number(head, std::uint8_t{25});
        append_number(head, std::uint8_t{0});
        append_number(head, static_cast<std::uint8_t>(compression));
        append_number(head, static_cast<std::uint8_t>(blocks));
        append_number(head, static_cast<std::uint8_t>(ranges.size()));
        append_number(head, std::uint8_t{0});
        append_number(head, std::uint64_t{7});
        return head + table + std::string("\x08\0spabcd", 8) + data;
    }
};

std::string said_of(const std::string& bytes) {
    std::string problem, way_out;
    return read_fseq(bytes, problem, way_out) ? "none" : problem;
}

}  // namespace

TEST_CASE("frames of FSEQ files are read, plain and packed", "[relight]") {
    for (const unsigned compression : {0U, 2U})
        for (const bool unused : {false, true}) {
            FseqFile file;
            file.compression = compression;
            file.unused_block = unused;
            std::string problem, way_out;
            const auto data = read_fseq(file.bytes(), problem, way_out);
            REQUIRE(data);
            CHECK(data->channels == 4);
            CHECK(data->frames() == 3);
            CHECK(data->step == 25);
            CHECK(data->ranges.empty());
            CHECK(data->bytes == file.content);
        }
    FseqFile sparse;
    sparse.ranges = {{10, 3}, {100, 1}};
    std::string problem, way_out;
    const auto data = read_fseq(sparse.bytes(), problem, way_out);
    REQUIRE(data);
    CHECK(data->ranges == sparse.ranges);
    CHECK(data->bytes == sparse.content);
}

TEST_CASE("FSEQ files that are not read have a way out", "[relight]") {
    FseqFile file;
    CHECK(said_of("PNG") == "is no FSEQ file");
    CHECK(said_of("ESEQ" + file.bytes().substr(4)) == "is a file of effects, and not of frames");
    file.major = 1;
    CHECK(said_of(file.bytes()) == "is an FSEQ file of version 1");
    file = FseqFile();
    file.compression = 1;
    std::string problem, way_out;
    CHECK_FALSE(read_fseq(file.bytes(), problem, way_out));
    CHECK(problem == "is compressed by zstd");
    CHECK(way_out.find("uncompressed") != std::string::npos);
    file.compression = 3;
    CHECK(said_of(file.bytes()) == "is compressed in an unknown way");
    file = FseqFile();
    file.ranges = {{0, 3}};
    CHECK(said_of(file.bytes()).find("ranges of channels") != std::string::npos);
}

TEST_CASE("damaged FSEQ files are refused, or have whole frames", "[relight]") {
    for (const unsigned compression : {0U, 2U}) {
        FseqFile file;
        file.compression = compression;
        file.ranges = {{1, 4}};
        const std::string bytes = file.bytes();
        for (std::size_t size = 0; size < bytes.size(); ++size)
            REQUIRE(said_of(bytes.substr(0, size)) != "none");
        for (std::uint64_t i = 0; i < 4000; ++i) {
            std::string altered = bytes;
            for (std::uint64_t j = 0; j <= i % 3; ++j) {
                const std::uint64_t random = mix(3 * i + j + 1);
                altered[random % altered.size()] = static_cast<char>(random >> 32);
            }
            std::string problem, way_out;
            const auto data = read_fseq(altered, problem, way_out);
            if (data) REQUIRE(data->bytes.size() == data->frames() * data->channels);
        }
    }
}

}  // namespace candelabra

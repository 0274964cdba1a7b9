// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/record_file.h"

#include "base/random.h"
#include "relight/relighting.h"
#include "support/folder.h"
#include "text/sha256.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

LightRecords file_records() {
    LightRecords records;
    records.width = 17;
    records.height = 9;
    records.lamps = LampList({{"A", 1}, {"B", 2}}, {0, 1, 0}, {1, 0.5F, 2});
    records.origin = "a scene";
    records.film = "film on";
    records.alpha.assign(17 * 9, 0.25F);
    records.normals.assign(3 * 17 * 9, -127);
    records.meters.nodes = {{0, 2}, {2, 3}};
    records.meters.meters = {
        {"M", "illuminance", "lx", {{1, 2, 3}}, {0.5F}, {1, 2, 3, 4, 5, 6}}};
    records.tiles.resize(6);
    std::vector<TilePlanes> light(1);
    light[0].fill(2);
    records.tiles[3].nodes = {{0, 3}};
    records.tiles[3].own = {{1, 9, false, {1, 0, 0}}};
    records.tiles[3].residual = {{2, 10, false, {4, 4, 4}}};
    round_to_file(records.tiles[3], light);
    return records;
}

std::string problem_of(const std::string& bytes) {
    std::string problem;
    return decode_records(bytes, problem) ? "none" : problem;
}

}  // namespace

TEST_CASE("records are read as they were written", "[relight]") {
    const LightRecords records = file_records();
    const std::string bytes = encode(records, 1);
    CHECK(encode(records, 2) == bytes);
    std::string problem;
    const auto read = decode_records(bytes, problem);
    REQUIRE(read);
    CHECK(*read == records);
    Folder folder;
    folder.put("a.lights", bytes);
    Diagnostics diagnostics;
    REQUIRE(read_records(folder / "a.lights", diagnostics));
    CHECK_FALSE(read_records(folder / "none.lights", diagnostics));
    CHECK(diagnostics.all().back().message.find("cannot be read") != std::string::npos);
}

TEST_CASE("files that keep no light are refused", "[relight]") {
    const std::string bytes = encode(file_records(), 1);
    CHECK(problem_of("") == "does not keep the light of lamps");
    CHECK(problem_of("P6 1 1 255 abc") == "does not keep the light of lamps");
    CHECK(problem_of(bytes.substr(0, bytes.size() - 1)) == "is not whole");
    CHECK(problem_of(bytes + "a") == "is not whole");
    std::string later = bytes;
    later[8] = 4;
    CHECK(problem_of(later).find("is of version 4") == 0);
    std::string altered = bytes;
    altered[bytes.size() / 2] ^= 1;
    CHECK(problem_of(altered).find("is damaged") == 0);
    for (std::size_t size = 0; size < bytes.size(); ++size)
        REQUIRE(problem_of(bytes.substr(0, size)) != "none");
}

TEST_CASE("blocks that unpack to more than a file can need are refused", "[relight]") {
    const std::string bytes = encode(file_records(), 1);
    std::string content = bytes.substr(0, bytes.size() - 64);
    const std::size_t size_of_head = 20;
    content[size_of_head + 4] = 1;  // 4 GB more than it has
    CHECK(problem_of(content + sha256(content)) == "has no lamps that are possible");
}

TEST_CASE("a file with a right digest may still be anything", "[relight]") {
    const std::string bytes = encode(file_records(), 1);
    const std::string content = bytes.substr(0, bytes.size() - 64);
    for (std::uint64_t i = 0; i < 3000; ++i) {
        std::string altered = content;
        for (std::uint64_t j = 0; j <= i % 3; ++j) {
            const std::uint64_t random = mix(3 * i + j + 1);
            altered[random % altered.size()] = static_cast<char>(random >> 32);
        }
        std::string problem;
        const auto records = decode_records(altered + sha256(altered), problem);
        if (!records) continue;
        REQUIRE(records->tiles.size() ==
                static_cast<std::size_t>(records->tiles_across() * records->tiles_down()));
        const std::vector<Rgb> usual(records->lamps.size(), Rgb(1));
        REQUIRE(relit(*records, usual, 1).pixels.size() > 0);
        REQUIRE(Relighting(*records, 4, 1).picture(usual).pixels.size() > 0);
    }
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "relight/record_blocks.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("blocks come back as they were, within their room", "[relight]") {
    const std::string raw(1000, 'x');
    const std::string bytes = block_of(raw) + block_of("");
    ByteReader reader(bytes);
    std::uint64_t left = 1500;
    CHECK(take_block(reader, left) == raw);
    CHECK(left == 500);
    CHECK(take_block(reader, left) == "");
    CHECK_FALSE(take_block(reader, left));
    ByteReader again(bytes);
    left = 999;
    CHECK_FALSE(take_block(again, left));
}

TEST_CASE("meters that are not possible are refused", "[relight]") {
    KeptMeters made;
    made.nodes = {{0, 1}, {1, 3}};
    made.meters = {{"M", "illuminance", "lx", {{1, 2, 3}}, {0.5F}, {1, 2, 3, 4, 5, 6}},
                   {"", "luminance", "cd/m2", {}, {}, {}}};
    const std::string bytes = meters_of(made);
    KeptMeters read;
    REQUIRE(take_meters(bytes, 3, read));
    CHECK(read == made);
    CHECK_FALSE(take_meters(bytes, 2, read));
    CHECK_FALSE(take_meters(bytes + "x", 3, read));
    for (std::size_t size = 0; size < bytes.size(); ++size) {
        KeptMeters part;
        REQUIRE_FALSE(take_meters(bytes.substr(0, size), 3, part));
    }
}

}  // namespace candelabra

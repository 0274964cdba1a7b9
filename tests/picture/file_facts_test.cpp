// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture/file_facts.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

using namespace std::string_literals;

FileFacts facts_of(const std::string& content) { return file_facts({"a.bin", content}); }

/// A PNG file of indexed colours up to its pixels, without checksums.
const std::string start = "\x89PNG\r\n\x1a\n\0\0\0\x0dIHDR\0\0\0\1\0\0\0\1\x08\x03\0\0\0...."s;
const std::string table = "\0\0\0\6PLTE\1\2\3\4\5\6...."s, clear = "\0\0\0\1tRNS\x80...."s,
                  gamma_chunk = "\0\0\0\4gAMA\0\0\1\0...."s, pixels = "\0\0\0\1IDAT....."s;

}  // namespace

TEST_CASE("the table of a PNG file is found, with its alpha", "[picture]") {
    const FileFacts facts = facts_of(start + table + clear + pixels);
    REQUIRE(facts.table.size() == 2);
    CHECK(facts.table[0] == std::array<std::uint8_t, 4>{1, 2, 3, 128});
    CHECK(facts.table[1] == std::array<std::uint8_t, 4>{4, 5, 6, 255});
    CHECK(facts.says_coding == false);
    const std::array<float, 3> second = {4 / 255.0F, 5 / 255.0F, 6 / 255.0F};
    const ColourNumbers number_in(facts);
    CHECK(number_in(second, 1) == 1);
    CHECK(number_in(second, 0.5F) == 2);
}

TEST_CASE("a PNG file that says its gamma says its coding", "[picture]") {
    CHECK(facts_of(start + gamma_chunk + pixels).says_coding == true);
    CHECK(facts_of(start + pixels + gamma_chunk).says_coding == false);
}

TEST_CASE("the table of a GIF file follows its header", "[picture]") {
    const FileFacts facts = facts_of("GIF89a\1\0\1\0\x80\0\0\1\2\3\4\5\6,\0\0\0\0\1\0\1\0\0"s);
    // Colours that are missing from it are black.
    REQUIRE(facts.table.size() == 256);
    CHECK(facts.table[1] == std::array<std::uint8_t, 4>{4, 5, 6, 255});
    CHECK(facts.table[2] == std::array<std::uint8_t, 4>{0, 0, 0, 255});
    CHECK_FALSE(facts.says_coding);
}

TEST_CASE("other files, broken ones and empty ones say nothing", "[picture]") {
    CHECK(facts_of("P6").table.empty());
    CHECK(facts_of(start + "\xff\xff\xff\xffPLTE\1\2\3"s).table.size() == 1);
    CHECK(facts_of("\x89PNG").table.empty());
    CHECK(facts_of("").table.empty());
}

}  // namespace candelabra

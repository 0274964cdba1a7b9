// SPDX-License-Identifier: GPL-3.0-or-later
#include "vocabulary/words.h"

#include <catch2/catch.hpp>

#include <set>

namespace candelabra {

TEST_CASE("each reserved word is there once", "[vocabulary]") {
    std::set<std::string_view> seen;
    for (const Word& word : reserved_words()) {
        INFO(word.spelling);
        CHECK(seen.insert(word.spelling).second);
        CHECK(word.word_class != WordClass::name);
    }
    CHECK(seen.size() == 498);
}

TEST_CASE("words have these classes", "[vocabulary]") {
    const Names names;
    const auto [spelling, word_class] = GENERATE(table<std::string, WordClass>({
        {"sphere", WordClass::word},
        {"texture", WordClass::layer},
        {"sin", WordClass::unary_function},
        {"vrotate", WordClass::function},
        {"pi", WordClass::constant},
        {"colour", WordClass::colour},
        {"srgbft", WordClass::colour_prefix},
        {"transmit", WordClass::channel},
        {"array", WordClass::array},
        {"function", WordClass::function_literal},
        {"declare", WordClass::directive},
    }));
    INFO(spelling);
    REQUIRE(names.find(spelling) != no_name);
    CHECK(names.word_class(names.find(spelling)) == word_class);
    CHECK(names.reserved(names.find(spelling)));
}

TEST_CASE("names are interned beside the words", "[vocabulary]") {
    Names names;
    CHECK(names.find("light_octree") == no_name);
    const NameId first = names.intern("light_octree");
    CHECK(names.word_class(first) == WordClass::name);
    CHECK_FALSE(names.reserved(first));
    for (int i = 0; i < 20000; ++i) names.intern("n" + std::to_string(i));
    CHECK(names.intern("light_octree") == first);
    CHECK(names.spelling(first) == "light_octree");
    CHECK(names.spelling(names.find("n12345")) == "n12345");
    CHECK(names.size() == reserved_words().size() + own_words().size() + 20001);
}

}  // namespace candelabra

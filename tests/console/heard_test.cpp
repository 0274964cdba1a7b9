// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/heard.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("what is heard is kept by kind") {
    Heard heard;
    heard.take(Stream::warning, "mind the step\n");
    heard.take(Stream::fatal, "fallen\n");
    heard.take(Stream::fatal, "again\n");
    heard.take(Stream::debug, "so ");
    heard.take(Stream::debug, "it is\n");
    heard.take(Stream::render, "10 %\n");
    heard.take(Stream::statistics, "1 s\n");
    CHECK(heard.warnings == std::vector<std::string>{"mind the step\n"});
    CHECK(heard.errors == "fallen\nagain\n");
    CHECK(heard.said == "so it is\n");
}

TEST_CASE("what is heard has bounds") {
    Heard heard;
    for (std::size_t i = 0; i < most_warnings + 7; ++i) heard.take(Stream::warning, "again\n");
    CHECK(heard.warnings.size() == most_warnings);
    CHECK(heard.more_warnings == 7);
    const std::string line(99, 'x');
    for (int i = 0; i < 10'000; ++i) {
        heard.take(Stream::debug, line);
        heard.take(Stream::debug, "\n");
    }
    CHECK(heard.said.size() <= 2 * most_said);
    CHECK(heard.said.starts_with('x'));
    CHECK(heard.said.size() % 100 == 0);  // whole lines
    heard.take(Stream::debug, std::string(9 * most_said, 'y'));
    CHECK(heard.said.size() == most_said);
}

}  // namespace candelabra

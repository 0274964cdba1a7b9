// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/progress_style.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("styles of progress have names, but auto depends on the terminal") {
    CHECK(progress_style("plain") == ProgressStyle::lines);
    CHECK(progress_style("none") == ProgressStyle::silent);
    CHECK(progress_style("openjd") == ProgressStyle::openjd);
    CHECK(progress_style("povray") == ProgressStyle::povray);
    CHECK_FALSE(progress_style("auto"));
}

}  // namespace candelabra

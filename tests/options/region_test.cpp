// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/region.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("rows and columns count from 1, or are fractions") {
    Options options;
    options.render.width = 200;
    options.render.height = 100;
    CHECK(region_of(options) == Region{0, 0, 200, 100});
    options.start_row = 11;
    options.end_row = 20;
    options.start_column = 0.25;
    options.end_column = 0.5;
    CHECK(region_of(options) == Region{50, 10, 100, 20});
    options.end_row = 1;
    options.start_row = 0;
    CHECK(region_of(options) == Region{50, 0, 100, 100});
    options.end_row = 1000;
    options.start_row = 1;
    CHECK(region_of(options) == Region{50, 0, 100, 100});
    options.end_row = 1;
    CHECK(region_of(options).bottom == 100);
    options.start_row = 101;
    CHECK(region_of(options).top == 100);
}

}  // namespace candelabra

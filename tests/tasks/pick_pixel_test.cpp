// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/pick_pixel.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a pixel is picked without a picture") {
    Shell shell;
    shell.write("a.pov", R"(#version 3.7;
camera { location -5*z look_at 0 angle 50 }
sphere { <-1, 0, 0>, 0.8 pigment { rgb <1, 0.5, 0> } finish { ambient 0 diffuse 1 } }
light_source { <-1, 0, -5>, 3 }
)");
    const auto pick = [&](const std::string& place) {
        return shell({shell.path("a.pov"), "+W32", "+H24", "--pick", place});
    };
    REQUIRE(pick("10,12") == exit_status::done);
    CHECK(shell.out.starts_with("<10, 12>: rgb <"));
    CHECK(has(shell.out, "\nobject 1: "));
    CHECK(has(shell.out, "a.pov:3: sphere { <-1, 0, 0>"));
    CHECK(has(shell.out, "100 %"));
    CHECK_FALSE(std::filesystem::exists(shell.path("a.png")));
    REQUIRE(pick("31,0") == exit_status::done);
    CHECK(shell.out == "<31, 0>: rgb <0, 0, 0>\n");
    CHECK(pick("32,0") == exit_status::usage);
    CHECK(has(shell.err, "outside of the picture of 32x24 pixels"));
    for (const char* wrong : {"10", "10,", "-1,2", "1.5,2", "a,b", "1,2,3", "65535,0"}) {
        CAPTURE(wrong);
        CHECK(pick(wrong) == exit_status::usage);
        CHECK(has(shell.err, "--pick 120,80"));
    }
    CHECK(shell({shell.path("a.pov"), "--pick", "1,2", "--check"}) == exit_status::usage);
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/measure_light.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a signal ends measuring, and the table has what was measured") {
    Shell shell;
    shell.write("a.pov",
                "#version 3.7; global_settings { photometry { unit 1 white 100 } }\n"
                "light_source { 2*y, rgb 1 intensity candela(400) }\n"
                "meter { \"desk\" points { 1, <0, 0, 0> } }\n");
    const auto run = [&] {
        return shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "-V"});
    };
    REQUIRE(run() == exit_status::done);
    const std::string whole = shell.content("a.csv");
    CHECK(has(whole, "\ndesk,illuminance,lx,1,"));
    shell.interrupts.take = [] { return Interrupt::stop; };
    CHECK(run() == exit_status::stopped);
    CHECK(has(shell.content("a.csv"), "\ndesk,illuminance,lx,1,"));
}

TEST_CASE("a scene that moves is measured when its shutter opens, and that is said") {
    Shell shell;
    const std::string settings =
        "#version 3.7; global_settings { photometry { unit 1 white 100 } }\n";
    const std::string rest =
        "light_source { <clock, 2, 0>, rgb 1 intensity candela(400) } sphere { 9*y, 1 }\n"
        "meter { points { 1, <0, 0, 0> } }\n";
    const auto table = [&](const std::string& camera) {
        shell.write("a.pov", settings + camera + rest);
        CHECK(shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "-V"}) ==
              exit_status::done);
        return shell.content("a.csv");
    };
    const std::string still = table("camera { location -5*z } ");
    CHECK_FALSE(has(shell.err, "shutter"));
    CHECK(table("camera { location -5*z shutter 1, 4 } ") == still);
    CHECK(has(shell.err,
              "the scene moves while its shutter is open, and --measure measures when "
              "it opens"));
}

}  // namespace candelabra

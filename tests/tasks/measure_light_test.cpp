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

}  // namespace candelabra

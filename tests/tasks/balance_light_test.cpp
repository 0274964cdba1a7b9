// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/balance_light.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a signal ends a balance of light, and the table has what was followed") {
    Shell shell;
    shell.write(
        "a.pov",
        "#version 3.7; global_settings { photometry { unit 1 } }\n"
        "sphere { y, 0.1 pigment { rgb 1 } luminaire { flux lumen(250) } } plane { y, 0 }\n");
    shell.interrupts.take = [] { return Interrupt::stop; };
    CHECK(shell({shell.path("a.pov"), "--light-balance", shell.path("a.csv"), "-V"}) ==
          exit_status::stopped);
    CHECK(has(shell.content("a.csv"), "\nall,,1,"));
    shell.write("a.pov", "#version 3.7; sphere { y, 0.1 luminare { } }\n");
    CHECK(shell({shell.path("a.pov"), "--light-balance", shell.path("b.csv"), "-V"}) ==
          exit_status::scene);
    CHECK(shell.content("b.csv").empty());
}

}  // namespace candelabra

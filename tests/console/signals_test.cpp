// SPDX-License-Identifier: GPL-3.0-or-later
#include "console/signals.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cstdlib>

#include <sys/wait.h>

namespace candelabra {

TEST_CASE("SIGUSR1 writes the state, SIGTERM, SIGINT and SIGHUP end the program with it") {
    for (const char* signal : {"TERM", "INT", "HUP"}) {
        const Shell shell;
        // A signal before the program listens is ignored, since the program inherits that
        // disposition. Under nohup the test inherits it, too, for SIGHUP.
        const std::string script = "trap '' USR1; cd " + shell.folder.string() +
                                   "; env --default-signal=HUP " CANDELABRA_BINARY
                                   " lit.pov -V +W200 +H200 --samples 100000 +Oa.png & p=$!\n"
                                   "for i in $(seq 200); do kill -USR1 $p; sleep 0.1; [ -e "
                                   "a.png.state.exr ] && break; done\n"
                                   "kill -" +
                                   signal + " $p; wait $p";
        const int status = std::system(script.c_str());
        REQUIRE(WIFEXITED(status));
        CHECK(WEXITSTATUS(status) == exit_status::stopped);
        CHECK(shell.content("a.png.state.exr").size() > 1000);
        CHECK(shell.content("a.png").empty());
    }
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/surroundings.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("solve has the surroundings of a run: logs, commands, the file of its options",
          "[app][solve]") {
    Shell shell;
    shell.write("a.pov",
                "#version 3.7; light_source { 2*y, rgb 1 }\n"
                "meter { \"Street\" points { 1, <0, 0, 0> } }\n#warning \"seen\"\n");
    shell.write("a.ini", "Post_Scene_Command=touch \"" + shell.path("after") +
                             "\"\nWarning_File=" + shell.path("log.txt") + "\n");
    const std::vector<std::string> words = {
        "solve", shell.path("a.ini"), shell.path("a.pov"), "--on", "Street", "--lux", "1..",
        "-o",    shell.path("p.inc")};
    CHECK(shell(words) == exit_status::done);
    CHECK(has(shell.err, "Post_Scene_Command"));
    CHECK(has(shell.err, "is not run"));
    CHECK(has(shell.content("log.txt"), "seen"));
    CHECK_FALSE(std::filesystem::exists(shell.path("after")));
    std::vector<std::string> allowed = words;
    allowed.insert(allowed.end(), {"--allow-commands"});
    CHECK(shell(allowed) == exit_status::done);
    CHECK(std::filesystem::exists(shell.path("after")));
}

}  // namespace candelabra

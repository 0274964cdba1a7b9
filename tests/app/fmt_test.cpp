// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/fmt.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <sys/stat.h>

namespace candelabra {

TEST_CASE("files are laid out in place, or only named") {
    Shell shell;
    shell.write("a.pov", "union {\nA\n}\n");
    shell.write("b.pov", "A\n");
    const std::string a = shell.path("a.pov"), b = shell.path("b.pov");
    CHECK(shell({"fmt", "--check", a, b}) == exit_status::scene);
    CHECK(shell.out == a + "\n");
    CHECK(shell.content("a.pov") == "union {\nA\n}\n");
    CHECK(shell({"fmt", a, b}) == exit_status::done);
    CHECK(shell.content("a.pov") == "union {\n    A\n}\n");
    CHECK(shell({"fmt", "--check", a, b}) == exit_status::done);
}

TEST_CASE("fmt waits for no pipe, and writes through no link that leads elsewhere") {
    Shell shell;
    REQUIRE(::mkfifo(shell.path("pipe.pov").c_str(), 0600) == 0);
    CHECK(shell({"fmt", shell.path("pipe.pov")}) == exit_status::file);
    CHECK(has(shell.err, "cannot be read"));
    std::filesystem::create_directories(shell.path("archive"));
    shell.write("mine.pov", " A\n");
    std::filesystem::create_symlink("../mine.pov", shell.path("archive/a.pov"));
    CHECK(shell({"fmt", shell.path("archive/a.pov")}) == exit_status::file);
    CHECK(shell.content("mine.pov") == " A\n");
}

TEST_CASE("files that cannot be read or have mistakes are left alone, and the others are not") {
    Shell shell;
    shell.write("bad.pov", "union {\nA\n");
    shell.write("good.pov", " A\n");
    CHECK(shell({"fmt", shell.path("bad.pov"), shell.path("good.pov")}) == exit_status::scene);
    CHECK(has(shell.err, "bad.pov:"));
    CHECK(shell.content("bad.pov") == "union {\nA\n");
    CHECK(shell.content("good.pov") == "A\n");
    CHECK(shell({"fmt", shell.path("none.pov")}) == exit_status::file);
    CHECK(has(shell.err, "cannot be read"));
    CHECK(shell({"fmt", "--what"}) == exit_status::usage);
}

}  // namespace candelabra

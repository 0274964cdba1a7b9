// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/solve_command.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("words of solve that make no sense are refused", "[solve]") {
    Shell shell;
    shell.write("a.pov",
                "#version 3.7; light_source { 2*y, rgb 1 }\n"
                "meter { \"Street\" points { 1, <0, 0, 0> } }\n");
    struct Row {
        std::vector<std::string> words;
        std::string said;
    };
    const std::string file = shell.path("a.pov");
    const Row rows[] = {
        {{}, "solve needs a scene"},
        {{file}, "solve needs what a meter is to read"},
        {{file, "--on", "Street", "-o", "-"}, "`--on Street` says where"},
        {{file, "--on", "Street", "--on", "Street", "--lux", "1..2", "-o", "-"},
         "`--on Street` says where"},
        {{file, "--lux", "1..2", "-o", "-"}, "`--lux` stands before any --on"},
        {{file, "--on", "Street", "--lux", "1..2"}, "solve needs a file for the powers"},
        {{file, "--on", "Street", "--lux"}, "`--lux` needs a value"},
        {{file, "--on", "Street", "--lux", "5", "-o", "-"}, "`--lux 5` is no range"},
        {{file, "--on", "Street", "--lux", "..", "-o", "-"}, "`--lux ..` is no range"},
        {{file, "--on", "Street", "--lux", "5..2", "-o", "-"}, "`--lux 5..2` is no range"},
        {{file, "--on", "Street", "--lux", "-1..2", "-o", "-"}, "`--lux -1..2` is no range"},
        {{file, "--on", "Street", "--mean-lux=x..2", "-o", "-"}, "`--mean-lux x..2` is no range"},
        {{file, "--on", "Street", "--lux", "1..2", "--max-power", "0", "-o", "-"},
         "`--max-power 0` is no number above 0"},
        {{file, "--on", "Street", "--lux", "1..2", "-o", "-", "--measure", "x.csv"},
         "solve finds powers and does nothing else"},
        {{file, "--on", "Street", "--lux", "1..2", "-o", "-", "+KFF3"}, "not on frames"},
        {{file, "--on", "Street", "--lux", "1..2", "-o", "-", "--denoise"}, "takes light as it is"},
    };
    for (const Row& row : rows) {
        std::vector<std::string> words = {"solve"};
        words.insert(words.end(), row.words.begin(), row.words.end());
        CHECK(shell(words) == exit_status::usage);
        INFO(shell.err);
        CHECK(has(shell.err, row.said));
    }
}

TEST_CASE("solve has its help, and says where it cannot write", "[solve]") {
    Shell shell;
    CHECK(shell({"solve", "--help"}) == exit_status::done);
    CHECK(has(shell.out, "usage: candelabra solve"));
    shell.write("a.pov",
                "#version 3.7; light_source { 2*y, rgb 1 }\n"
                "meter { \"Street\" points { 1, <0, 0, 0> } }\n");
    CHECK(shell({"solve", shell.path("a.pov"), "--on", "Street", "--lux", "1..", "-o",
                 shell.path("none/p.inc")}) == exit_status::file);
}

}  // namespace candelabra

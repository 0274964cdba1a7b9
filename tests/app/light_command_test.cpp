// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/light_command.h"

#include "support/shell.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

const std::string files = CANDELABRA_SOURCE_DIR "/tests/photometry/files/";

}  // namespace

TEST_CASE("a luminaire is described for people, with its diagram", "[app][photometry]") {
    Shell shell;
    REQUIRE(shell({"light", files + "isym3.ldt"}) == exit_status::done);
    for (const char* part :
         {"EULUMDAT", "flux       7648.4 lm, 85 % of the lamps' 9000 lm; 100 % of it down",
          "maximum    2835.9 cd at V ", "power      112 W, 68.3 lm/W", "symmetry   Isym 3, type C",
          "opening    box, width 0.2 m, length 0.3 m", "note       it has 2 sets of lamps",
          "* C0-C180, across the luminaire    o C90-C270, along the luminaire"}) {
        CAPTURE(part);
        CHECK(has(shell.out, part));
    }
    REQUIRE(shell({"light", "--set", "2", files + "isym3.ldt"}) == exit_status::done);
    CHECK(has(shell.out, "of which number 2 is taken"));
}

TEST_CASE("a luminaire is described for programs", "[app][photometry]") {
    Shell shell;
    REQUIRE(shell({"light", "--json", files + "c-bilateral-1991.ies"}) == exit_status::done);
    const auto json = nlohmann::json::parse(shell.out);
    CHECK(json["flux_lm"].get<double>() == Approx(2924.5961).epsilon(1e-6));
    CHECK(json["max_cd"].get<double>() == Approx(857.223).epsilon(1e-6));
    CHECK(json["symmetry"] == "bilateral 0-180");
    CHECK(json["version"] == 1991);
    CHECK(json["opening_m"][1].get<double>() == Approx(0.6096));
    CHECK(json["labels"]["LAMP"] == "70 W");
    REQUIRE(shell({"light", "--json", files + "isym0.ldt", files + "sloppy-2002.ies"}) ==
            exit_status::done);
    const auto both = nlohmann::json::parse(shell.out);
    REQUIRE(both.size() == 2);
    CHECK(both[0]["isym"] == 0);
    CHECK(both[1]["notes"].size() == 6);
}

TEST_CASE("a diagram is written as SVG", "[app][photometry]") {
    Shell shell;
    REQUIRE(shell({"light", files + "a-beam-2002.ies", "-o", shell.path("a.svg")}) ==
            exit_status::done);
    CHECK(has(shell.content("a.svg"), "vertical plane of the beam"));
}

TEST_CASE("what cannot be described has a message", "[app][photometry]") {
    Shell shell;
    shell.write("odd.ies", "IESNA91\nTILT=NONE\n1 100 1 2 1 1 2 0 0 0 1 1 10\n0 90 0\n5");
    CHECK(shell({"light", shell.path("odd.ies")}) == exit_status::file);
    CHECK(has(shell.err, "odd.ies`: line 5: the file ends before candela value 2 of 2"));
    CHECK(shell({"light", shell.path("none.ies")}) == exit_status::file);
    CHECK(has(shell.err, "cannot be read"));
    for (const std::vector<std::string>& wrong : {std::vector<std::string>{"light"},
                                                  {"light", "-x", "a.ies"},
                                                  {"light", "a.ies", "-o"},
                                                  {"light", "a.ies", "-o", "a.png"},
                                                  {"light", "--set", "0", "a.ies"}}) {
        CHECK(shell(wrong) == exit_status::usage);
        CHECK(has(shell.err, "candelabra light [--json]"));
    }
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/balance_report.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

/// 1000 lm of a string of bulbs and 500 lm of one, above a floor that absorbs a quarter.
const std::string bulbs =
    "#version 3.7; global_settings { photometry { unit 1 } }\n"
    "#default { finish { ambient 0 diffuse 0 } pigment { rgb 1 } }\n"
    "union { #for (I, 1, 4) sphere { <I, 2, 0>, 0.1 luminaire { flux lumen(250) } } #end "
    "light_name \"string\" }\n"
    "sphere { 3*y, 0.1 luminaire { flux lumen(500) } }\n"
    "plane { y, 0 finish { diffuse 0.75 } }\n";

}  // namespace

TEST_CASE("a balance of light is written as a table", "[output]") {
    Shell shell;
    shell.write("a.pov", bulbs);
    REQUIRE(shell({shell.path("a.pov"), "--light-balance", shell.path("a.csv")}) == 0);
    const std::string csv = shell.content("a.csv");
    CHECK(csv.starts_with("statement,name,lamps,sent,sent_error,surfaces,surfaces_error,air,"));
    CHECK(std::ranges::count(csv, '\n') == 4);
    CHECK(has(csv, ",string,4,"));
    CHECK(has(csv, "\nall,,5,"));
    CHECK(has(shell.out, "lamps send 15"));
    CHECK(has(shell.out, "surfaces that absorb most:\n"));
    CHECK(has(shell.out, "a.pov:5: plane { y, 0 finish { diffuse 0.75 } }"));
    REQUIRE(shell({shell.path("a.pov"), "--light-balance", shell.path("b.csv"), "+WT3"}) == 0);
    CHECK(shell.content("b.csv") == csv);
    REQUIRE(shell({shell.path("a.pov"), "--light-balance", "-"}) == 0);
    CHECK(shell.out == csv);
}

TEST_CASE("a balance of light is written for programs", "[output]") {
    Shell shell;
    shell.write("a.pov", bulbs);
    REQUIRE(shell({shell.path("a.pov"), "--light-balance", shell.path("a.json")}) == 0);
    const auto json = nlohmann::json::parse(shell.content("a.json"));
    CHECK(json["unit"].get<std::string>() == "lm");
    CHECK(json["reached"] == true);
    REQUIRE(json["statements"].size() == 2);
    const auto& all = json["all"];
    const auto lumens = [&](const char* end) { return all[end]["value"].get<double>(); };
    CHECK(json["statements"][0]["name"].get<std::string>() == "string");
    CHECK(json["statements"][0]["sent"]["value"].get<double>() == Approx(1000).epsilon(0.005));
    CHECK(lumens("sent") == Approx(1500).epsilon(0.005));
    // A little of the light meets other bulbs.
    CHECK(lumens("above") == Approx(750).epsilon(0.03));
    CHECK(lumens("above_reflected") == Approx(562).epsilon(0.03));
    CHECK(lumens("below") == 0);
    CHECK(json["surfaces"][0]["absorbed"]["value"].get<double>() == Approx(187.5).epsilon(0.03));
}

TEST_CASE("a balance tells which light it leaves out", "[output]") {
    Shell shell;
    shell.write("sources.pov", "#version 3.7; light_source { 9*y, 1 } plane { y, 0 }");
    CHECK(shell({shell.path("sources.pov"), "--light-balance", shell.path("a.csv")}) == 1);
    CHECK(has(shell.err, "the scene has no lamp whose light could be followed"));
    shell.write("both.pov", bulbs + "light_source { 9*y, 1 }");
    CHECK(shell({shell.path("both.pov"), "--light-balance", shell.path("a.csv")}) == 0);
    CHECK(has(shell.err, "1 light source has no flux, and is left out of the balance"));
    shell.write("sky.pov", bulbs +
                               "light_source { 9*y, 1 flux lumen(100) } "
                               "sky_luminance { overcast sun <40, 180> }");
    CHECK(shell({shell.path("sky.pov"), "--light-balance", shell.path("a.csv")}) == 0);
    CHECK(has(shell.err, "light of the sky is left out of the balance: it has no flux"));
    CHECK_FALSE(has(shell.err, "light source"));
    CHECK(shell({shell.path("both.pov"), "--light-balance", shell.path("a.txt")}) == 2);
    CHECK(has(shell.err, "--light-balance light.csv, or light.json"));
    CHECK(shell({shell.path("both.pov"), "--light-balance", shell.path("a.csv"), "--until",
                 "lux 1%"}) == 0);
    CHECK(has(shell.err, "--until is the error at which --measure ends"));
}

}  // namespace candelabra

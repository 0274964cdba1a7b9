// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/measurement.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <nlohmann/json.hpp>

namespace candelabra {

namespace {

const std::string lit_room =
    "#version 3.7; global_settings { photometry { unit 1 white 100 } integrator { path_traced } }\n"
    "light_source { 2*y, rgb 1 intensity candela(400) }\n"
    "meter { \"desk, \\\"big\\\"\" corner -x along 2*x across 2*z counts <3, 1> }\n"
    "meter { cylindrical points { 1, <0, 1.2, 1> } }\n";

}  // namespace

TEST_CASE("meters are measured into a table") {
    Shell shell;
    shell.write("a.pov", lit_room);
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.csv")}) == 0);
    const std::string csv = shell.content("a.csv");
    CHECK(csv.starts_with("meter,quantity,unit,point,x,y,z,value,low,high\n"));
    CHECK(std::ranges::count(csv, '\n') == 5);
    CHECK(has(csv, "\"desk, \"\"big\"\"\",illuminance,lx,2,0,0,1,71.5542,71.5542,71.5542\n"));
    CHECK(has(csv, "\nmeter 2,cylindrical,lx,1,0,1.2,1,"));
    CHECK(has(shell.out, "desk, \"big\": illuminance at 3 points, lx\n  mean "));
    CHECK(has(shell.out, " lm through 4 m2\n"));
    CHECK(has(shell.out, "meter 2: cylindrical at 1 point, lx\n"));
    CHECK(shell.content("a.png").empty());
    // The same bytes by another number of threads; another seed has other samples.
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("b.csv"), "+WT3"}) == 0);
    CHECK(shell.content("b.csv") == csv);
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("c.csv"), "--seed", "5"}) == 0);
    CHECK(shell.content("c.csv") != csv);
    REQUIRE(shell({shell.path("a.pov"), "--measure", "-"}) == 0);
    CHECK(shell.out == csv);
}

TEST_CASE("tables have no value of points inside of objects, and a warning names them") {
    Shell shell;
    shell.write("a.pov", lit_room + "box { <-0.1, -0.1, 0.9>, <0.1, 0.1, 1.1> }");
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.csv")}) == 0);
    CHECK(
        has(shell.err, "1 point of `desk, \"big\"` is inside of objects, and left out: <0, 0, 1>"));
    CHECK(has(shell.content("a.csv"), ",illuminance,lx,2,0,0,1,,,\n"));
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.json"), "--samples", "16"}) ==
            0);
    CHECK(has(shell.err, "is inside of objects"));
    const auto desk = nlohmann::json::parse(shell.content("a.json"))["meters"][0];
    CHECK(desk["points"][1]["value"].is_null());
    CHECK(desk["min"]["value"].get<double>() > 0);
}

TEST_CASE("meters are measured for programs") {
    Shell shell;
    shell.write("a.pov", lit_room);
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.json"), "--until",
                   "lux 0.5%"}) == 0);
    const auto json = nlohmann::json::parse(shell.content("a.json"));
    CHECK(json["metres_per_unit"] == 1);
    CHECK(json["white_cd_m2"] == 100);
    REQUIRE(json["meters"].size() == 2);
    const auto& desk = json["meters"][0];
    CHECK(desk["name"] == "desk, \"big\"");
    CHECK(desk["points"].size() == 3);
    CHECK(desk["unit"] == "lx");
    CHECK(desk["reached"] == true);
    CHECK(desk["max"]["at"] == nlohmann::json({0, 0, 1}));
    CHECK(desk["area_m2"] == 4);
    CHECK(desk["flux_lm"]["value"].get<double>() ==
          Approx(4 * desk["mean"]["value"].get<double>()).epsilon(1e-4));
    CHECK(json["meters"][1]["points"][0]["error"].get<double>() <=
          0.005 * json["meters"][1]["points"][0]["value"].get<double>());
}

TEST_CASE("frames of an animation are measured into numbered tables") {
    Shell shell;
    shell.write("a.pov",
                "#version 3.7; global_settings { photometry { unit 1 } integrator { path_traced } "
                "}\nlight_source { (1 + clock)*y, rgb 1 intensity candela(400) }\n"
                "meter { points { 1, 0 } direction y }\n");
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "+KFF2", "-V"}) == 0);
    CHECK(has(shell.content("a1.csv"), ",1,0,0,0,400,400,400\n"));
    CHECK(has(shell.content("a2.csv"), ",1,0,0,0,100,100,100\n"));
    CHECK(shell.content("a.csv").empty());
}

TEST_CASE("what is not as exact as asked, or dark, is said") {
    Shell shell;
    const std::string lamp =
        "#version 3.7; global_settings { photometry { unit 1 } integrator { path_traced } }\n"
        "torus { 1, 0.1 translate 2*y pigment { rgb 1 } finish { emission 100 } }\n";
    shell.write("a.pov", lamp + "meter { \"desk\" points { 1, 0 } direction y }\n");
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "--time", "0.000001s",
                   "--until", "0.01%", "-V"}) == 0);
    CHECK(has(shell.err, "`desk` is known within "));
    CHECK(has(shell.err, "and 0.01 % was asked for: it ended after 64 samples"));
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "--until", "nit 0.01%",
                   "-V"}) == 0);
    CHECK_FALSE(has(shell.err, "`desk`"));
    shell.write("a.pov", lamp +
                             "box { -0.5, 0.5 }\n"
                             "meter { \"desk\" points { 2, 0, 3*y } direction y }\n");
    REQUIRE(shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "-V"}) == 0);
    CHECK(has(shell.err, "no light reaches 2 points of `desk`"));
}

TEST_CASE("ratings and factors need what they compare with") {
    Shell shell;
    const auto run = [&](const std::string& settings, const std::string& more) {
        shell.write("a.pov", "#version 3.7; global_settings { photometry { unit 1 } " + settings +
                                 " }\nsphere { 3*y, 0.1 pigment { rgb 1 } finish { emission 100 } "
                                 "}\nplane { y, 0 }\n" +
                                 more);
        return shell({shell.path("a.pov"), "--measure", shell.path("a.csv"), "-V"});
    };
    const std::string traced = "integrator { path_traced }",
                      eye = "meter { \"eye\" ugr points { 1, y } direction z } ",
                      factor = "meter { \"in\" daylight_factor points { 1, y } } ";
    CHECK(run("integrator { pov_ray }", eye) == exit_status::scene);
    CHECK(has(shell.err, "`ugr` compares lamps with the indirect light at the eye"));
    CHECK(run(traced, factor) == exit_status::scene);
    CHECK(has(shell.err, "a daylight factor needs a sky"));
    CHECK(run(traced, factor + "background { rgb 1 }") == 0);
    CHECK(has(shell.err, "the light of lamps counts in daylight factors"));
    CHECK(run(traced, eye + eye) == 0);
    CHECK(has(shell.err, "two meters are called `eye`"));
    CHECK(run(traced, eye + "sphere { 2*y, 0.3 hollow pigment { rgbt 1 } interior { media { "
                            "emission 3 } luminaire } }") == 0);
    CHECK(has(shell.err, "media that glow count neither in ratings of glare"));
}

TEST_CASE("what cannot be measured is said") {
    Shell shell;
    const auto run = [&](const std::string& scene, std::vector<std::string> more = {}) {
        shell.write("a.pov", scene);
        more.insert(more.begin(), {shell.path("a.pov"), "--measure", shell.path("a.csv")});
        return shell(more);
    };
    CHECK(run("#version 3.7; sphere { 0, 1 }") == exit_status::scene);
    CHECK(has(shell.err, "the scene has no meter to measure with"));
    CHECK(run(lit_room, {"+W90", "+H30"}) == exit_status::done);
    CHECK_FALSE(has(shell.err, "aspect"));
    CHECK(run(lit_room, {"--denoise"}) == exit_status::usage);
    CHECK(has(shell.err, "--measure reports light as it is"));
    CHECK(run(lit_room, {"--until", "lux"}) == exit_status::usage);
    CHECK(has(shell.err, "`lux` is no error of 0.001 to 100 per cent"));
    CHECK(run(lit_room, {"--check"}) == exit_status::usage);
    CHECK(shell({shell.path("a.pov"), "--measure", shell.path("a.txt")}) == exit_status::usage);
    CHECK(has(shell.err, "results are written as CSV or JSON"));
    CHECK(run("#version 3.7; meter { threshold_increment road \"R\" direction z points { 1, <0, 0, "
              "0> "
              "} }") == exit_status::scene);
    CHECK(has(shell.err, "no meter of luminance is called `R`"));
    CHECK(run("#version 3.7; meter { corner <0, 0, 0> along x across z counts <9999, 9999> }") ==
          exit_status::scene);
    CHECK(has(shell.err, "more than 1000000 points"));
    CHECK(run("#version 3.7; light_source { y, 1 } meter { points { 1, <0, 0, 0> } }") == 0);
    CHECK(has(shell.err, "only direct light is measured"));
    CHECK(has(shell.out, "illuminance at 1 point, lx\n"));
}

TEST_CASE("the ending of a file says the form of results") {
    CHECK(reading_format("a.csv") == ReadingFormat::csv);
    CHECK(reading_format("a.b/c.JSON") == ReadingFormat::json);
    CHECK(reading_format("-") == ReadingFormat::csv);
    for (const char* other : {"a.txt", "a", "", "csv"}) CHECK_FALSE(reading_format(other));
}

}  // namespace candelabra

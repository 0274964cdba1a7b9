// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/solve_powers.h"

#include "support/shell.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdlib>

namespace candelabra {

namespace {

/// Two lamps of 400 cd, 2 m above two points that are 3 m apart.
constexpr auto two_lamps_over_points = R"(#version 3.7;
global_settings { photometry { unit 1 white 100 } integrator { path_traced } }
#ifndef (Power) #declare Power = array[2] { 1, 1 } #end
union {
  light_source { <0, 2, 0>, rgb 1 intensity candela(400*Power[0]) }
  light_source { <3, 2, 0>, rgb 1 intensity candela(400*Power[1]) }
  light_name "Poles"
}
meter { "Street" points { 2, <0, 0, 0>, <3, 0, 0> } }
meter { "Wall" luminance points { 1, <0, 0, 0> } eye <0, 1, -5> }
)";

/// Illuminances below each lamp by itself and by the other one: the inverse-square law.
constexpr double own_light = 400.0 / 4;
const double other_light = 400 * 2 / (13 * std::sqrt(13.0));

struct Solving : Shell {
    Solving() { write("a.pov", two_lamps_over_points); }

    int solve(std::vector<std::string> more) {
        more.insert(more.begin(), {"solve", path("a.pov"), "--samples", "32"});
        return (*this)(more);
    }
    /// The numbers of the array in a text.
    static std::vector<double> powers_in(const std::string& text) {
        std::vector<double> powers;
        for (std::size_t at = text.find("\n  "); at != std::string::npos;
             at = text.find("\n  ", at + 1))
            powers.push_back(std::strtod(text.c_str() + at, nullptr));
        return powers;
    }
};

}  // namespace

TEST_CASE("powers of two lamps are those of the inverse-square law", "[solve]") {
    Solving run;
    REQUIRE(run.solve({"--on", "Street", "--lux", "60..60", "-o", run.path("p.inc")}) == 0);
    const std::string text = run.content("p.inc");
    CHECK(has(text, "#declare Power = array[2] {\n"));
    CHECK(has(text, ",  // Poles[0]\n"));
    const std::vector<double> equal = Solving::powers_in(text);
    REQUIRE(equal.size() == 2);
    CHECK(equal[0] == Approx(60 / (own_light + other_light)));
    CHECK(equal[1] == Approx(60 / (own_light + other_light)));
    CHECK(has(run.out, "2 powers with "));
    CHECK(
        has(run.out, "tight: `Street` at <0, 0, 0>, at least 60 lx, and 60 lx by the other half"));
    CHECK(has(run.out, "gap: readings differ by up to 0 % "));
    // The scene reads them, and its meter then reads what was asked.
    run.write("b.pov", "#include \"p.inc\"\n" + std::string(two_lamps_over_points));
    REQUIRE(run({run.path("b.pov"), "--measure", "-", "--samples", "32"}) == 0);
    CHECK(has(run.out, "Street,illuminance,lx,1,0,0,0,60,"));
    CHECK(has(run.out, "Street,illuminance,lx,2,3,0,0,60,"));
}

TEST_CASE("lamps that are not named stay as they are", "[solve]") {
    Solving run;
    REQUIRE(run.solve({"--on", "Street", "--mean-lux", "80..", "--lamps", "Poles[1]", "-o", "-"}) ==
            0);
    const std::vector<double> powers = Solving::powers_in(run.out);
    REQUIRE(powers.size() == 1);
    const double mean = (own_light + other_light) / 2;
    CHECK(powers[0] == Approx((80 - mean) / mean));
    CHECK(has(run.err, "1 power with "));
    REQUIRE(run.solve({"--on", "Street", "--lux", "60..", "--together", "-o", "-"}) == 0);
    REQUIRE(Solving::powers_in(run.out).size() == 1);
    CHECK(has(run.out, "  // Poles\n"));
}

TEST_CASE("what cannot be met is named, and the nearest powers are written", "[solve]") {
    Solving run;
    CHECK(run.solve({"--on", "Street", "--lux", "150..", "--max-power", "1", "-o",
                     run.path("p.inc")}) == exit_status::scene);
    CHECK(has(run.err, "cannot be met: `Street` at <0, 0, 0>, at least 150 lx; it has 117.1 lx"));
    CHECK(has(run.err, "cannot be met: `Street` at <3, 0, 0>, at least 150 lx"));
    CHECK(has(run.err, "a greater --max-power"));
    CHECK(Solving::powers_in(run.content("p.inc")) == std::vector<double>{1, 1});
}

TEST_CASE("a far lamp that samples hardly find is left out, and named", "[solve]") {
    Solving run;
    run.write("a.pov", R"(#version 3.7;
global_settings { photometry { unit 1 white 100 } integrator { path_traced } }
#macro Glow(Light) pigment { rgb 1 } finish { ambient 0 diffuse 0 emission Light } #end
plane { y, 0 pigment { rgb 0.5 } }
union { #for (I, 0, 2) sphere { <I, 2, 0>, 0.1 Glow(50) } #end light_name "Near" }
union { #for (I, 0, 199) sphere { <100 + I, 3, 0>, 0.1 Glow(50) } #end light_name "Far" }
meter { "Street" corner <0, 0.01, -1> along 2*x across 2*z counts <4, 3> }
)");
    // One of them is found once, and would have thousands of times its power.
    CHECK(run.solve({"--samples", "128", "--on", "Street", "--lux", "120..", "--lamps", "Far", "-o",
                     "-"}) == exit_status::scene);
    CHECK(has(run.err, "left out: `Far["));
    CHECK(has(run.err, "]`, of whose light there are too few samples at the meters"));
    CHECK(has(run.err, "was left out, or wider bounds"));
    for (const double power : Solving::powers_in(run.out)) CHECK(power < 100);
}

TEST_CASE("what has no powers is refused", "[solve]") {
    Solving run;
    const auto refused = [&](const std::string& meter, const std::string& said) {
        CHECK(run.solve({"--on", meter, "--lux", "20..50", "-o", "-"}) == exit_status::scene);
        INFO(run.err);
        CHECK(has(run.err, said));
        CHECK(run.out == "");
    };
    refused("Stret", "the scene has no meter `Stret`");
    CHECK(has(run.err, "did you mean `Street`?"));
    refused("Wall", "meter `Wall` measures luminance");
    CHECK(run.solve({"--on", "Street", "--lux", "20..", "--lamps", "Pols", "-o", "-"}) ==
          exit_status::scene);
    CHECK(has(run.err, "there is no lamp `Pols`"));
    run.write("a.pov", "#version 3.7; meter { \"Street\" points { 1, <0, 0, 0> } }\n");
    refused("Street", "the scene has no lamps whose powers could be solved");
    run.write("a.pov", "#version 3.7; light_source { y, rgb 1 }\n");
    refused("Street", "the scene has no meter `Street`");
}

TEST_CASE("powers are the same for any number of threads", "[solve]") {
    Solving run;
    run.write("a.pov", R"(#version 3.7;
global_settings { photometry { unit 1 white 100 } integrator { path_traced } }
plane { y, 0 pigment { rgb 0.5 } }
box { <-1, 0, 2>, <5, 3, 2.1> pigment { rgb 0.7 } }
#for (I, 0, 3)
  sphere { <I, 2, 0>, 0.1 pigment { rgb 1 } finish { ambient 0 emission 50 } }
#end
meter { "Street" corner <0, 0.01, -1> along 3*x across 2*z counts <5, 4> }
)");
    const auto found = [&](const std::string& threads) {
        REQUIRE(run.solve(
                    {"--on", "Street", "--lux", "20..200", "--threads", threads, "-o", "-"}) == 0);
        return run.out;
    };
    const std::string one = found("1");
    CHECK(Solving::powers_in(one).size() == 4);
    CHECK(one == found("3"));
}

}  // namespace candelabra

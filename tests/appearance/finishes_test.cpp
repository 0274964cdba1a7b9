// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/finishes.h"

#include "support/spheres.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

Finish finish_of(const std::string& text) {
    return sphere_with("finish { " + text + " }", "#declare F = finish { ambient 1 phong 0.5 }")
        .texture()
        .finish;
}

}  // namespace

TEST_CASE("a finish has its words, and may be declared", "[appearance]") {
    CHECK(finish_of("ambient 0.2 diffuse 0.3 emission rgb <1, 2, 3> brilliance 2").emission ==
          Rgb(1, 2, 3));
    CHECK(finish_of("F phong_size 10").phong == 0.5);
    CHECK(finish_of("F phong_size 10").phong_size == 10);
    CHECK(finish_of("specular 1 metallic").metallic == 1);
    CHECK(finish_of("metallic specular 1").specular == 1);
    CHECK(finish_of("metallic 0.25").metallic == 0.25);
    CHECK(finish_of("conserve_energy").conserve_energy);
    CHECK(finish_of("use_alpha").use_alpha);
    CHECK_FALSE(finish_of("use_alpha off").use_alpha);
}

TEST_CASE("a block of reflection changes only what it says", "[appearance]") {
    const std::string before = "reflection { 0.1, 0.9 falloff 3 metallic exponent 0.5 fresnel } ";
    const Reflection after = finish_of(before + "reflection { 0.2, 0.8 }").reflection;
    CHECK(after.least == Rgb(0.2));
    CHECK(after.greatest == Rgb(0.8));
    CHECK(after.falloff == 3);
    CHECK(after.metallic == 1);
    CHECK(after.exponent == 0.5);
    CHECK(after.fresnel);
    CHECK(finish_of(before + "reflection { 0.5 }").reflection.least == Rgb(0.5));
    CHECK(finish_of(before + "reflection { 0.5 fresnel }").reflection.least == Rgb(0));
}

TEST_CASE("reflection is an amount or a block", "[appearance]") {
    const Reflection amount = finish_of("reflection 0.5").reflection;
    CHECK(amount.least == Rgb(0.5));
    CHECK(amount.greatest == Rgb(0.5));
    CHECK(finish_of("reflection rgb <1, 0, 0> phong 1").reflection.greatest == Rgb(1, 0, 0));
    const Reflection both = finish_of("reflection { 0.1, rgb 0.9 falloff 3 metallic }").reflection;
    CHECK(both.least == Rgb(0.1));
    CHECK(both.greatest == Rgb(0.9));
    CHECK(both.falloff == 3);
    CHECK(both.metallic == 1);
    const Reflection fresnel = finish_of("reflection { 0.8 fresnel }").reflection;
    CHECK(fresnel.least == Rgb(0));
    CHECK(fresnel.greatest == Rgb(0.8));
    CHECK(fresnel.fresnel);
}

TEST_CASE("an interior adds up", "[appearance]") {
    CHECK(sphere_with("interior { ior 1.5 }").object().interior->ior == 1.5);
    CHECK(
        sphere_with("interior { I }", "#declare I = interior { ior 1.3 }").object().interior->ior ==
        1.3);
    CHECK(sphere_with("interior { ior 2 } interior { }").object().interior->ior == 2);
    for (const std::string version : {"3.7", "3.1"}) {
        const Script old =
            run("#version " + version + "; sphere { 0, 1 interior { refraction 0.85 ior 1.5 } }");
        CHECK(old.object().interior->ior == 1.5);
        REQUIRE(old.said.size() == 1);
        CHECK(old.said[0].message == "`refraction` has no effect in this version");
    }
}

TEST_CASE("albedo is turned into amounts when the finish is complete", "[appearance]") {
    CHECK(finish_of("diffuse albedo 0.7 brilliance 3").diffuse == Approx(1.4));
    CHECK(finish_of("phong albedo 0.1 phong_size 9").phong == Approx(0.5));
    CHECK(finish_of("diffuse 0.6, 0.3").diffuse_back == 0.3);
    CHECK(finish_of("irid { 0.25 thickness 0.3 turbulence 0 }").irid == Irid{0.25, 0.3, 0});
}

TEST_CASE("use_alpha does not reach facets, and says so", "[appearance]") {
    CHECK(complaint("sphere { 0, 1 finish { use_alpha microfacet { } } }")
              .starts_with("warning no-effect: `use_alpha` has no effect on `microfacet`"));
    CHECK(run("#version 3.7; sphere { 0, 1 finish { use_alpha } }").text.empty());
}

TEST_CASE("wrong finishes are told of once", "[appearance]") {
    CHECK(complaint("sphere { 0, 1 finish { reflection } }") ==
          "error missing: `reflection` of `finish` needs a colour or a block");
    CHECK(complaint("sphere { 0, 1 finish { reflection \"a\" } }") ==
          "error wrong-type: `reflection` of `finish` must be a colour, but it is a string");
    CHECK(complaint("sphere { 0, 1 finish { reflection 0.5 reflection_exponent 0 } }") ==
          "warning no-effect: `reflection_exponent` of `finish` should be above 0, but it is 0: "
          "1e-06 counts");
    CHECK(complaint("#declare F = finish { } sphere { 0, 1 finish { phong 1 F } }") ==
          "error misplaced: what is declared must come first: it would replace all that is before "
          "it in `finish`");
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// Each file of the standard library can be included alone and twice, says nothing, and declares
// what it documents.
#include "support/draw.h"
#include "support/scripts.h"
#include "support/vectors.h"
#include "surface/texture.h"
#include "text/message.h"

#include <catch2/catch.hpp>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <functional>

namespace candelabra {

namespace fs = std::filesystem;

TEST_CASE("each library file can be included alone and twice", "[stdlib]") {
    constexpr auto npos = std::string::npos;
    std::size_t count = 0;
    for (const auto& entry : fs::directory_iterator(CANDELABRA_SOURCE_DIR "/stdlib")) {
        const fs::path ending = entry.path().extension();
        if (ending != ".inc" && ending != ".map") continue;
        const std::string include = "#include \"" + entry.path().filename().string() + "\"\n";
        const Evaluated once = evaluated("#version 3.7;\n" + include);
        INFO(include << once.diagnostics);
        CHECK(once.diagnostics.empty());
        CHECK(once.printed.empty());
        const bool stage = include.find("stdcam") != npos || include.find("stage1") != npos;
        CHECK(once.scene.objects.empty() != stage);
        CHECK(evaluated("#version 3.7;\n" + include + include).diagnostics.empty());
        ++count;
    }
    CHECK(count >= 4);
}

TEST_CASE("library names have their values", "[stdlib]") {
    struct Case {
        const char* file;
        const char* expression;
        const char* printed;
    };
    const Case cases[] = {
        {"colors.inc", "vstr(3, Red, \",\", 0, 3)", "1.000,0.000,0.000"},
        {"colors.inc", "vstr(3, SummerSky, \",\", 0, 6)", "0.220000,0.690000,0.870000"},
        {"colors.inc", "vstr(3, Clear, \",\", 0, 1)", "1.0,1.0,1.0"},
        {"colors_ral.inc", "vstr(3, RAL_5015, \",\", 0, 6)", "0.000000,0.201556,0.428690"},
        {"colors_ral.inc", "vstr(3, RAL_1026, \",\", 0, 1)", "1.0,1.0,0.0"},
        {"colors_ral.inc", "vstr(3, RAL_9023, \",\", 0, 3)", "0.188,0.198,0.195"},
        {"consts.inc", "vstr(3, xy, \",\", 0, 1)", "1.0,1.0,0.0"},
        {"consts.inc", "str(Water_Ior, 0, 2)", "1.33"},
        {"sphereflake.inc", "str(Sphereflake_Count(4), 0, 0)", "7381"},
    };
    for (const Case& c : cases) {
        const Evaluated result = evaluated("#version 3.7; #include \"" + std::string(c.file) +
                                           "\" #debug " + c.expression);
        INFO(c.expression << result.diagnostics);
        CHECK(result.printed == c.printed);
    }
}

TEST_CASE("light arrays place as many lamps as they are asked for", "[stdlib]") {
    struct Case {
        const char* array;
        std::size_t lamps;
    };
    const Case cases[] = {
        {"Light_Grid(L, <3, 4, 5>, <1, 1, 1>)", 60},
        {"Light_Line(L, 7, <0, 0, 0>, <5, 0, 0>)", 7},
        {"Light_Ring(L, 12, 3)", 12},
        {"Light_Helix(L, 30, 2, 5, 3)", 30},
        {"Light_Sphere(L, 50, 4)", 50},
        {"Light_String(L, 9, P, 0.1)", 9},
        {"Light_Spline_String(L, 11, P, 0.1)", 11},
        {"Light_Box(L, 20, <-9, 0, -9>, <9, 0, 9>, 0.5, 1)", 20},
        {"Light_Facade(L, L, <4, 3>, <1, 1>, 0.5, 1)", 12},
        {"Light_Street(L, 6, 5, 8)", 12},
        {"Light_Positions(L, P)", 3},
    };
    const std::string before = R"(#version 3.7; #include "light_arrays.inc"
        #declare L = sphere { 0, 0.05 pigment { rgb 1 } finish { emission 1 } }
        #declare P = array[3] { <-5, 3, 0>, <0, 4, 2>, <6, 3, 1> }
        object { )";
    for (const Case& c : cases) {
        const SharedWorld world = world_of(before + c.array + " }");
        INFO(c.array);
        CHECK(world->lights.luminaires.size() == c.lamps);
    }
}

namespace {

/// The radiances of the luminaires that a macro makes, in their order. A floor receives their light.
std::string radiances(const std::string& call) {
    const SharedWorld world = world_of(R"(#version 3.7; global_settings { assumed_gamma 1 }
        plane { y, -99 pigment { rgb 1 } }
        #include "light_arrays.inc" #declare L = sphere { 0, 0.05 } object { )" +
                                       call + " }");
    std::string text;
    for (const Luminaire& each : world->lights.luminaires.own())
        text += message(text.empty() ? "" : " | ", each.radiance.r, " ", each.radiance.g, " ",
                        each.radiance.b);
    return text;
}

std::string error_of(const std::string& script) {
    const Evaluated result = evaluated("#version 3.7; #include \"light_arrays.inc\"\n" + script);
    return result.diagnostics.substr(0, result.diagnostics.find('\n'));
}

}  // namespace

TEST_CASE("lamps come from tables", "[stdlib]") {
    const std::string tables = "\"tests/stdlib/tables/";
    CHECK(radiances("Light_From_CSV(L, " + tables + "lamps.csv\", 3)") == "6 0 0 | 1.5 1.5 1.5");
    CHECK(radiances("Light_From_CSV(L, " + tables + "places.csv\", 3)") == "3 3 3 | 3 3 3 | 3 3 3");
    CHECK(radiances("Light_From_CSV(L, " + tables + "bare.csv\", 5)") == "5 0 0 | 0 1 0");
    const std::string film = tables + "places.csv\", " + tables + "film.csv\", ";
    CHECK(radiances("Light_Frames(L, " + film + "0, 5)") == "5 0 0 | 0 1 0");
    CHECK(radiances("Light_Frames(L, " + film + "1, 5)") == "0 0 5 | 0 0 5 | 0 0 5");
    CHECK(radiances("Light_Frames(L, " + film + "102.5, 5)") == "5 0 0 | 0 1 0");
    CHECK(radiances("Light_Frames(L, " + film + "-1, 5)") == "0 0 5 | 0 0 5 | 0 0 5");
    CHECK(radiances("Light_Frames(L, " + tables + "places.csv\", " + tables +
                    "dim_film.csv\", 0, 5)") == "2.5 0 0 | 0 5 0");
}

TEST_CASE("groups of lamps have the names of a column's values", "[stdlib]") {
    const auto names = [](const std::string& column) {
        const SharedWorld world = world_of(R"(#version 3.7; plane { y, -99 pigment { rgb 1 } }
            #include "light_arrays.inc"
            #declare L = sphere { 0, 0.05 pigment { rgb 1 } finish { emission 3 } }
            object { Light_Groups(L, "tests/stdlib/tables/strings.csv", ")" +
                                           column + "\") translate 2*y }");
        std::string text;
        for (std::size_t k = 0; k < world->provenance.light_names.size(); ++k) {
            const auto& all = world->provenance.statement_of_luminaire;
            text += message(text.empty() ? "" : " ", world->provenance.light_names[k], " ",
                            std::count(all.begin(), all.end(), k));
        }
        return text;
    };
    CHECK(names("string") == "Roof 3 Door 2");
    CHECK(names("floor") == "floor_0 1 floor_2 2 floor_1 2");
    CHECK(error_of("object { Light_Groups(sphere { 0, 1 }, \"tests/stdlib/tables/strings.csv\", "
                   "\"strig\") }") ==
          "error: the header of tests/stdlib/tables/strings.csv names no column strig");
}

TEST_CASE("tables that do not fit say what is wrong", "[stdlib]") {
    const std::string tables = "\"tests/stdlib/tables/";
    CHECK(error_of("object { Light_From_CSV(sphere { 0, 1 }, " + tables + "unnamed.csv\", 1) }") ==
          "error: the header of tests/stdlib/tables/unnamed.csv names no column x: it must name x, "
          "y and z, or be left out of a table of 3 or 6 columns");
    for (const std::string macro :
         {"Light_From_CSV(sphere { 0, 1 }, ", "Light_Frames(sphere { 0, 1 }, "}) {
        const std::string rest =
            macro.starts_with("Light_Frames") ? ", " + tables + "film.csv\", 0, 1) }" : ", 9) }";
        CHECK(
            error_of("object { " + macro + tables + "no_z.csv\"" + rest) ==
            "error: the header of tests/stdlib/tables/no_z.csv names no column z: it must name x, "
            "y and z, or be left out of a table of 3 or 6 columns");
        CHECK(error_of("object { " + macro + tables + "latitude.csv\"" + rest) ==
              "error: the header of tests/stdlib/tables/latitude.csv names no column x: it must "
              "name x, y and z, or be left out of a table of 3 or 6 columns");
        CHECK(
            error_of("object { " + macro + tables + "bare_four.csv\"" + rest) ==
            "error: the header of tests/stdlib/tables/bare_four.csv must name columns x, y and z, "
            "as the table has 4 columns; only a table of 3 or 6 columns needs none");
    }
    CHECK(
        error_of("object { Light_From_CSV(sphere { 0, 1 }, " + tables + "no_blue.csv\", 9) }") ==
        "error: the header of tests/stdlib/tables/no_blue.csv names no column b: it must name all "
        "or none of r, g and b");
    CHECK(error_of("object { Light_Frames(sphere { 0, 1 }, " + tables + "bare.csv\", " + tables +
                   "places.csv\", 0, 1) }") ==
          "error: tests/stdlib/tables/places.csv has 3 columns, and the 2 LEDs of "
          "tests/stdlib/tables/bare.csv need 6");
    CHECK(error_of("#declare P = array[3] { x, y, z } #declare C = array[2] { x, y }\n"
                   "object { Light_Positions_Coloured(sphere { 0, 1 }, P, C, 1) }") ==
          "error: Light_Positions_Coloured: Points has 3 entries and Colours has 2");
}

TEST_CASE("a light array that cannot be meant says the rule", "[stdlib]") {
    const auto [call, rule] = GENERATE(table<std::string, std::string>({
        {"Light_Ring(sphere { 0, 1 }, 0, 3)",
         "`Count` of `Light_Ring` must be a whole number of at least 1, but it is 0"},
        {"Light_Ring(2, 3, 3)",
         "`Lamp` of `Light_Ring` must be an object or an array of 1 dimension, but it is 2"},
        {"Light_Grid(sphere { 0, 1 }, <2, 1, 1>, 0)",
         "Light_Grid: Pitch.x must not be 0 where there is more than one lamp"},
        {"Light_Line(sphere { 0, 1 }, 3, x, x)",
         "Light_Line: Start and End must be different points"},
        {"Light_String(sphere { 0, 1 }, 3, array[2] { x, x }, 0)",
         "Light_Along: Track must not be a single point"},
        {"Light_Facade(sphere { 0, 1 }, sphere { 0, 1 }, 2, 1, 1.5, 1)",
         "`Share` of `Light_Facade` must be a number from 0 to 1, but it is 1.5"},
    }));
    INFO(call);
    const Evaluated result =
        evaluated("#version 3.7; #include \"light_arrays.inc\" object { " + call + " }");
    CHECK(result.failed);
    CHECK(result.diagnostics.find(rule) != std::string::npos);
}

TEST_CASE("an argument for which POV-Ray has an answer is taken", "[stdlib]") {
    const auto [file, call] = GENERATE(table<std::string, std::string>({
        {"rand.inc", "#declare N = Rand_Bernoulli(1.5, seed(1));"},
        {"rand.inc", "#declare N = Rand_Binomial(3, -0.1, seed(1));"},
        {"strings.inc", "#declare S = Vstr(x, 0.5, 0);"},
        {"strings.inc", "#declare S = CRGBStr(rgb 1, 0, 1.5);"},
    }));
    INFO(call);
    CHECK_FALSE(evaluated("#version 3.7; #include \"" + file + "\"\n" + call + "\n").failed);
}

TEST_CASE("an argument that a macro has no answer for is named", "[stdlib]") {
    const auto [file, call, parameter] = GENERATE(table<std::string, std::string, std::string>({
        {"math.inc", "#declare N = VDist(x, \"y\");", "B"},
        {"rand.inc", "#declare N = Rand_Geo(1, seed(1));", "P"},
        {"rand.inc", "#declare N = Rand_Triangle(2, 1, 1, seed(1));", "High"},
        {"rand.inc", "#declare N = Rand_Triangle(1, 2, 3, seed(1));", "Mode"},
        {"arrays.inc", "#declare A = array[2] { 1, 2 }; Sort_Partial_Array(A, -1, 1)", "First"},
        {"arrays.inc", "#declare A = array[2] { 1, 2 }; Resize_Array(A, 1.5)", "Size"},
        {"meshmaker.inc", "#declare N = LInterpolate(x, 0, 1);", "Part"},
        {"makegrass.inc", "MakeBlade(0, y, 0, 0, 1, 1, 0, 0, y, x, 1, 0, 0)", "Segments"},
    }));
    INFO(call);
    const Evaluated result = evaluated("#version 3.7; #include \"" + file + "\"\n" + call + "\n");
    CHECK(result.failed);
    INFO(result.diagnostics);
    CHECK(result.diagnostics.starts_with("error"));
    CHECK(result.diagnostics.find("`" + parameter + "` of `") != std::string::npos);
}

namespace {

/// A letter for each shape in the object: `a` if it throws no shadow, else `b`.
std::string kinds_of_lamps(const Object& object) {
    const auto* parts = std::get_if<Union>(&object.form);
    if (!parts) return object.no_shadow ? "a" : "b";
    std::string kinds;
    for (const ObjectHandle& part : parts->children) kinds += kinds_of_lamps(*part);
    return kinds;
}

}  // namespace

TEST_CASE("all arrays around a thing turn the lamp's x outwards and its y upwards", "[stdlib]") {
    const auto centres = [](const std::string& array, const std::string& offset) {
        const SharedWorld world =
            world_of("#version 3.7; #include \"light_arrays.inc\" #declare L = sphere { " + offset +
                     ", 0.01 pigment { rgb 1 } finish { emission 1 } } object { " + array + " }");
        std::vector<Vec3> made;
        for (const Luminaire& each : world->lights.luminaires.own())
            made.push_back(std::get<SphereEmitter>(each.emitter).centre);
        return made;
    };
    for (const char* const array : {"Light_Ring(L, 12, 4)", "Light_Sphere(L, 50, 4)",
                                    "Light_Scatter(L, sphere { 0, 4 }, 1, 1)"}) {
        INFO(array);
        const std::vector<Vec3> places = centres(array, "0"), out = centres(array, "0.5*x"),
                                up = centres(array, "0.5*y");
        REQUIRE(places.size() >= 12);
        for (std::size_t i = 0; i < places.size(); ++i) {
            CHECK(length(out[i] - 1.125 * places[i]) < 0.01);
            CHECK(up[i].y >= places[i].y - 1e-6);
            CHECK(std::abs(dot(up[i] - places[i], unit(places[i]))) < 0.01);
        }
    }
}

TEST_CASE("lamps of an array are taken in turn by every light array", "[stdlib]") {
    const auto call =
        GENERATE("Light_Positions(L, P)", "Light_Grid(L, <2, 2, 1>, 3)", "Light_Line(L, 4, x, y)",
                 "Light_Ring(L, 4, 3)", "Light_Helix(L, 4, 3, 1, 1)", "Light_Sphere(L, 4, 3)",
                 "Light_String(L, 4, P, 0.1)", "Light_Spline_String(L, 4, P, 0.1)",
                 "Light_Box(L, 4, 0, 20, 1, 1)", "Light_Facade(L, L, 2, 1, 1, 1)",
                 "Light_Street(L, 2, 3, 4)");
    INFO(call);
    const Scene scene =
        scene_of(std::string("#version 3.7; #include \"light_arrays.inc\"\n"
                             "#declare L = array[2] { box { -1, 1 no_shadow }, box { -1, 1 } };\n"
                             "#declare P = array[4] { x, y, z, x + y }; object { ") +
                 call + " }");
    std::string kinds;
    for (const ObjectHandle& object : scene.objects) kinds += kinds_of_lamps(*object);
    CHECK(kinds == "abab");
}

TEST_CASE("each colour of RAL Classic is named once", "[stdlib]") {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/stdlib/colors_ral.inc");
    int last = 0, count = 0;
    for (std::string line; std::getline(file, line);) {
        constexpr std::string_view start = "#declare RAL_";
        if (!line.starts_with(start)) continue;
        const int number = std::stoi(line.substr(start.size(), 4));
        CHECK(number > last);
        last = number;
        ++count;
    }
    CHECK(count == 216);
    CHECK(last == 9023);
}

TEST_CASE("library macros and functions give what POV-Ray 3.7's give", "[stdlib]") {
    CHECK(check_scripts("stdlib/vectors") > 250);
}

TEST_CASE("the library declares every name of POV-Ray's file of the same name", "[stdlib]") {
    std::ifstream file(CANDELABRA_SOURCE_DIR "/tests/stdlib/names.json");
    const auto files = nlohmann::json::parse(file);
    for (const auto& [include, names] : files.items()) {
        if (!fs::exists(std::string(CANDELABRA_SOURCE_DIR "/stdlib/") + include)) continue;
        std::string script = "#include \"" + include + "\"\n";
        for (const auto& name : names)
            script += "#ifndef (" + name.get<std::string>() + ") #debug \"" +
                      name.get<std::string>() + " \" #end\n";
        INFO(include);
        CHECK(evaluated(script).printed == "");
    }
}

TEST_CASE("colours have places in the spaces of CIE, by D50 or D65", "[stdlib]") {
    // sRGB's red, by CSS Color 4 (D50) and by the primaries (D65).
    const std::string script =
        "#include \"colors.inc\"\n"
        "#macro P(C) #local D = color C; #debug concat(vstr(3, <D.red, D.green, D.blue>, \" \", 0, "
        "2), \" \", str(D.filter + D.transmit, 0, 1), \"; \") #end\n"
        "P(CRGB2Lab(rgb x)) P(CRGB2Lab_D65(rgb x)) P(CRGB2Lab(rgbft <1, 1, 1, 0.2, 0.3>)) "
        "P(CRGB2XYZ_D65(rgb 1)) P(CRGB2XYZ(rgb 1)) P(CLab2RGB(CRGB2Lab(rgb <0.2, 0.5, 0.01>))) "
        "P(CLab2RGB_D65(CRGB2Lab_D65(rgb <0.2, 0.5, 0>))) P(CXYZ2RGB(CRGB2XYZ(rgb <0.3, 0.4, 2>)))";
    CHECK(evaluated(script).printed ==
          "54.29 80.81 69.89 0.0; 53.24 80.09 67.20 0.0; 100.00 0.00 0.00 0.5; "
          "0.95 1.00 1.09 0.0; 0.96 1.00 0.83 0.0; 0.20 0.50 0.01 0.0; "
          "0.20 0.50 0.00 0.0; 0.30 0.40 2.00 0.0; ");
}

namespace {

Texture library_texture(const std::string& include, const std::string& name) {
    return *scene_of("#version 3.7; #include \"" + include + "\" sphere { 0, 1 texture { " + name +
                     " } }")
                .objects.at(0)
                ->texture;
}

/// The mean over many places of what a function makes of a colour there.
Rgb mean(const Pigment& pigment, const std::function<Rgb(const Colour&)>& share) {
    constexpr int count = 40000;
    Draw draw(1);
    Rgb sum(0);
    for (int i = 0; i < count; ++i) sum += share(evaluate(pigment, draw.point(20)));
    return sum / double{count};
}

}  // namespace

TEST_CASE("as many places of a starfield are lit as in POV-Ray, and in its colours", "[stdlib]") {
    const double lit[] = {0.0331, 0.0494, 0.0664, 0.0984, 0.1289, 0.1583};
    for (int i = 0; i < 6; ++i) {
        const Pigment stars =
            library_texture("stars.inc", "Starfield" + std::to_string(i + 1)).pigment;
        const auto is = [](bool yes) { return Rgb(yes ? 1 : 0, 0, 0); };
        const double all = mean(stars, [&](const Colour& c) { return is(c.rgb != Rgb(0)); }).r;
        CHECK(all == Approx(lit[i]).margin(0.004));
        const Rgb colour = mean(stars, [](const Colour& c) { return c.rgb; }) / all;
        CHECK(colour.r == Approx(0.664).margin(0.02));
        CHECK(colour.g == Approx(0.61).margin(0.02));
        CHECK(colour.b == Approx(0.613).margin(0.02));
    }
}

TEST_CASE("the grain of stones is as wide as in POV-Ray", "[stdlib]") {
    struct Case {
        const char* stone;
        double width;  ///< at which the correlation of brightness has fallen to 1/e in POV-Ray
    };
    const Case cases[] = {
        {"T_Stone1", 0.059},  {"T_Stone4", 0.031},  {"T_Stone6", 0.097},  {"T_Stone12", 0.053},
        {"T_Stone16", 0.086}, {"T_Stone19", 0.022}, {"T_Stone21", 0.028}, {"T_Stone23", 0.026},
        {"T_Stone25", 0.012}, {"T_Stone28", 0.02},  {"T_Stone30", 0.013}, {"T_Stone32", 0.026},
        {"T_Stone36", 0.018}, {"T_Stone44", 0.006},
    };
    for (const Case& c : cases) {
        INFO(c.stone);
        const Texture stone = library_texture("stones.inc", c.stone);
        REQUIRE(stone.below);
        const auto brightness = [&](const Vec3& at) {
            const Colour upper = evaluate(stone.pigment, at);
            return grey((1 - upper.transmit) * upper.rgb +
                        upper.transmit * evaluate(stone.below->pigment, at).rgb);
        };
        // Grains are much smaller than the square that is looked at, which lies in a plane.
        Draw draw(1);
        constexpr int count = 6000;
        double sum = 0, squares = 0, products = 0;
        for (int i = 0; i < count; ++i) {
            const Vec3 place = draw.point(0.5);
            const Vec3 at(place.x, place.y, 0);
            const double here = brightness(at);
            const double there =
                brightness(at + c.width * (i % 2 == 0 ? Vec3(1, 0, 0) : Vec3(0, 1, 0)));
            sum += here;
            squares += here * here;
            products += here * there;
        }
        const double mean_square = sum * sum / count;
        const double correlation = (products - mean_square) / (squares - mean_square);
        CHECK(correlation > 0.15);
        CHECK(correlation < 0.6);
    }
}

TEST_CASE("woods are as bright, as varied and as fine as in POV-Ray", "[stdlib]") {
    struct Case {
        int wood;
        double mean, deviation;  ///< of brightness in the square of side 1 around the z axis
        double width;  ///< along x, at which the correlation of brightness has fallen to 1/e
    };
    const Case cases[] = {
        {1, 0.496, 0.087, 0.012},  {2, 0.190, 0.048, 0.014},  {3, 0.624, 0.021, 0.012},
        {4, 0.232, 0.034, 0.009},  {5, 0.369, 0.032, 0.016},  {6, 0.182, 0.035, 0.015},
        {7, 0.640, 0.056, 0.027},  {8, 0.310, 0.051, 0.011},  {9, 0.540, 0.129, 0.021},
        {10, 0.723, 0.023, 0.021}, {11, 0.594, 0.087, 0.004}, {12, 0.196, 0.016, 0.009},
        {13, 0.626, 0.067, 0.008}, {14, 0.251, 0.040, 0.042}, {15, 0.237, 0.019, 0.017},
        {16, 0.239, 0.015, 0.009}, {17, 0.270, 0.029, 0.015}, {18, 0.337, 0.050, 0.007},
        {19, 0.499, 0.101, 0.010}, {20, 0.499, 0.101, 0.010}, {21, 0.594, 0.086, 0.003},
        {22, 0.196, 0.016, 0.005}, {23, 0.625, 0.068, 0.011}, {24, 0.260, 0.046, 0.014},
        {25, 0.241, 0.025, 0.012}, {26, 0.242, 0.021, 0.012}, {27, 0.269, 0.027, 0.008},
        {28, 0.339, 0.050, 0.004}, {29, 0.473, 0.112, 0.007}, {30, 0.496, 0.087, 0.012},
    };
    for (const Case& c : cases) {
        INFO("T_Wood" << c.wood);
        const Texture wood = library_texture("woods.inc", "T_Wood" + std::to_string(c.wood));
        REQUIRE(wood.below);
        const auto brightness = [&](const Vec3& at) {
            const Colour upper = evaluate(wood.pigment, at);
            return grey(upper.opacity() * upper.rgb +
                        upper.passing() * evaluate(wood.below->pigment, at).rgb);
        };
        constexpr int count = 200;
        double sum = 0, squares = 0, products = 0;
        int pairs = 0;
        for (int i = 0; i < count; ++i)
            for (int j = 0; j < count; ++j) {
                const Vec3 at((i + 0.5) / count - 0.5, (j + 0.5) / count - 0.5, -0.001);
                const double here = brightness(at);
                sum += here;
                squares += here * here;
                if (at.x + c.width > 0.5) continue;
                products += (here - c.mean) * (brightness(at + Vec3(c.width, 0, 0)) - c.mean);
                ++pairs;
            }
        const double mean = sum / (count * count);
        const double variance = squares / (count * count) - mean * mean;
        CHECK(mean == Approx(c.mean).margin(0.01));
        CHECK(std::sqrt(variance) == Approx(c.deviation).epsilon(0.1));
        CHECK(products / pairs / variance == Approx(0.368).margin(0.1));
    }
}

TEST_CASE("a finish that is put on a stone reaches its upper layer, as in POV-Ray", "[stdlib]") {
    struct Case {
        const char* stone;
        Rgb upper, lower;  ///< what each adds in POV-Ray, in 255ths
    };
    const Case cases[] = {{"T_Stone1", {73, 64, 59}, {60, 44, 33}},
                          {"T_Stone21", {10, 10, 10}, {88, 43, 48}},
                          {"T_Stone30", {16, 10, 18}, {100, 97, 61}},
                          {"T_Stone44", {37, 21, 3}, {55, 55, 55}}};
    for (const Case& c : cases) {
        INFO(c.stone);
        const Texture stone =
            library_texture("stones.inc", std::string(c.stone) + " finish { ambient 1 diffuse 0 }");
        REQUIRE(stone.below);
        CHECK_FALSE(stone.below->below);
        CHECK(stone.below->finish.diffuse + stone.below->finish.ambient.r == Approx(0.7));
        const Rgb upper =
            mean(stone.pigment, [](const Colour& at) { return (1 - at.transmit) * at.rgb; });
        const double through = evaluate(stone.pigment, Vec3(0)).transmit;
        const Rgb lower =
            0.7 * through * mean(stone.below->pigment, [](const Colour& at) { return at.rgb; });
        for (int i = 0; i < 3; ++i) {
            CHECK(255 * upper[i] == Approx(c.upper[i]).margin(3));
            CHECK(255 * lower[i] == Approx(c.lower[i]).margin(4));
        }
    }
}

}  // namespace candelabra

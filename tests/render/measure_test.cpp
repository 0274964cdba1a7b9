// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/measure.h"

#include "meter/glare.h"
#include "support/scripts.h"

#include <catch2/catch.hpp>

#include <cmath>
#include <ctime>
#include <numbers>
#include <vector>

namespace candelabra {

namespace {

using std::numbers::pi;

const std::string metres =
    "#version 3.7; global_settings { photometry { unit 1 white 1 } integrator { path_traced } } "
    "#default { finish { ambient 0 diffuse 0 } } camera { location <50, 50, -50> } ";

/// The readings of the meters of a script, whose unit is a metre and whose radiance is in cd/m2.
std::vector<MeterReading> read_meters(const std::string& script, MeasureSettings settings = {}) {
    const Scene scene = scene_of(metres + script);
    return measure(shot_of(metres + script), scene.meters, settings);
}

MeterValue read_one(const std::string& script, double error) {
    MeasureSettings settings;
    settings.goal.error = error;
    settings.threads = 1;
    return read_meters(script, settings).at(0).values.at(0);
}

const std::string at_origin = "meter { points { 1, <0, 0, 0> } } ";

/// A window from 0.9 to 2.4 m above the point, 3 m wide, 2 m before it; all else is dark.
const std::string window =
    "difference { box { <2, -100, -100>, <2.0001, 100, 100> } box { <1, 0.9, -1.5>, <3, 2.4, "
    "1.5> } } box { <-100, -1, -100>, <100, -0.01, 100> } box { <-100, 50, -100>, <3, 50.1, "
    "100> } #for (I, 1, 3) box { <100, -100, -100>, <100.1, 100, 100> rotate 90*I*y } #end ";

}  // namespace

TEST_CASE("meters find what formulas say, in two seconds", "[render]") {
    const double a = 1.2, b = 0.8, h = 2, x = a / h, y = b / h, light = 1000;
    const double rectangle = light / 2 *
                             (x / std::sqrt(1 + x * x) * std::atan(y / std::sqrt(1 + x * x)) +
                              y / std::sqrt(1 + y * y) * std::atan(x / std::sqrt(1 + y * y)));
    const double r = 0.7, disc_radius = 1;
    const double squares = h * h + r * r + disc_radius * disc_radius;
    const double disc =
        pi * light / 2 *
        (1 - (h * h + r * r - disc_radius * disc_radius) /
                 std::sqrt(squares * squares - 4 * disc_radius * disc_radius * r * r));
    const double phi = std::atan(1.5 / h), per_metre = light * 0.01;
    struct Row {
        const char* name;
        std::string scene;
        double expected;
    };
    const Row rows[] = {
        {"disc", "disc { <0.7, 2, 0>, y, 1 pigment { rgb 1 } finish { emission 1000 } }", disc},
        {"rectangle",
         "polygon { 5, <0, 2, 0>, <1.2, 2, 0>, <1.2, 2, 0.8>, <0, 2, 0.8>, <0, 2, 0> pigment { rgb "
         "1 } "
         "finish { emission 1000 } }",
         rectangle},
        {"the same in triangles",
         "mesh { triangle { <0, 2, 0>, <1.2, 2, 0>, <1.2, 2, 0.8> } triangle { <0, 2, 0>, <1.2, 2, "
         "0.8>, <0, 2, 0.8> } pigment { rgb 1 } finish { emission 1000 } }",
         rectangle},
        {"sphere", "sphere { <1.5, 2, 0>, 0.25 pigment { rgb 1 } finish { emission 1000 } }",
         pi * light * 0.0625 / 6.25 * 0.8},
        {"tube",
         "cylinder { <0, 2, 0>, <1.5, 2, 0>, 0.005 open pigment { rgb 1 } finish { emission 1000 } "
         "}",
         per_metre / (2 * h) * (phi + std::sin(phi) * std::cos(phi))},
        {"source", "light_source { <3, 4, 0>, rgb 1 intensity candela(1000) }", 32},
        {"sky", "background { rgb 1000 }", pi * light},
    };
    for (const Row& row : rows) {
        CAPTURE(row.name);
        const std::clock_t before = std::clock();
        const MeterValue found = read_one(row.scene + at_origin, 0.003);
        CHECK(found.value == Approx(row.expected).epsilon(0.005));
        CHECK(static_cast<double>(std::clock() - before) / CLOCKS_PER_SEC < 2);
        CHECK(found.error <= 0.005 * found.value);
    }
}

TEST_CASE("meters of all shapes weigh directions as they are defined", "[render]") {
    const std::string source = "light_source { <3, 4, 0>, rgb 1 intensity candela(1000) } ";
    const auto lit = [&](const std::string& meter) {
        return read_one(source + "meter { " + meter + " points { 1, <0, 0, 0> } }", 0.004).value;
    };
    CHECK(lit("cylindrical") == Approx(7.63944).epsilon(0.005));
    CHECK(lit("semi_cylindrical direction <0.5, 0, sqrt(0.75)>") == Approx(11.4592).epsilon(0.005));
    CHECK(lit("hemispherical") == Approx(18).epsilon(0.005));
    CHECK(lit("spherical") == Approx(10).epsilon(0.005));
    CHECK(lit("illuminance direction x") == Approx(24).epsilon(1e-3));
    CHECK(lit("illuminance direction -y") == 0);
    CHECK(lit("maintenance 0.8") == Approx(0.8 * 32).epsilon(1e-3));
    CHECK(lit("daylight_factor") == 0);
    CHECK(read_one("background { rgb 1000 } meter { cylindrical points { 1, <0, 0, 0> } }", 0.01)
              .value == Approx(pi * 1000).epsilon(0.01));
    CHECK(
        read_one("background { rgb 1000 } meter { daylight_factor points { 1, <0, 0, 0> } }", 0.01)
            .value == Approx(100).epsilon(1e-3));
    CHECK(
        read_one("background { rgb 7 } meter { luminance cone 10 direction z points { 1, <0, 0, 0> "
                 "} }",
                 0.01)
            .value == Approx(7));
}

TEST_CASE("a converged room has the illuminances of radiosity", "[render]") {
    // Reference values by radiosity with graded patches, extrapolated.
    const std::string room =
        "box { <0, 0, 0>, <4, -0.1, 3> pigment { rgb 0.2 } finish { diffuse 1 } } "
        "box { <0, 2.5, 0>, <4, 2.6, 3> pigment { rgb 0.7 } finish { diffuse 1 emission "
        "100/pi/0.7 } } "
        "#declare Wall = texture { pigment { rgb 0.5 } finish { diffuse 1 } } "
        "box { <-0.1, 0, 0>, <0, 2.5, 3> texture { Wall } } "
        "box { <4, 0, 0>, <4.1, 2.5, 3> texture { Wall } } "
        "box { <0, 0, -0.1>, <4, 2.5, 0> texture { Wall } } "
        "box { <0, 0, 3>, <4, 2.5, 3.1> texture { Wall } } "
        "global_settings { max_trace_level 50 integrator { path_traced bounces 60 } } ";
    MeasureSettings settings;
    settings.goal.error = 0.004;
    const auto found = read_meters(room +
                                       "meter { points { 2, <2, 0, 1.5>, <1, 0, 0.75> } } "
                                       "meter { points { 1, <0, 1.25, 1.5> } direction x } "
                                       "meter { points { 1, <1, 1, 0> } direction z } "
                                       "meter { points { 1, <2, 2.5, 1.5> } direction -y } ",
                                   settings);
    CHECK(found[0].values[0].value == Approx(54.738).epsilon(0.005));
    CHECK(found[0].values[1].value == Approx(47.7702).epsilon(0.005));
    CHECK(found[1].values[0].value == Approx(40.2509).epsilon(0.005));
    CHECK(found[2].values[0].value == Approx(35.0208).epsilon(0.005));
    CHECK(found[3].values[0].value == Approx(15.7995).epsilon(0.005));
}

TEST_CASE("a white sphere reflects as much light to every point", "[render]") {
    // After case 5.8 of CIE 171: the indirect part is flux times reflectance over the area times
    // what is absorbed, wherever the lamp is.
    const double flux = 4 * pi * 100, area = 16 * pi;
    for (const double reflects : {0.0, 0.2, 0.5, 0.8, 0.95}) {
        CAPTURE(reflects);
        const MeterValue found = read_one(
            "global_settings { integrator { path_traced bounces 400 } } sphere { 0, 2 "
            "hollow pigment { rgb 1 } finish { diffuse " +
                std::to_string(reflects) +
                " } } light_source { 0.5*y, 1 intensity candela(100) } meter { points { "
                "1, <0, -1.9999, 0> } direction y } ",
            0.004);
        const double direct = 100 / (2.4999 * 2.4999);
        CHECK(found.value ==
              Approx(direct + flux * reflects / (area * (1 - reflects))).epsilon(0.005));
    }
}

TEST_CASE("the glare of very many lamps is that of all of them", "[render]") {
    // 10,000 small spheres of 50 cd/m2 to 4000 cd/m2 on a grid, before a background of 30 cd/m2.
    const MeterValue found = read_one(
        "background { rgb 30 } #for (I, 0, 99) #for (J, 0, 99) sphere { <0.1*I - 4.95, 0.2 + "
        "0.05*J, 5>, 0.005 pigment { rgb 1 } finish { emission 50 + 40*mod(7*I + 3*J, "
        "100) } } #end #end meter { ugr direction z points { 1, <0, 0, 0> } }",
        0.001);
    const Sightline sight{Vec3(0, 0, 1), Vec3(0, 1, 0)};
    double sum = 0;
    for (int i = 0; i < 100; ++i)
        for (int j = 0; j < 100; ++j) {
            const Vec3 lamp(0.1 * i - 4.95, 0.2 + 0.05 * j, 5);
            const double bright = 50 + 40 * ((7 * i + 3 * j) % 100),
                         index = guth_index(sight, unit(lamp));
            sum += bright * bright * std::numbers::pi * 0.005 * 0.005 /
                   (dot(lamp, lamp) * index * index);
        }
    CHECK(found.value == Approx(unified_glare_rating(30, sum)).margin(0.1));
}

TEST_CASE("glare is rated as by its formulas", "[render]") {
    // Panels of 0.6 m by 0.6 m that face down, before a background of 30 cd/m2.
    const MeterValue ugr = read_one(
        "background { rgb 30 } #macro Panel(X, Z, L) polygon { 5, <X - 0.3, 1.8, Z - 0.3>, <X + "
        "0.3, "
        "1.8, Z - 0.3>, <X + 0.3, 1.8, Z + 0.3>, <X - 0.3, 1.8, Z + 0.3>, <X - 0.3, 1.8, Z - 0.3> "
        "pigment { rgb 1 } finish { emission L } } #end Panel(0, 3, 2000) Panel(1.2, 4.2, 1500) "
        "meter { ugr direction z points { 1, <0, 0, 0> } }",
        0.001);
    CHECK(ugr.value == Approx(14.3154).margin(0.06));
    // A light source of I candela counts as 200 I^2 / r^2.
    for (const double candela : {100.0, 1000.0}) {
        const double glare = 200 * candela * candela / 25;
        CHECK(read_one("background { rgb 30 } light_source { 5*z, rgb 1 intensity candela(" +
                           std::to_string(candela) +
                           ") } meter { ugr direction z points { 1, <0, 0, 0> } }",
                       0.001)
                  .value == Approx(8 * std::log10(0.25 / 30 * glare)).margin(0.02));
    }
    const std::string road =
        "background { rgb 1 } meter { \"road\" luminance eye <0, 1.5, 0> points { 1, <0, 20, -50> "
        "} } "
        "meter { threshold_increment road \"road\" direction <0, -sin(pi/180), cos(pi/180)> points "
        "{ "
        "1, <0, 1.5, 0> } } #for (I, 0, 2) #declare At = <3, 8, 17.875 + 25*I>; ";
    const auto rise = [&](const std::string& lamp) {
        MeasureSettings settings;
        settings.goal.error = 0.003;
        return read_meters(road + lamp + " #end", settings).at(1).values.at(0).value;
    };
    CHECK(rise("light_source { At, rgb 1 intensity candela(1000) }") ==
          Approx(9.13485).epsilon(2e-3));
    CHECK(
        rise("sphere { At - 0.05*y, 0.05 pigment { rgb 1 } luminaire { flux lumen(4000*pi) } }") ==
        Approx(9.13485).epsilon(0.02));
}

TEST_CASE("meters find the daylight of the sky's formula behind openings", "[render]") {
    const std::string roof =
        "difference { box { <-50, 3, -50>, <50, 3.0001, 50> } box { <-1, 2, -1>, <1, 4, 1> } } "
        "box { <-50, -1, -50>, <50, -0.01, 50> } #for (I, 0, 3) box { <-50, 0, 50>, <50, 3, 50.1> "
        "rotate 90*I*y } #end ";
    const std::string grey = "overcast zenith 5000 sun <40, 30> ground 0 ",
                      even = "uniform zenith 5000 ground 0 ",
                      factor = "meter { daylight_factor points { 1, ";
    struct Row {
        const char* name;
        std::string sky, scene, meter;
        double expected;
    };
    const Row rows[] = {
        {"free uniform sky", even, "", "meter { points { 1, <0, 0, 0> } }", 15708},
        {"uniform sky from the side", even, "", "meter { points { 1, <0, 0, 0> } direction x }",
         7853.98},
        {"free overcast sky", grey, "", "meter { points { 1, <0, 0, 0> } }", 12217.3},
        {"overcast from the side", grey, "", "meter { points { 1, <0, 0, 0> } direction x }",
         4840.22},
        {"with the ground", "overcast zenith 5000 sun <40, 30> ", "",
         "meter { points { 1, <0, 0, 0> } direction x }", 6061.95},
        {"below an opening", even, roof, factor + "<0, 0, 0> } }", 12.3318},
        {"beside it", even, roof, factor + "<1.5, 0, 1.5> } }", 6.26131},
        {"below it, overcast", grey, roof, factor + "<0, 0, 0> } }", 15.51},
        {"beside it, overcast", grey, roof, factor + "<1.5, 0, 1.5> } }", 7.14427},
        {"window", even, window, factor + "<0, 0, 0> } }", 8.29083},
        {"window, overcast", grey, window, factor + "<0, 0, 0> } }", 7.71234},
        // What is seen below the edge of an overhang.
        {"window with a horizontal mask", even,
         window + "box { <2.0001, 2.5, -90>, <3, 2.6, 90> } ", factor + "<0, 0, 0> } }", 4.63059},
        {"cylinder", even, "", "meter { cylindrical points { 1, <0, 0, 0> } }", 1.5708 * 5000}};
    for (const Row& row : rows) {
        CAPTURE(row.name);
        const MeterValue found = read_one("camera { location <0, 1, -1> } sky_luminance { " +
                                              row.sky + "} " + row.scene + row.meter,
                                          0.003);
        CHECK(found.value == Approx(row.expected).epsilon(0.005));
    }
}

TEST_CASE("a meter finds the daylight on both sides of a fin before a window", "[render]") {
    MeasureSettings settings;
    settings.samples = 900000;
    settings.threads = 1;
    const MeterValue found =
        read_meters(
            "camera { location <0, 1, -1> } sky_luminance { uniform zenith 5000 ground 0 } " +
                window +
                "box { <2.0001, -1, 0.5>, <3, 40, 0.6> } meter { daylight_factor points { "
                "1, <0, 0, 0> } }",
            settings)
            .at(0)
            .values.at(0);
    // The tolerance is more than twice the interval of 95 %.
    constexpr double expected = 7.45445;
    CHECK(found.error < 0.0025 * expected);
    CHECK(found.value == Approx(expected).epsilon(0.005));
}

TEST_CASE("the sun lights by its illuminance, and shadows have the width of its disc", "[render]") {
    const std::string sun =
        "sky_luminance { clear sun <90, 0> diffuse lux(0.001) direct lux(80000) ground 0 } ";
    CHECK(read_one(sun + at_origin, 0.003).value == Approx(80000).epsilon(0.003));
    CHECK(read_one(sun + "meter { points { 1, <0, 0, 0> } direction <0, 1, 1> }", 0.003).value ==
          Approx(80000 * std::sqrt(0.5)).epsilon(0.005));
    // An edge 100 m above: the disc is 0.9306 m wide there.
    const auto behind_edge = [&](double x) {
        return read_one(sun + "box { <" + std::to_string(x) +
                            ", 100, -500>, <500, 101, 500> pigment { rgb 0 } } " + at_origin,
                        0.003)
                   .value /
               80000;
    };
    CHECK(behind_edge(0) == Approx(0.5).epsilon(0.01));
    CHECK(behind_edge(-0.47) == Approx(0).margin(1e-3));
    CHECK(behind_edge(0.47) == Approx(1).epsilon(0.003));
    CHECK(behind_edge(0.2326) == Approx(0.8045).epsilon(0.01));
}

TEST_CASE("a meter says what a white wall shows a camera there", "[render]") {
    // Lamps, a mirror and a glass beside the point.
    const std::string things =
        "sphere { <1, 2, 1>, 0.1 pigment { rgb <1, 0.8, 0.5> } finish { emission 5000 } } "
        "box { <-2, 0, 1>, <-1.9, 3, 2> pigment { rgb 0.8 } finish { diffuse 0 reflection 0.8 } } "
        "box { <0.5, 0.8, -1>, <1, 1, 1> pigment { rgb <1, 0.5, 0.5> filter 0.8 } } "
        "box { <-4, -1, 3>, <4, 4, 3.1> pigment { rgb <0.3, 0.6, 0.9> } finish { diffuse 0.9 } } ";
    const MeterValue met = read_one(things + "meter { points { 1, <0, 0, 0> } }", 0.01);
    const MeterValue seen = read_one(
        things +
            "disc { 0, y, 0.001 pigment { rgb 1 } finish { diffuse 1 } } meter { luminance "
            "eye <0, 0.01, -0.01> points { 1, <0, 0, 0> } }",
        0.01);
    CHECK(met.value == Approx(pi * seen.value).epsilon(0.02));
}

TEST_CASE("intervals hold what is true, and threads change nothing", "[render]") {
    const std::string noisy =
        "sphere { <1, 2, 1>, 0.1 pigment { rgb 1 } finish { emission 5000 } } "
        "torus { 1, 0.1 rotate 90*x translate 1.5*z pigment { rgb 1 } finish { emission 100 } } "
        "box { <-4, -1, 3>, <4, 4, 3.1> pigment { rgb 0.6 } finish { diffuse 0.9 } } " +
        at_origin;
    const double truth = read_one(noisy, 0.0015).value;
    int held = 0;
    constexpr int trials = 200;
    for (int seed = 1; seed <= trials; ++seed) {
        MeasureSettings settings;
        settings.seed = seed;
        settings.samples = 256;
        const auto found = read_meters(noisy, settings).at(0);
        CHECK(found.samples == 256);
        held += std::abs(found.values[0].value - truth) <= found.values[0].error ? 1 : 0;
    }
    // 95 of 100 are wanted; 5 standard deviations of this count lie below.
    CHECK(held > 0.87 * trials);
    CHECK(held < trials);
    const auto with_threads = [&](int threads) {
        MeasureSettings settings;
        settings.threads = threads;
        settings.samples = 64;
        const auto found = read_meters(
            noisy + "meter { corner <-1, 0, -1> along 2*x across 2*z counts <5, 5> }", settings);
        std::vector<double> values;
        for (const MeterReading& reading : found)
            for (const MeterValue& each : reading.values) values.push_back(each.value);
        return values;
    };
    CHECK(with_threads(1) == with_threads(3));
}

TEST_CASE("lamps of the library send out the flux that is said of them", "[render]") {
    std::string sides;
    for (const char* axis : {"<1, 0, 0>", "<0, 1, 0>", "<0, 0, 1>"})
        for (const char* sign : {"1", "-1"})
            sides +=
                std::string("#declare A = 5*") + axis +
                "; #declare B = <A.y, A.z, A.x>; #declare C = <A.z, A.x, A.y>; meter { corner " +
                sign + "*A - B - C along 2*B across 2*C counts <16, 16> direction -" + sign +
                "*A } ";
    struct Row {
        std::string lamp;
        double flux, least;  ///< fraction that the housing lets go straight on
    };
    const Row rows[] = {{"Luminaire_Bulb(806, 2700)", 806, 0.94},
                        {"Luminaire_Candle()", 13, 0.93},
                        {"Luminaire_Downlight(900, 3000)", 900, 0.93},
                        {"Luminaire_Spot(2000, 3000)", 2000, 0.88},
                        {"Luminaire_Panel(0.6, 0.6, 3600, 4000)", 3600, 0.99},
                        {"Luminaire_Tube(1.2, 1800, 4000)", 1800, 0.76},
                        {"Luminaire_Pendant(1.5, 5200, 4000)", 5200, 0.97},
                        {"Luminaire_Strip(-x, x, 500, 3000)", 1000, 0.99},
                        {"Luminaire_String(array[2] { -x, x }, 0.1, 0.5, 30, 2200)", 120, 0.92},
                        {"Luminaire_Street(3, 0.5, 9000, 3000)", 9000, 0.97},
                        {"Luminaire_Flood(60000, 5700)", 60000, 0.99}};
    MeasureSettings settings;
    settings.samples = 128;
    for (const Row& row : rows) {
        CAPTURE(row.lamp);
        double flux = 0;
        for (const MeterReading& reading : read_meters(
                 "#include \"luminaires.inc\" object { " + row.lamp + " } " + sides, settings))
            flux += reading.summary.mean.value * reading.area;
        CHECK(flux / row.flux < 1.01);
        CHECK(flux / row.flux > row.least);
    }
}

TEST_CASE("a table of a road's reflection has the luminance of EN 13201", "[render]") {
    const auto road = [](const std::string& table, const std::string& point) {
        return "meter { \"road\" luminance eye <-60, 1.5, 0> road_table "
               "\"tests/meter/files/" +
               table + "\" points { 1, " + point + " } } ";
    };
    // A lamp 8 metres above the road with 1500 cd in all directions: I r / H^2.
    const std::string source = "light_source { <0, 8, 0>, 1 intensity candela(1500) } ";
    const std::string ball =
        "sphere { <0, 8, 0>, 0.01 pigment { rgb 1 } luminaire { flux lumen(4*pi*1500) } } ";
    const std::string plane = "plane { y, 0 pigment { rgb 0.5 } } ";
    for (const std::string& lamp : {source, ball}) {
        CAPTURE(lamp);
        // Light from behind the observer, which falls on <10, 0, 3> beyond the lamp.
        CHECK(read_one(lamp + road("even_road.csv", "<10, 0, 3>"), 0.005).value ==
              Approx(0.28125).epsilon(0.01));
        CHECK(read_one(plane + lamp + road("even_road.csv", "<10, 0, 3>"), 0.005).value ==
              Approx(0.28125).epsilon(0.01));
        // From ahead it is as the way from 0 to 12 of the tangent, which is 1.
        CHECK(read_one(lamp + road("even_road.csv", "<-8, 0, 0>"), 0.005).value ==
              Approx(0.28125 * (1 + 1.0 / 12)).epsilon(0.01));
        // A Lambertian road of q = 0.07 has 0.07 of the illuminance; its tangent is 2 here.
        CHECK(read_one(lamp + road("lambertian_road.csv", "<0, 0, 16>"), 0.005).value ==
              Approx(0.07 * 1500 / 64 * std::pow(5, -1.5)).epsilon(0.01));
        // Beyond the table, and behind a wall, there is no light.
        CHECK(read_one(lamp + road("even_road.csv", "<0, 0, 97>"), 0.005).value == 0);
        CHECK(
            read_one(lamp + "box { <-1, 0, 4>, <1, 9, 5> } " + road("even_road.csv", "<0, 0, 16>"),
                     0.005)
                .value == 0);
    }
}

TEST_CASE("meters receive no light of light groups, which lights their objects only", "[render]") {
    const std::string lamp = "light_source { <0, 1, 5>, 1 intensity candela(1500) } ",
                      object = "sphere { 90*y, 1 } ";
    const std::string meters =
        "meter { \"road\" luminance eye <-60, 1.5, 0> road_table "
        "\"tests/meter/files/even_road.csv\" points { 1, <0, 0, 0> } } "
        "meter { threshold_increment road \"bright\" direction z points { 1, 0 } } "
        "meter { ugr direction z points { 1, 0 } } meter { points { 1, 0 } direction z } "
        "meter { \"bright\" luminance points { 1, 0 } direction -z } background { rgb 1 } ";
    MeasureSettings settings;
    settings.samples = 16;
    const auto readings = [&](const std::string& lights) {
        std::vector<double> values;
        for (const MeterReading& each : read_meters(lights + meters, settings))
            values.push_back(each.values.at(0).value);
        return values;
    };
    const std::vector<double> without = readings(object);
    CHECK(readings("light_group { " + lamp + object + "} ") == without);
    CHECK(readings(lamp + object)[0] > 0.1);
    CHECK(readings(lamp + object)[1] > without[1]);
    CHECK(readings(lamp + object)[2] > without[2]);
}

TEST_CASE("a grid tells its flux, and how long it was measured", "[render]") {
    // All light of a lamp goes through the sides of a box around it.
    const std::string lamp = "sphere { 0, 0.1 pigment { rgb 1 } luminaire { flux lumen(1000) } } ";
    std::string sides;
    for (const char* axis : {"<1, 0, 0>", "<0, 1, 0>", "<0, 0, 1>"})
        for (const char* sign : {"1", "-1"})
            sides +=
                std::string("#declare A = ") + axis +
                "; #declare B = <A.y, A.z, A.x>; #declare C = <A.z, A.x, A.y>; meter { corner " +
                sign + "*A - B - C along 2*B across 2*C counts <24, 24> direction -" + sign +
                "*A } ";
    double flux = 0;
    for (const MeterReading& reading : read_meters(lamp + sides)) {
        CHECK(reading.area == Approx(4));
        CHECK(reading.reached);
        flux += reading.summary.mean.value * reading.area;
    }
    CHECK(flux == Approx(1000).epsilon(0.005));
    int rounds = 0;
    MeasureSettings settings;
    settings.goal.error = 1e-9;
    settings.ended = [&] { return ++rounds == 3; };
    const auto ended = read_meters(
        "torus { 1, 0.1 translate 2*y pigment { rgb 1 } finish { emission "
        "100 } } " +
            at_origin,
        settings);
    CHECK(rounds == 3);
    CHECK(ended[0].samples == 16 * 16);
    CHECK_FALSE(ended[0].reached);
}

TEST_CASE("points inside of objects are left out, and those of rooms and of glass are not",
          "[render]") {
    const std::string lamp = "light_source { 3*y, 1 intensity candela(100) } ";
    const std::string row = "meter { points { 3, <-1, 0.1, 0>, <0, 0.1, 0>, <1, 0.1, 0> } } ";
    struct Row {
        const char* name;
        const char* objects;
        std::vector<std::size_t> left_out;
    };
    const Row rows[] = {
        {"nothing", "", {}},
        {"a book", "box { <-0.2, 0, -0.2>, <0.2, 0.3, 0.2> }", {1}},
        {"half a ball", "difference { sphere { 0, 0.5 } box { <-1, -1, -1>, <1, 0, 1> } }", {1}},
        {"a shadow", "box { <-0.2, 0.2, -0.2>, <0.2, 0.3, 0.2> }", {}},
        {"glass", "box { <-0.2, 0, -0.2>, <0.2, 0.3, 0.2> pigment { rgbt 1 } }", {}},
        {"a room", "box { -4, 4 } box { <-1.2, 0.2, -0.2>, <0.2, 0.3, 0.2> }", {}},
        {"all", "box { <-2, 0, -1>, <2, 1, 1> }", {0, 1, 2}},
    };
    for (const Row& each : rows) {
        const MeterReading reading = read_meters(lamp + row + each.objects).at(0);
        CAPTURE(each.name);
        CHECK(reading.left_out == each.left_out);
        if (each.left_out.size() == 1) {
            CHECK(reading.summary.min.value == Approx(reading.values[0].value));
            CHECK(reading.summary.uo.value == Approx(1));
            CHECK(reading.summary.greatest != 1);
        }
    }
    CHECK(read_meters(lamp + row + "box { <-2, 0, -1>, <2, 1, 1> }").at(0).summary.mean.value == 0);
}

TEST_CASE("a caustic on a meter is the same with photons and without", "[render]") {
    const std::string script =
        "sphere { 4*y, 0.6 finish { emission 100 } pigment { rgb 1 } } "
        "sphere { 1.5*y, 0.8 pigment { rgbt 1 } finish { reflection { 0, 1 fresnel } } interior { "
        "ior 1.5 } PHOTONS } "
        "meter { corner <-0.2, 0, -0.2> along 0.4*x across 0.4*z counts <3, 3> } ";
    const auto mean = [&](const std::string& settings, const std::string& photons, int samples) {
        std::string made = settings + script;
        made.replace(made.find("PHOTONS"), 7, photons);
        MeasureSettings to;
        to.samples = samples;
        return read_meters(made, to).at(0).summary.mean;
    };
    const MeterValue paths = mean("", "", 4096),
                     photons = mean("global_settings { photons { count 1000 } } ",
                                    "photons { target reflection on refraction on }", 4096);
    CAPTURE(paths.value, paths.error, photons.value, photons.error);
    CHECK(paths.error < 0.05 * paths.value);
    CHECK(photons.error < 0.05 * photons.value);
    CHECK(std::abs(paths.value - photons.value) < 1.5 * (paths.error + photons.error));
}

}  // namespace candelabra

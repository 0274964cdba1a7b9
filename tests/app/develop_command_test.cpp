// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/develop_command.h"

#include "output/light_file.h"
#include "picture/formats.h"
#include "picture/layers.h"
#include "picture/read.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

constexpr auto filmed_scene = R"(#version 3.7;
camera { location <0, 1, -5> look_at 0 right 10/9*x
  film { exposure 0.5 response agx pixel_filter mitchell white_balance 5000 vignette 0.2
         glare { veil 0.2 halo 0.02 star 0.05 blades 5 angle 9 } } }
sphere { <0.3, 1.2, 0>, 0.4 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 30 } }
plane { y, -1 pigment { checker rgb 1, rgb <1, 0, 0> } finish { ambient 0 } }
)";

struct DevelopRun : Shell {
    DevelopRun() { write("film.pov", filmed_scene); }

    std::string picture(const std::string& name, std::vector<std::string> more = {}) {
        more.insert(more.end(), {path("film.pov"), "-V", "+W40", "+H36", "+O" + path(name)});
        INFO(name);
        CHECK((*this)(more) == 0);
        CHECK(err == "");
        return content(name);
    }
    std::string developed(const std::string& from, std::vector<std::string> more = {}) {
        more.insert(more.begin(), {"develop", path(from), "-o", path("developed.png")});
        CHECK((*this)(more) == 0);
        CHECK(err == "");
        return content("developed.png");
    }
    /// Writes a file as other programs do.
    void write_planes(const std::string& name, const std::vector<std::string>& planes) {
        LayeredPicture picture{2, 1, {}, {}};
        float value = 0.125f;
        for (const std::string& plane : planes) {
            picture.planes.push_back(
                {plane, false, {std::bit_cast<std::uint32_t>(value), 0x3f800000u}});
            value *= 2;
        }
        Diagnostics diagnostics;
        write(name, encode(picture, diagnostics).value());
    }
};

const std::vector<std::string> some_samples = {"--samples", "5"};

}  // namespace

TEST_CASE("what is developed later has the bytes of what was developed at once", "[app][film]") {
    DevelopRun darkroom;
    const std::string at_once = darkroom.picture("a.png", some_samples);
    darkroom.picture("a.exr", some_samples);
    CHECK(darkroom.developed("a.exr") == at_once);
    CHECK(darkroom.developed("a.exr", {"--exposure", "2"}) != at_once);
    for (const std::vector<std::string>& film :
         std::vector<std::vector<std::string>>{{"--exposure", "auto"},
                                               {"--response", "linear", "--glare", "off"},
                                               {"--response", "filmic", "--grain", "0.1"},
                                               {"--white-balance", "0", "--vignette", "0"}}) {
        std::vector<std::string> options = some_samples;
        options.insert(options.end(), film.begin(), film.end());
        const std::string wanted = darkroom.picture("b.png", options);
        darkroom.picture("b.exr", options);
        INFO(film[0] << ' ' << film[1]);
        CHECK(darkroom.developed("b.exr") == wanted);
    }
    // With layers, the light is also stored beside the picture; an alpha channel is kept.
    std::vector<std::string> layers = some_samples;
    layers.insert(layers.end(), {"+UA", "--layers", "albedo,lights"});
    const std::string with_alpha = darkroom.picture("c.png", layers);
    CHECK(darkroom.developed("c.layers.exr") == with_alpha);
    CHECK(darkroom.developed("c.layers.exr", {"--layer", "albedo"}) != with_alpha);
}

TEST_CASE("a picture with a film does not depend on shards, threads and stops", "[app][film]") {
    DevelopRun darkroom;
    const std::vector<std::string> samples = {"--samples", "24"};
    const std::string whole = darkroom.picture("a.png", samples);
    for (const char* shard : {"1/3", "2/3", "3/3"}) {
        std::vector<std::string> more = samples;
        more.insert(more.end(), {"--shard", shard});
        darkroom.picture("b.png", more);
    }
    REQUIRE(darkroom({"merge", darkroom.path("b.png.1of3.state.exr"),
                      darkroom.path("b.png.2of3.state.exr"), darkroom.path("b.png.3of3.state.exr"),
                      "+O" + darkroom.path("b.png")}) == 0);
    CHECK(darkroom.content("b.png") == whole);
    darkroom.picture("c.png", {"--samples", "7", "--keep-state"});
    CHECK(darkroom.picture("c.png", {"--samples", "24", "+C", "+WT3"}) == whole);
    // A different film would have needed different samples.
    CHECK(darkroom({darkroom.path("film.pov"), "-V", "+W40", "+H36", "--samples", "24", "+C",
                    "--exposure", "3", "+O" + darkroom.path("b.png")}) == 0);
    darkroom.picture("d.png", {"--samples", "7", "--keep-state"});
    CHECK(darkroom({darkroom.path("film.pov"), "-V", "+W40", "+H36", "--samples", "24", "+C",
                    "--exposure", "3", "+O" + darkroom.path("d.png")}) != 0);
    CHECK(has(darkroom.err, "exposure was "));
}

TEST_CASE("light that is developed without its film is clipped", "[app][film]") {
    DevelopRun darkroom;
    darkroom.picture("filmed.exr", some_samples);
    const std::string plain = darkroom.developed("filmed.exr", {"--film", "off"});
    const std::vector<std::string> neutral = {"--exposure",      "0",  "--response", "linear",
                                              "--white-balance", "0",  "--vignette", "0",
                                              "--glare",         "off"};
    CHECK(plain == darkroom.developed("filmed.exr", neutral));
    CHECK(plain != darkroom.developed("filmed.exr"));
}

TEST_CASE("a film that changes nothing makes the picture that there is without", "[app][film]") {
    Shell shell;
    const auto pixels = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"-V", "+FP", "+O" + shell.path("a.ppm")});
        REQUIRE(shell.render(more) == 0);
        const std::string bytes = shell.content("a.ppm");
        return bytes.substr(bytes.size() - 16 * 12 * 3);
    };
    CHECK(pixels({"--film", "on"}) == pixels({}));
    CHECK(pixels({"--film", "on", "--exposure", "1"}) != pixels({}));
    DevelopRun darkroom;
    darkroom.picture("on.exr", {"--samples", "2", "--pixel-filter", "box"});
    darkroom.picture("off.exr", {"--samples", "2", "--film", "off"});
    Diagnostics diagnostics;
    const auto on = read_layers(darkroom.path("on.exr"), {}, diagnostics),
               off = read_layers(darkroom.path("off.exr"), {}, diagnostics);
    REQUIRE((on && off));
    CHECK(off->planes.size() == 3);
    CHECK(on->planes.size() == 6);
    // Both store the scene's radiance.
    for (std::size_t i = 0; i < 3; ++i) CHECK(on->planes[i].bits == off->planes[i].bits);
}

TEST_CASE("edges of lamps are smooth where the response ends", "[app][film]") {
    Shell shell;
    shell.write("lamp.pov", R"(#version 3.7;
camera { location -5*z film { response agx } }
sphere { 0, 1.5 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 10000 } }
)");
    const auto shades = [&](const std::string& smooth) {
        REQUIRE(shell({shell.path("lamp.pov"), "-V", "+W40", "+H30", "--samples", "64",
                       "--smooth-edges", smooth, "+O" + shell.path("a.ppm")}) == 0);
        const std::string bytes = shell.content("a.ppm");
        int between = 0;
        for (std::size_t i = bytes.size() - 40 * 30 * 3; i < bytes.size(); i += 3) {
            const auto shade = static_cast<unsigned char>(bytes[i]);
            between += shade > 30 && shade < 225;
        }
        return between;
    };
    CHECK(shades("on") > 40);
    CHECK(shades("off") < 10);
}

TEST_CASE("frames of an animation are exposed without flicker, and have grains of their own",
          "[app][film]") {
    Shell shell;
    shell.write("blink.pov", R"(#version 3.7;
camera { location <0, 1, -5> look_at 0 film { exposure auto } }
sphere { <clock - 1, 1, 0>, 0.1 pigment { rgb 1 }
         finish { ambient 0 diffuse 0 emission 40 + 20 * sin(frame_number * 9) } }
light_source { <3, 5, -5>, 0.2 }
plane { y, -1 pigment { rgb 0.5 } finish { ambient 0.1 } }
)");
    REQUIRE(shell({shell.path("blink.pov"), "-V", "+W32", "+H24", "--samples", "4", "+KFF6",
                   "+O" + shell.path("f.ppm")}) == 0);
    double before = -1;
    for (int frame = 1; frame <= 6; ++frame) {
        const std::string bytes = shell.content("f" + std::to_string(frame) + ".ppm");
        REQUIRE(bytes.size() > 32 * 24 * 3);
        // The ground at the bottom, away from the lamp.
        double sum = 0;
        for (std::size_t i = bytes.size() - 32 * 3 * 3; i < bytes.size(); ++i)
            sum += static_cast<unsigned char>(bytes[i]);
        const double shade = sum / (32 * 3 * 3);
        if (before >= 0) CHECK(std::abs(shade - before) < 4);
        before = shade;
    }
    REQUIRE(shell({shell.path("blink.pov"), "-V", "+W32", "+H24", "--samples", "4", "+KFF2",
                   "--grain", "0.2", "--exposure", "0", "+O" + shell.path("g.exr")}) == 0);
    Diagnostics diagnostics;
    constexpr auto texts = std::array{std::string_view("candelabraFilm")};
    CHECK(read_layers(shell.path("g1.exr"), texts, diagnostics)->texts[0].second ==
          "film=on grain=0.2 grain_seed=1");
    CHECK(read_layers(shell.path("g2.exr"), texts, diagnostics)->texts[0].second ==
          "film=on grain=0.2 grain_seed=2");
}

TEST_CASE("an alpha of any numbers is developed", "[app][film]") {
    DevelopRun darkroom;
    const float infinite = std::numeric_limits<float>::infinity();
    const std::array alphas = {infinite, 7.0F, 0.5F, -1.0F, std::nanf(""), -infinite};
    LayeredPicture picture{static_cast<int>(alphas.size()), 1, {}, {}};
    for (const char* name : {"R", "G", "B"})
        picture.planes.push_back(
            {name, false, std::vector(alphas.size(), std::bit_cast<std::uint32_t>(0.25F))});
    picture.planes.push_back({"A", false, {}});
    for (const float alpha : alphas)
        picture.planes.back().bits.push_back(std::bit_cast<std::uint32_t>(alpha));
    Diagnostics diagnostics;
    darkroom.write("a.exr", encode(picture, diagnostics).value());
    darkroom.developed("a.exr");
    const auto made =
        read_stored({"developed.png", darkroom.content("developed.png")}, diagnostics, {});
    REQUIRE(made);
    // Alpha is raised where the colour exceeds it.
    CHECK(made->alpha[0] == 1);
    CHECK(made->alpha[1] == 1);
    CHECK(made->alpha[2] < 0.6F);
    for (std::size_t i = 3; i < alphas.size(); ++i) CHECK(made->alpha[i] < made->alpha[2]);
}

TEST_CASE("any OpenEXR file with colours is developed", "[app][film]") {
    DevelopRun darkroom;
    const auto shades = [&](std::vector<std::string> more = {}) {
        more.insert(more.begin(),
                    {"develop", darkroom.path("x.exr"), "+FP", "-o", darkroom.path("x.ppm")});
        CHECK(darkroom(more) == 0);
        const std::string bytes = darkroom.content("x.ppm");
        std::vector<int> result;
        for (const char byte : bytes.substr(bytes.size() - 6))
            result.push_back(static_cast<unsigned char>(byte));
        return result;
    };
    darkroom.write_planes("x.exr", {"B", "G", "R"});
    CHECK(shades() == std::vector<int>{188, 137, 99, 255, 255, 255});
    CHECK(shades({"--exposure", "-1"}) == std::vector<int>{137, 99, 71, 188, 188, 188});
    darkroom.write_planes("x.exr", {"Y"});
    CHECK(shades() == std::vector<int>{99, 99, 99, 255, 255, 255});
    darkroom.write_planes("x.exr", {"Render.Combined.B", "Render.Combined.G", "Render.Combined.R"});
    CHECK(shades() == std::vector<int>{188, 137, 99, 255, 255, 255});
    darkroom.write_planes("x.exr", {"B", "G", "R", "light.Lamp.B", "light.Lamp.G", "light.Lamp.R"});
    CHECK(shades({"--layer", "light.Lamp", "--exposure=-4"}) ==
          std::vector<int>{137, 99, 71, 71, 71, 71});
    CHECK(darkroom({"develop", darkroom.path("x.exr"), "--layer", "light.Lomp"}) == 3);
    CHECK(has(darkroom.err, "has no layer `light.Lomp` of colours"));
    CHECK(has(darkroom.err, "did you mean `light.Lamp`?"));
    darkroom.write_planes("x.exr", {"depth"});
    CHECK(darkroom({"develop", darkroom.path("x.exr")}) == 3);
    CHECK(has(darkroom.err, "has no colours"));
}

namespace {

constexpr auto two_lamps = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 1, -5> look_at 0 film { response agx glare { veil 0.1 } } }
plane { y, -1 pigment { rgb 0.7 } }
#declare Top = sphere { <0, 2, 0>, 0.4 pigment { rgb 1 } finish { diffuse 0 emission 8 } }
#declare Low = sphere { <2, 0, 0>, 0.4 pigment { rgb <1, 0.5, 0> } finish { diffuse 0 emission 5 } }
#ifndef (No_Top) object { Top } #end
object { Low }
)";

}  // namespace

TEST_CASE("develop lights pictures anew by the layers of light", "[app][film]") {
    DevelopRun darkroom;
    darkroom.write("two.pov", two_lamps);
    const auto light = [&](const std::string& name, const std::vector<std::string>& more = {}) {
        std::vector<std::string> words = {
            darkroom.path("two.pov"),  "-V", "+W24", "+H18", "--samples", "4",
            "+O" + darkroom.path(name)};
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(darkroom(words) == 0);
    };
    light("two.exr", {"--layers", "lights"});
    const std::string as_it_is = darkroom.developed("two.exr");
    CHECK(darkroom.developed("two.exr", {"--light", "Top=1", "--light=Low=#fff"}) == as_it_is);
    const std::string dimmed = darkroom.developed("two.exr", {"--light", "Top=0.2,#ff8800"});
    CHECK(dimmed != as_it_is);
    darkroom.write("set.json", R"({"Top": "0.2,#ff8800"})");
    CHECK(darkroom.developed("two.exr", {"--lights", darkroom.path("set.json")}) == dimmed);

    // Frames by the rows of a table, from one file.
    darkroom.write("set.csv", "Top,Low\n1,1\n0.2 #ff8800,1\n");
    fs::create_directory(darkroom.path("out"));
    CHECK(darkroom({"develop", darkroom.path("two.exr"), "-o", darkroom.path("out"), "--lights",
                    darkroom.path("set.csv")}) == 0);
    CHECK(darkroom.content("out/two1.png") == as_it_is);
    CHECK(darkroom.content("out/two2.png") == dimmed);
    CHECK(darkroom({"develop", darkroom.path("two.exr"), darkroom.path("two.exr"),
                    darkroom.path("two.exr"), "--lights", darkroom.path("set.csv")}) == 2);
    CHECK(has(darkroom.err, "has 2 frames, and there are 3 files"));

    CHECK(darkroom({"develop", darkroom.path("two.exr"), "--light", "Tap=0"}) == 3);
    CHECK(has(darkroom.err, "there is no light of `Tap` in the file"));
    CHECK(has(darkroom.err, "did you mean `Top`? there are Low, Top, rest"));
    CHECK(darkroom({"develop", darkroom.path("two.exr"), "--light", "Top=0", "--layer",
                    "light.Low"}) == 3);
    CHECK(has(darkroom.err, "weights change the picture"));
    CHECK(darkroom({"develop", darkroom.path("two.exr"), "--light", "Top"}) == 2);
    light("plain.exr");
    CHECK(darkroom({"develop", darkroom.path("plain.exr"), "--light", "Top=0"}) == 3);
    CHECK(has(darkroom.err, "render it with --layers lights"));
}

TEST_CASE("a lamp of weight 0 is not there", "[app][film]") {
    DevelopRun darkroom;
    darkroom.write("two.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
        camera { location <0, 1, -5> look_at 0 film { response linear } }
        plane { y, -1 pigment { rgb 0.7 } }
        #declare Top = light_source { <0, 3, -2>, rgb <0.3, 0.2, 0.1> }
        #declare Low = light_source { <3, 1, -1>, rgb <0.1, 0.3, 0.4> }
        light_source { Top }
        #ifndef (No_Low) light_source { Low } #end)");
    const auto light = [&](const std::string& name, const std::string& more) {
        REQUIRE(darkroom({darkroom.path("two.pov"), "-V", "+W24", "+H18", "-A", "--layers",
                          "lights", "+O" + darkroom.path(name), more}) == 0);
    };
    light("both.exr", "+Q9");
    light("top.exr", "Declare=No_Low=1");
    // PNG files tell how they were made, too.
    const auto shades = [&](const std::string& from, const std::vector<std::string>& more) {
        std::vector<std::string> words = {"develop", darkroom.path(from), "-o",
                                          darkroom.path("shades.ppm")};
        words.insert(words.end(), more.begin(), more.end());
        REQUIRE(darkroom(words) == 0);
        const std::string bytes = darkroom.content("shades.ppm");
        REQUIRE(bytes.size() > 24 * 18 * 3);
        return bytes.substr(bytes.size() - 24 * 18 * 3);
    };
    CHECK(shades("both.exr", {"--light", "Low=0"}) == shades("top.exr", {}));
    CHECK(shades("both.exr", {}) != shades("top.exr", {}));
}

TEST_CASE("develop joins pictures to a movie", "[app][film]") {
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) return;
    DevelopRun darkroom;
    darkroom.write("two.pov", two_lamps);
    REQUIRE(darkroom({darkroom.path("two.pov"), "-V", "+W16", "+H12", "--layers", "lights",
                      "+O" + darkroom.path("two.exr")}) == 0);
    darkroom.write("set.csv", "Top,Low\n1,1\n0,1\n");
    CHECK(darkroom({"develop", darkroom.path("two.exr"), "--lights", darkroom.path("set.csv"),
                    "--movie", darkroom.path("film.gif"), "--frame-rate", "10"}) == 0);
    CHECK(darkroom.err == "");
    CHECK(darkroom.content("film.gif").starts_with("GIF"));
    int files = 0;
    for (const auto& each : fs::directory_iterator(darkroom.folder))
        files += each.path().extension() == ".png";
    CHECK(files == 0);
}

TEST_CASE("pictures lie beside their light, or in a folder", "[app][film]") {
    DevelopRun darkroom;
    darkroom.write_planes("x.exr", {"B", "G", "R"});
    darkroom.write_planes("y.exr", {"B", "G", "R"});
    CHECK(darkroom({"develop", darkroom.path("x.exr"), darkroom.path("y.exr")}) == 0);
    CHECK(fs::exists(darkroom.path("x.png")));
    CHECK(fs::exists(darkroom.path("y.png")));
    fs::create_directory(darkroom.path("out"));
    CHECK(darkroom({"develop", darkroom.path("x.exr"), darkroom.path("y.exr"), "+FJ", "-o",
                    darkroom.path("out")}) == 0);
    CHECK(fs::exists(darkroom.path("out/x.jpg")));
    CHECK(fs::exists(darkroom.path("out/y.jpg")));
    CHECK(darkroom({"develop", darkroom.path("x.exr"), darkroom.path("y.exr"), "-o",
                    darkroom.path("z.png")}) == 2);
    CHECK(has(darkroom.err, "several pictures cannot go to one file"));
}

TEST_CASE("develop says what it cannot do", "[app][film]") {
    DevelopRun darkroom;
    CHECK(darkroom({"develop", "--help"}) == 0);
    CHECK(has(darkroom.out, "usage: candelabra develop"));
    CHECK(darkroom({"develop"}) == 2);
    CHECK(has(darkroom.err, "develop needs a picture that has kept its light"));
    CHECK(darkroom({"develop", darkroom.path("no.exr")}) == 3);
    CHECK(darkroom({"develop", darkroom.path("film.pov")}) == 2);
    CHECK(has(darkroom.err, "is no OpenEXR file by its name"));
    darkroom.write("bad.exr", "nonsense");
    CHECK(darkroom({"develop", darkroom.path("bad.exr")}) == 3);
    darkroom.write_planes("x.exr", {"B", "G", "R"});
    CHECK(darkroom({"develop", darkroom.path("x.exr"), "-o", darkroom.path("y.hdr")}) == 3);
    CHECK(has(darkroom.err, "keeps the light"));
    CHECK(darkroom({"develop", darkroom.path("x.exr"), "+W99"}) == 0);
    CHECK(has(darkroom.err, "`Width=99` is ignored: nothing is rendered any more"));
    CHECK(darkroom({"develop", darkroom.path("x.exr"), "--response", "kodak"}) == 2);
    CHECK(darkroom({"develop", darkroom.path("x.exr"), "--glare", "veil=0.7", "--glare",
                    "star=0.6"}) == 3);
    CHECK(has(darkroom.err, "the options do not fit the film"));
}

TEST_CASE("numbers of light are shown in false colours") {
    DevelopRun darkroom;
    darkroom.write("lit.pov",
                   "#version 3.7; global_settings { photometry { unit 1 white 100 } } "
                   "camera { orthographic location y direction -y right x up z } "
                   "light_source { 2*y, rgb 1 intensity candela(400) } "
                   "plane { y, 0 pigment { rgb 0.5 } finish { ambient 0 diffuse 1 } }");
    REQUIRE(darkroom({darkroom.path("lit.pov"), "-V", "+W9", "+H9", "-A", "--layers",
                      "illuminance,luminance", "+O" + darkroom.path("lit.exr")}) == 0);
    Diagnostics diagnostics;
    const auto light = LightFile::read(darkroom.path("lit.exr"), diagnostics);
    REQUIRE(light);
    // 400 cd at 2 m are 100 lux, and grey of 0.5 shows them as 50 / pi.
    CHECK(light->image("illuminance")->at(4, 4).r == Approx(100).epsilon(1e-3));
    CHECK(light->image("luminance")->at(4, 4).r == Approx(50 / 3.14159265).epsilon(1e-3));
    const std::string picture = darkroom.path("lit.png");
    CHECK(darkroom({"develop", darkroom.path("lit.exr"), "--false-colour", "lux", "--isolines",
                    "--scale=200", "-o", picture}) == 0);
    CHECK(fs::file_size(picture) > 0);
    CHECK(darkroom({"develop", darkroom.path("lit.exr"), "--isolines"}) == 2);
    CHECK(has(darkroom.err, "a scale and isolines belong to false colours"));
    CHECK(darkroom({"develop", darkroom.path("lit.exr"), "--false-colour", "red"}) == 2);
    CHECK(has(darkroom.err, "`red` cannot be shown in false colours"));
    CHECK(darkroom({"develop", darkroom.path("lit.exr"), "--false-colour", "lux", "--scale",
                    "x"}) ==
          2);
    CHECK(has(darkroom.err, "`--scale` needs a number above 0"));
    darkroom.write_planes("x.exr", {"B", "G", "R"});
    const std::string without = darkroom.path("x.exr");
    CHECK(darkroom({"develop", without, "--false-colour", "nit", "-o", picture}) == 3);
    CHECK(has(darkroom.err, "has no layer `luminance`"));
}

}  // namespace candelabra

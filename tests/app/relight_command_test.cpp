// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/relight_command.h"

#include "output/light_file.h"
#include "support/rgb.h"
#include "support/shell.h"
#include "text/message.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

namespace candelabra {

namespace {

/// Three lamps over a floor, beside a mirror. `Key`, `Sign` and `Row` are the factors on them.
constexpr auto room_of_lamps = R"(#version 3.7; global_settings { assumed_gamma 1 EXTRA }
#ifndef (Key) #declare Key = 1; #end
#ifndef (Sign) #declare Sign = rgb 1; #end
#ifndef (Row) #declare Row = 1; #end
camera { location <0, 2, -6> look_at <0, 0.5, 0> right x up y }
plane { y, 0 pigment { rgb <0.8, 0.7, 0.6> } finish { ambient 0 diffuse 0.8 } }
box { <-3, 0, 2>, <3, 3, 2.1> pigment { rgb 1 } finish { ambient 0 diffuse 0.2 reflection 0.7 } }
#macro Glow(Light) pigment { rgb 1 } finish { ambient 0 diffuse 0 emission Light } #end
#declare KeyLamp = sphere { <-1.5, 1.5, 0>, 0.4 Glow(rgb 4*Key) }
#declare SignLamp = box { <0.6, 0.6, -0.5>, <1.4, 1.2, -0.4> Glow(4*Sign) }
object { KeyLamp }
object { SignLamp }
#declare RowLamp = sphere { 0, 0.08 Glow(rgb 9*Row) }
union {
  #for (I, -4, 4) object { RowLamp translate <0.4*I, 0.1, -1.5> } #end
  light_name "Row"
}
MORE
)";

std::string with(std::string text, const std::string& word, const std::string& by) {
    return text.replace(text.find(word), word.size(), by);
}

struct Relit : Shell {
    Image light(const std::string& name) {
        Diagnostics diagnostics;
        const auto file = LightFile::read(path(name), diagnostics);
        REQUIRE(file);
        return *file->image("");
    }
    Image rendered(const std::string& samples, std::vector<std::string> more) {
        more.insert(more.begin(), {path("room.pov"), "-V", "+W24", "+H24", "--samples", samples,
                                   "+O" + path("room.exr")});
        REQUIRE((*this)(more) == 0);
        CHECK(err == "");
        return light("room.exr");
    }
    Image relit(std::vector<std::string> more) {
        more.insert(more.begin(), {"relight", path("room.lights"), "-o", path("relit.exr")});
        const int status = (*this)(more);
        CHECK(err == "");
        REQUIRE(status == 0);
        return light("relit.exr");
    }
};

/// Root of the mean square of the differences, in terms of the mean.
double error_of(const Image& made, const Image& right) {
    double squares = 0, sum = 0;
    for (std::size_t i = 0; i < made.pixels.size(); ++i) {
        const Rgb off = made.pixels[i] - right.pixels[i];
        squares += length(off) * length(off) / 3;
        sum += grey(right.pixels[i]);
    }
    const auto count = static_cast<double>(made.pixels.size());
    return std::sqrt(squares / count) / (sum / count);
}

}  // namespace

TEST_CASE("relit pictures are those of a render with other powers", "[app][relight]") {
    struct Place {
        const char *name, *extra, *more;
    };
    for (const Place& place :
         {Place{"direct", "", ""}, Place{"bounces", "integrator { path_traced }", ""},
          Place{"air", "",
                "box { -4, 4 hollow pigment { rgbt 1 } interior { media { scattering { 1, 0.05 } } "
                "} }"}}) {
        INFO(place.name);
        Relit run;
        run.write("room.pov", with(with(room_of_lamps, "EXTRA", place.extra), "MORE", place.more));
        const Image same = run.rendered("128", {"--keep-lights", run.path("room.lights")});
        const Image again = run.relit({});
        double most = 0, brightest = 0;
        for (std::size_t i = 0; i < same.pixels.size(); ++i) {
            most = std::max(most, max_abs_component(same.pixels[i] - again.pixels[i]));
            brightest = std::max(brightest, max_abs_component(same.pixels[i]));
        }
        CHECK(most < 1e-3 * brightest);
        CHECK(error_of(again, same) < 1e-3);

        // One lamp off, one in another colour, some of many.
        const Image made = run.relit({"--set", "KeyLamp=0", "--set", "SignLamp=0.5,#00ff00"});
        const Image right =
            run.rendered("128", {"Declare=Key=0", "--declare", "Sign=<0,0.5,0>", "--seed", "7"});
        const Image other =
            run.rendered("128", {"Declare=Key=0", "--declare", "Sign=<0,0.5,0>", "--seed", "8"});
        CHECK(error_of(made, right) < 2 * error_of(other, right) + 0.01);
    }
}

TEST_CASE("a show makes numbered pictures and films", "[app][relight]") {
    Relit run;
    run.write("room.pov", with(with(room_of_lamps, "EXTRA", ""), "MORE", ""));
    run.rendered("4", {"--keep-lights", run.path("room.lights")});
    const std::string file = run.path("room.lights");
    CHECK(run({"relight", file, "--lamps"}) == 0);
    CHECK(run.out == "KeyLamp\nSignLamp\nRow[0..8]\n");
    run.write("show.csv", "KeyLamp,Row[0..8]\n1,1,1,1,1,1,1,1,1,1\n0,1,0,0,0,0,0,0,0,0\n");
    CHECK(run({"relight", file, "-o", run.path("show.png"), "--csv", run.path("show.csv")}) == 0);
    CHECK(run.err == "");
    const std::string whole = run.content("show1.png");
    CHECK(whole != "");
    CHECK(run.content("show2.png") != whole);
    CHECK(run({"relight", file, "-o", run.path("one.png")}) == 0);
    CHECK(run.content("one.png") == whole);
    CHECK(run({"relight", file, "-o", run.path("two.png"), "--set", "KeyLamp=0", "--set",
               "Row[1..8]=0"}) == 0);
    CHECK(run.content("two.png") == run.content("show2.png"));
    CHECK(run({"relight", file}) == 0);
    CHECK(run.content("room.png") == whole);
    if (std::system("ffmpeg -version > /dev/null 2>&1") != 0) return;
    CHECK(run({"relight", file, "--csv", run.path("show.csv"), "--movie", run.path("show.mp4")}) ==
          0);
    CHECK(run.content("show.mp4") != "");
}

TEST_CASE("relight says what it cannot do", "[app][relight]") {
    Relit run;
    run.write("room.pov", with(with(room_of_lamps, "EXTRA", ""), "MORE", ""));
    run.rendered("1", {"--keep-lights", run.path("room.lights")});
    const auto fails = [&](std::vector<std::string> words, int status, std::string_view why) {
        INFO(why);
        words.insert(words.begin(), "relight");
        CHECK(run(words) == status);
        CHECK(has(run.err, why));
    };
    const std::string file = run.path("room.lights"), png = run.path("a.png");
    fails({}, 2, "needs one file");
    fails({file, file}, 2, "there is already");
    fails({run.path("none.lights")}, 3, "cannot be read");
    fails({run.path("room.pov")}, 3, "does not keep the light of lamps");
    fails({file, "-o", png, "--set", "KayLamp=1"}, 2, "did you mean `KeyLamp`?");
    fails({file, "-o", png, "--set", "KeyLamp"}, 2, "is no lamp with its value");
    fails({file, "-o", png, "--csv", run.path("none.csv")}, 2, "cannot be read");
    fails({file, "--movie", run.path("a.mp4")}, 2, "needs the frames of a show");
    fails({file, "-o", png, "--smooth", "few"}, 2, "is no number of pixels from 0 to 100");
    fails({file, "--set"}, 2, "`--set` needs a value");
    fails({file, "--preview", "0", "-o", png}, 2, "a preview of a show writes no pictures");
    fails({file, "--preview", "none"}, 2, "a port is a number from 0 to 65535");
    fails({run.path("none.lights"), "--preview", "0"}, 3, "cannot be read");
    fails({file, "--preview", "0", "--preview-host", "here"}, 3, "cannot be had");
    fails({file, "--check"}, 2, "relight makes pictures and nothing else");
    const std::string bytes = run.content("room.lights");
    run.write("short.lights", bytes.substr(0, bytes.size() / 2));
    fails({run.path("short.lights")}, 3, "is not whole");
}

TEST_CASE("a film develops what is relit", "[app][relight]") {
    Relit run;
    run.write("room.pov",
              with(with(with(room_of_lamps, "EXTRA", ""), "MORE", ""), "right x up y",
                   "right x up y film { exposure -1 response agx glare { veil 0.2 } }"));
    run.rendered("4", {"--keep-lights", run.path("room.lights")});
    const auto developed = [&](const std::string& command, const std::string& from) {
        CHECK(run({command, run.path(from), "-o", run.path("a.ppm"), "--exposure", "0.5"}) == 0);
        CHECK(run.err == "");
        return run.content("a.ppm");
    };
    // Without smooth edges, which light that is relit does not have.
    const std::string relit = developed("relight", "room.lights");
    int different = 0;
    CHECK(run({"develop", run.path("room.exr"), "-o", run.path("b.ppm"), "--exposure", "0.5",
               "--smooth-edges", "off"}) == 0);
    const std::string right = run.content("b.ppm");
    // Behind a head with the origin of the picture.
    constexpr std::size_t bytes = 24 * 24 * 3;
    REQUIRE(std::min(right.size(), relit.size()) > bytes);
    for (std::size_t i = 1; i <= bytes; ++i)
        different += std::abs(static_cast<unsigned char>(right[right.size() - i]) -
                              static_cast<unsigned char>(relit[relit.size() - i])) > 1;
    CHECK(different == 0);
}

TEST_CASE("meters are read under other powers, frame by frame", "[app][relight]") {
    Relit run;
    run.write(
        "room.pov",
        with(
            with(room_of_lamps, "EXTRA", "photometry { unit 1 } integrator { path_traced }"),
            "MORE",
            "meter { \"floor\" points { 2, <0, 0.01, 0.5>, <1, 0.01, -1> } direction y }\n"
            "meter { \"glare\" ugr points { 1, <0, 1, -3> } direction z }\n"
            "meter { \"seen\" luminance eye <0, 2, -6> points { 1, <0, 0.01, 0> } }\n"
            "meter { \"road\" luminance eye <0, 2, -6> points { 2, <0, 0.01, 0.5>, <1, 0.01, -1> } "
            "road_table \"road.csv\" }"));
    run.write("road.csv", "tan,0,180\n0,700,700\n9,100,300\n");
    run.rendered("1024", {"--keep-lights", run.path("room.lights")});
    run.write("show.csv", "KeyLamp,SignLamp\n1,1\n0,#00ff00\n");
    REQUIRE(run({"relight", run.path("room.lights"), "--csv", run.path("show.csv"), "--meters",
                 "-"}) == 0);
    CHECK(run.err == "");
    CHECK(run.out.starts_with("frame,meter,quantity,unit,point,x,y,z,value\n"));
    CHECK(has(run.out, "\n2,seen,luminance,cd/m2,1,0,0.01,0,"));
    CHECK_FALSE(has(run.out, "glare"));
    CHECK(run.content("room1.png") == "");
    const auto values_in = [](const std::string& table, std::string_view meter, int cell) {
        std::vector<double> values;
        std::istringstream lines(table);
        for (std::string line; std::getline(lines, line);) {
            if (line.find(meter) == line.npos) continue;
            std::size_t at = 0;
            for (int i = 0; i < cell; ++i) at = line.find(',', at) + 1;
            values.push_back(std::stod(line.substr(at)));
        }
        return values;
    };
    const std::string relit = run.out;
    REQUIRE(run({run.path("room.pov"), "-V", "--measure", "-", "--samples", "4096", "Declare=Key=0",
                 "--declare", "Sign=<0,1,0>"}) == 0);
    for (const char* meter : {"floor", "seen", "road"}) {
        const auto made = values_in(relit, message("2,", meter, ","), 8),
                   right = values_in(run.out, meter, 7), low = values_in(run.out, meter, 8);
        REQUIRE(made.size() == right.size());
        for (std::size_t i = 0; i < made.size(); ++i) {
            INFO(meter << " " << made[i] << " " << right[i]);
            CHECK(std::abs(made[i] - right[i]) < 4 * (right[i] - low[i]) + 0.02 * right[i]);
        }
    }
    run.write("room.pov", with(with(room_of_lamps, "EXTRA", ""), "MORE", ""));
    run.rendered("1", {"--keep-lights", run.path("room.lights")});
    CHECK(run({"relight", run.path("room.lights"), "--meters", "-"}) != 0);
    CHECK(has(run.err, "its scene had no meter"));
}

TEST_CASE("a picture whose light is kept goes on from its state to the same bytes",
          "[app][relight]") {
    Relit run;
    run.write("room.pov", with(with(room_of_lamps, "EXTRA", ""), "MORE", ""));
    const std::vector<std::string> words = {
        run.path("room.pov"), "-V", "+W64", "+H64", "--samples", "16", "+O" + run.path("room.png"),
        "--keep-lights", run.path("room.lights"), "+WT1"};
    REQUIRE(run(words) == 0);
    const std::string picture = run.content("room.png"), lights = run.content("room.lights");
    std::filesystem::remove(run.path("room.png"));
    std::filesystem::remove(run.path("room.lights"));
    for (const int stop : {40, 400}) {
        int asked = 0;
        run.interrupts.take = [&] { return ++asked == stop ? Interrupt::stop : Interrupt::none; };
        CHECK(run(words) == exit_status::stopped);
        CHECK(run.content("room.lights") == "");
        run.interrupts.take = {};
        std::vector<std::string> more = words;
        more.push_back("+C");
        REQUIRE(run(more) == 0);
        CHECK(run.content("room.png") == picture);
        CHECK(run.content("room.lights") == lights);
        std::filesystem::remove(run.path("room.lights"));
    }
}

TEST_CASE("four cues of a stage are as renders of them", "[app][relight]") {
    constexpr auto stage = R"(#version 3.7;
global_settings { assumed_gamma 1 integrator { path_traced } }
#ifndef (Key) #declare Key = rgb 1; #end
#ifndef (Back) #declare Back = rgb 1; #end
#ifndef (Foot) #declare Foot = rgb 1; #end
camera { location <0, 2, -7> look_at <0, 1.3, 0> right x up y }
box { <-4, -0.1, -3>, <4, 0, 3> pigment { rgb <0.5, 0.4, 0.3> } finish { ambient 0 diffuse 0.8 } }
box { <-4, 0, 3>, <4, 4, 3.1> pigment { rgb <0.6, 0.2, 0.2> } finish { ambient 0 diffuse 0.8 } }
cylinder { 0, 1.7*y, 0.3 pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 } }
#macro Glow(Light) pigment { rgb 1 } finish { ambient 0 diffuse 0 emission Light } #end
union { #for (I, -2, 2) sphere { <I, 4, -3>, 0.15 Glow(20*Key) } #end light_name "Key" }
union { #for (I, -2, 2) sphere { <I, 3.8, 2>, 0.15 Glow(12*Back) } #end light_name "Back" }
union { #for (I, -9, 9) sphere { <0.4*I, 0.1, -2.9>, 0.05 Glow(9*Foot) } #end light_name "Foot" }
)";
    Relit run;
    run.write("room.pov", stage);
    run.rendered("128", {"--keep-lights", run.path("room.lights")});
    run.write("cues.csv",
              "cue,time,fade\n"
              "house,0,0,Key=0,Back=0,Foot=0.3\n"
              "dawn,1,0,\"Back=1.5,#ff8040\"\n"
              "noon,2,0,Key=1,Back=0.2,Foot=0\n"
              "night,3,0,Key=0,\"Back=1,#2040ff\",Foot=0.05\n");
    REQUIRE(run({"relight", run.path("room.lights"), "--csv", run.path("cues.csv"), "--frame-rate",
                 "1", "-o", run.path("cue.exr")}) == 0);
    const std::vector<std::vector<std::string>> looks = {
        {"Key=<0,0,0>", "Back=<0,0,0>", "Foot=<0.3,0.3,0.3>"},
        {"Key=<0,0,0>", "Back=<1.5,0.3238,0.0769>", "Foot=<0.3,0.3,0.3>"},
        {"Key=<1,1,1>", "Back=<0.2,0.2,0.2>", "Foot=<0,0,0>"},
        {"Key=<0,0,0>", "Back=<0.0144,0.0513,1>", "Foot=<0.05,0.05,0.05>"}};
    for (std::size_t i = 0; i < looks.size(); ++i) {
        INFO("cue " << i + 1);
        const Image made = run.light(message("cue", i + 1, ".exr"));
        const auto fresh = [&](const char* seed) {
            std::vector<std::string> more = {"--seed", seed};
            for (const std::string& look : looks[i]) more.insert(more.end(), {"--declare", look});
            return run.rendered("128", more);
        };
        const Image right = fresh("7"), other = fresh("8");
        INFO(error_of(made, right) << " " << error_of(other, right));
        CHECK(error_of(made, right) < 2 * error_of(other, right) + 0.01);
    }
}

}  // namespace candelabra

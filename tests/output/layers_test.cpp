// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/layers.h"

#include "picture/layers.h"
#include "picture/read.h"
#include "support/found.h"
#include "support/shell.h"

#include <catch2/catch.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <set>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

const char* const two_lit_balls = R"(#version 3.7; global_settings { assumed_gamma 1 }
camera { location <0, 2, -6> look_at 0 }
#default { finish { ambient 0 } }
plane { y, -1 pigment { rgb 0.8 } finish { reflection 0.2 } }
#declare Lamp = sphere { 0, 0.2 pigment { rgb 1 } finish { diffuse 0 emission 4 } }
#declare Sconce = light_group {
    object { Lamp }
    light_source { y, rgb 0.1 }
    light_source { 2*y, rgb 0.1 }
}
union { object { Lamp translate <-1, 1, 0> } object { Lamp translate <1, 1, 0> } }
object { Lamp translate 2*y }
light_group { Sconce translate 3*x }
light_source { <5, 5, -5>, rgb <0.5, 0.4, 0.3> }
#macro Row(N) union { #for (I, 1, N) object { Lamp translate I*x } #end } #end
object { Row(3) translate -3*x }
)";

/// Planes of a file by name.
struct Planes {
    LayeredPicture picture;
    explicit Planes(const std::string& path) {
        const std::string_view texts[] = {"ImageDescription"};
        Diagnostics diagnostics;
        const auto read = read_layers(path, texts, diagnostics);
        REQUIRE(read);
        picture = *read;
    }
    std::set<std::string> names() const {
        std::set<std::string> all;
        for (const ChannelPlane& plane : picture.planes) all.insert(plane.name);
        return all;
    }
    double value(const std::string& name, std::size_t pixel) const {
        const auto plane = std::ranges::find(picture.planes, name, &ChannelPlane::name);
        CAPTURE(name);
        REQUIRE(plane != picture.planes.end());
        return std::bit_cast<float>(plane->bits[pixel]);
    }
};

int render(Shell& shell, std::vector<std::string> more) {
    shell.write("lamps.pov", two_lit_balls);
    more.insert(more.end(), {shell.path("lamps.pov"), "-V", "+W24", "+H18", "--samples", "3"});
    return shell(more);
}

/// The names of the lights that have layers in the file.
std::set<std::string> light_layers(const std::string& file) {
    std::set<std::string> lights;
    for (const std::string& name : Planes(file).names())
        if (name.starts_with("light.") && name.ends_with(".R"))
            lights.insert(name.substr(6, name.size() - 8));
    return lights;
}

}  // namespace

TEST_CASE("layers of light add up to the picture, and have the names that the scene gives") {
    Shell shell;
    REQUIRE(render(shell, {"+O" + shell.path("a.exr"), "--layers", "lights"}) == 0);
    const Planes planes(shell.path("a.exr"));
    const std::set<std::string> lights = {"Lamp", "Lamp_2",       "Sconce",
                                          "Row",  "light_source", "rest"};
    std::set<std::string> wanted = {"R", "G", "B"};
    for (const std::string& light : lights)
        for (const char* channel : {"R", "G", "B"}) wanted.insert("light." + light + "." + channel);
    CHECK(planes.names() == wanted);
    double brightest = 0;
    for (std::size_t i = 0; i < 24 * 18; ++i)
        for (const char* channel : {"R", "G", "B"}) {
            double sum = 0;
            for (const std::string& light : lights)
                sum += planes.value("light." + light + "." + channel, i);
            CHECK(sum == Approx(planes.value(channel, i)).margin(1e-5));
            CHECK(planes.value(std::string("light.rest.") + channel, i) == Approx(0).margin(1e-5));
            brightest = std::max(brightest, sum);
        }
    CHECK(brightest > 1);
}

TEST_CASE("layers of light are named by their statements, not by variables of their positions") {
    Shell shell;
    shell.write("named.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
        camera { location -4*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } }
        #declare Here = <1, 2, -3>; #declare R = 2; #declare Tint = rgb 1;
        #declare Lamps = array[2] { light_source { y, 1 }, light_source { 2*y, 1 } }
        light_source { Here, 1 }
        light_source { 2*Here, 1 }
        light_source { <R, 2, -4>, 1 }
        light_source { Here rgb 1 }
        light_source { Here Tint }
        light_source { Here + x, 1 }
        sphere { Here, 0.1 pigment { rgb 1 } finish { emission 2 } }
        light_source { Lamps[0] translate x }
        light_source { Lamps[1] }
        light_source { Lamps[1] translate R*x })");
    REQUIRE(shell({shell.path("named.pov"), "-V", "+W4", "+H3", "+O" + shell.path("n.exr"),
                   "--layers", "lights"}) == 0);
    CHECK(light_layers(shell.path("n.exr")) ==
          std::set<std::string>{"light_source", "light_source_2", "light_source_3",
                                "light_source_4", "light_source_5", "light_source_6", "sphere",
                                "Lamps_0", "Lamps_1", "Lamps_1_2", "rest"});
}

TEST_CASE("unions may name the light that is made in them") {
    Shell shell;
    shell.write("named.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
        camera { location -4*z look_at 0 } sphere { 0, 1 pigment { rgb 1 } }
        #declare Lamp = sphere { 0, 0.1 pigment { rgb 1 } finish { emission 9 } }
        #declare Two = union {
            object { Lamp translate <2, 2, -2> }
            light_source { <3, 3, -3>, 0.3 }
            light_name "Left.1"
        }
        object { Two }
        union {
            union { object { Lamp translate <-2, 2, -2> } light_name "Left.1" }
            object { Lamp translate <-1, 2, -2> }
            light_name "Right side"
        }
        light_group { light_source { y*9, 1 } sphere { 2*x, 1 } light_name "Group" })");
    REQUIRE(shell({shell.path("named.pov"), "-V", "+W4", "+H3", "+O" + shell.path("n.exr"),
                   "--layers", "lights"}) == 0);
    CHECK(light_layers(shell.path("n.exr")) ==
          std::set<std::string>{"Left_1", "Right side", "Group", "rest"});
}

TEST_CASE("all layers are there, beside a picture that cannot have them") {
    Shell shell;
    REQUIRE(render(shell, {"+O" + shell.path("a.png"), "--layers", "all"}) == 0);
    CHECK(fs::exists(shell.path("a.png")));
    const Planes planes(shell.path("a.layers.exr"));
    const std::set<std::string> names = planes.names();
    for (const char* name : {"R", "albedo.R", "normal.Z", "depth", "object", "variance", "samples",
                             "shadow_rays", "light.rest.B"})
        CHECK(names.count(name) == 1);
    CHECK(has(planes.picture.texts[0].second, " layers=albedo,normal,depth,object,lights,"));
    CHECK(planes.value("samples", 7) == 3);
    const std::size_t sky = 0, floor = 24 * 17 + 12;
    CHECK(std::isinf(planes.value("depth", sky)));
    CHECK(planes.value("object", sky) == 0);
    CHECK(planes.value("object", floor) == 1);
    CHECK(planes.value("normal.Y", floor) == Approx(1));
    CHECK(planes.value("albedo.G", floor) == Approx(0.8));
    CHECK(planes.value("shadow_rays", floor) >= 3);
    CHECK(planes.value("variance", floor) > 0);
    // The picture is the one without layers.
    REQUIRE(render(shell, {"+O" + shell.path("b.exr")}) == 0);
    CHECK(planes.value("G", floor) == Planes(shell.path("b.exr")).value("G", floor));
}

TEST_CASE("layers are the same by any threads, after a stop, and from shards") {
    Shell shell;
    const auto bytes = [&](std::vector<std::string> more) {
        more.insert(more.end(), {"+O" + shell.path("a.exr"), "--layers", "all", "+UA"});
        REQUIRE(render(shell, more) == 0);
        return shell.content("a.exr");
    };
    const std::string once = bytes({});
    CHECK(bytes({"+WT1"}) == once);
    int calls = 0;
    shell.interrupts.take = [&] { return ++calls == 40 ? Interrupt::stop : Interrupt::none; };
    REQUIRE(render(shell, {"+WT1", "+C", "+O" + shell.path("a.exr"), "--layers", "all", "+UA"}) ==
            exit_status::stopped);
    CHECK(bytes({"+C"}) == once);
    for (const char* shard : {"1/2", "2/2"})
        REQUIRE(render(shell, {"+O" + shell.path("a.exr"), "--layers", "all", "+UA", "--shard",
                               shard}) == 0);
    fs::remove(shell.path("a.exr"));
    REQUIRE(shell({"merge", shell.path("a.exr.2of2.state.exr"),
                   shell.path("a.exr.1of2.state.exr")}) == 0);
    CHECK(shell.content("a.exr") == once);
    REQUIRE(render(shell, {"+O" + shell.path("a.exr"), "--layers", "all", "--shard", "2/2"}) == 0);
    CHECK(shell({"merge", shell.path("a.exr.2of2.state.exr"),
                 shell.path("a.exr.1of2.state.exr")}) == 2);
    CHECK(has(shell.err, "Output_Alpha was on and is not given"));
}

TEST_CASE("a state of other layers is not continued") {
    Shell shell;
    REQUIRE(render(shell, {"+O" + shell.path("a.exr"), "--layers", "albedo", "--keep-state"}) == 0);
    CHECK(render(shell, {"+O" + shell.path("a.exr"), "--layers", "lights", "+C"}) == 3);
    CHECK(has(shell.err, "layers was albedo and is lights"));
}

TEST_CASE("pictures with alpha are not multiplied by it, unless they are OpenEXR") {
    Shell shell;
    shell.write("half.pov", R"(#version 3.7; global_settings { assumed_gamma 1 }
        camera { location -5*z look_at 0 angle 1 }
        plane { -z, 0 pigment { rgbt <.8, .5, .2, .4> } finish { ambient 0 diffuse 0 emission 1 } })");
    const auto alpha = [&](const std::string& name) {
        REQUIRE(shell({shell.path("half.pov"), "-V", "+W2", "+H2", "+UA", "-A",
                       "+O" + shell.path(name)}) == 0);
        Diagnostics diagnostics;
        const auto stored =
            read_texels(found(shell.path(name)), {TexelCoding::as_stored}, diagnostics);
        REQUIRE(stored);
        REQUIRE(stored->transparent());
        return std::pair(stored->alpha[0], stored->values[0]);
    };
    for (const char* name : {"a.png", "a.tga"}) {
        CAPTURE(name);
        const auto [opaque, red] = alpha(name);
        CHECK(opaque == Approx(0.6).margin(0.003));
        CHECK(red == Approx(0.9063).margin(0.003));  // 0.8 as sRGB
    }
    CHECK(alpha("a.exr").first == Approx(0.6));
    CHECK(shell({shell.path("half.pov"), "+UA", "+O" + shell.path("a.jpg")}) == 2);
    CHECK(has(shell.err, "a file of format jpg has no alpha channel"));
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "bind/evaluate.h"

#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("a scene is what its text says, in order", "[bind]") {
    const Script done =
        run("#version 3.7; camera { location -z } light_source { y, 1 } #for (I, 1, 3) torus { "
            "I, 0.5 } #end background { rgb 1 }");
    REQUIRE(done.text.empty());
    CHECK(done.scene.objects.size() == 3);
    CHECK(done.shape<Torus>(2).major == 3);
    CHECK(done.scene.lights.size() == 1);
    CHECK(done.object(1).span.source == 0);
    CHECK(done.object(1).span.known());
}

TEST_CASE("names can be declared from outside", "[bind]") {
    EvaluateOptions options;
    options.declares = {{"Depth", 5.0}, {"Title", std::string("a")}};
    std::string printed;
    options.print = [&](std::string_view text) { printed += text; };
    const Script done = run(
        "#version 3.7; #ifndef (Depth) #declare Depth = 1; #end sphere { 0, Depth } #debug Title",
        {}, options);
    REQUIRE(done.text.empty());
    CHECK(done.shape<Sphere>().radius == 5);
    CHECK(printed == "a");
}

TEST_CASE("blocks that nest too deeply for the stack are an error at their place", "[bind]") {
    EvaluateOptions options;
    options.limits.stack_bytes = std::size_t{1} << 23;
    const auto nested = [](std::string_view open, std::string_view inner) {
        std::string text = "#version 3.7; sphere { 0, 1 ";
        for (int i = 0; i < 20000; ++i) text += open;
        text += inner;
        for (int i = 0; i < 20000; ++i)
            for (const char c : open) text += c == '{' ? "}" : "";
        return text + "}";
    };
    for (const auto& [open, inner] :
         {std::pair{"texture { checker ", "pigment { rgb 1 }"}, {"pigment { checker ", "rgb 1"},
          {"normal { checker ", "bumps"}}) {
        CAPTURE(open);
        const Script done = run(nested(open, inner), {}, options);
        CHECK(done.text.starts_with("error: this is nested too deeply\n --> "));
    }
}

TEST_CASE("the version decides about gamma", "[bind]") {
    CHECK(run("#version 3.7; sphere { 0, 1 }").scene.gamma_handling);
    CHECK(run("#version 3.7;").scene.language_version == 3.7);
    CHECK_FALSE(run("sphere { 0, 1 }").scene.gamma_handling);
    CHECK(run("sphere { 0, 1 }").scene.language_version == 3.62);
    CHECK_FALSE(run("#version 3.5;").scene.gamma_handling);
    CHECK(run("#version 3.5; global_settings { assumed_gamma 2.2 }").scene.gamma_handling);
    CHECK(run("global_settings { assumed_gamma 1 }").scene.gamma_handling);
}

TEST_CASE("what programs of the LDraw family, PyMOL and ASE write is read", "[bind]") {
    const Script done = run(R"(#version 3.7;
global_settings { assumed_gamma 1 }
#declare QUAL = 2;
camera { orthographic angle 0 location <0, 0, -4> look_at 0 }
light_source { <2, 4, -9> rgb 1 }
fog { fog_type 1 distance 250.0000 color color rgb 1 }
#declare C = #if (version >= 3.1) material { #end
    texture { pigment { rgb <1, 0.2, 0.2> #if (QUAL > 1) filter 0.85 #end } }
#if (version >= 3.1) } #end
object { sphere { 0, 1 } #if (version >= 3.1) material #else texture #end { C } }
#if (QUAL > 1) merge #else union #end { sphere { x, 0.5 } sphere { -x, 0.5 } pigment { rgb 1 } }
#if (0) this is ' garbage } ) < that #if (1) isn't read ] #end
#else sphere { y, 0.1 pigment { rgb 1 } } #end
#if (false) { ~ #end
sphere { -y, 0.1 pigment { rgb 1 } finish { phong -1.000 phong_size 13.750000 } }
)");
    CHECK(done.text.empty());
    CHECK(done.scene.objects.size() == 4);
    CHECK(done.texture().pigment.colour.filter == 0.85);
    CHECK(std::get<Union>(done.object(1).form).csg == Csg::merge);
}

TEST_CASE("every part of a scene can be declared and used", "[bind]") {
    const Script done =
        run("#version 3.7; #declare C = rgb 1; #declare P = pigment { C } #declare F = finish { "
            "phong 1 } #declare I = interior { ior 2 } "
            "#declare T = texture { pigment { P } finish { F } } #declare Tr = transform { "
            "translate x } #declare M = color_map { [0 C] [1 C] } "
            "#declare O = sphere { 0, 1 texture { T } interior { I } transform { Tr } } object { O "
            "pigment { gradient x color_map { M } } }");
    INFO(done.text);
    REQUIRE(done.text.empty());
    CHECK(done.texture().finish.phong == 1);
    CHECK(done.texture().pigment.pattern != nullptr);
    CHECK(done.object().interior->ior == 2);
    CHECK(done.object().transform->point(Vec3(0)) == Vec3(1, 0, 0));
}

TEST_CASE("what makes no scene is told of once", "[bind]") {
    CHECK(complaint("5") == "error misplaced: a number has no place in a scene");
    CHECK(complaint("\"text\"") == "error misplaced: a string has no place in a scene");
    CHECK(complaint("#declare T = texture { } T") ==
          "error misplaced: a texture has no place in a scene");
    CHECK(complaint("max_trace_level 5") ==
          "warning deprecated: `max_trace_level` belongs into `global_settings`");
    CHECK(run("#version 3.7; max_trace_level 7").scene.settings.max_trace_level == 7);
    CHECK(complaint("#declare M = anisotropy { 1 }") ==
          "error not-implemented: `anisotropy` is not available in this version");
    CHECK(complaint("#declare S = sphre { 0, 1 }") ==
          "error unknown-word: a scene has no word `sphre`");
    CHECK(complaint("#default { sphere { 0, 1 } }") ==
          "error misplaced: `sphere` has no place in `#default`");
    CHECK(complaint("#default { finsh { } }") ==
          "error unknown-word: `#default` has no word `finsh`");
}

TEST_CASE("a setting outside of global_settings is read as within", "[bind]") {
    const auto last = [](const std::string& script) {
        const Script done = run("#version 3.7; " + script);
        INFO(done.text);
        REQUIRE(done.said.size() == 2);
        CHECK(done.said.front().fault == Fault::deprecated);
        return done.said.back().fault;
    };
    CHECK(last("max_trace_level 1e300") == Fault::out_of_range);
    CHECK(last("max_trace_level \"a\"") == Fault::wrong_type);
    CHECK(last("max_trace_level sphere { 0, 1 }") == Fault::missing);
    CHECK(last("sphere { 0, 1 } max_trace_level") == Fault::missing);
    CHECK(complaint("max_intersections 64 sphere { 0, 1 }") ==
          "warning no-effect: `max_intersections` has no effect in this version");
}

TEST_CASE("what is wrong in a branch counts only when the branch is taken", "[bind]") {
    const std::string wrong =
        GENERATE(as<std::string>(), "@ $ % \\ ' ` ~ ^", "don't do this", "\"bad \\q escape\"",
                 "#colours", "a == b && c || d", "#declare = 1;", ", ,", "1 + * 2", "sphere { 0",
                 "(a", "a ) b", "#for (a #end", "#if #end");
    INFO(wrong);
    const auto messages = [&](const std::string& condition) {
        return run("#version 3.7; " + condition + " " + wrong + " #end sphere { 0, 1 }").text;
    };
    CHECK(messages("#ifdef (Nothing)") == "");
    CHECK(messages("#declare A = 0; #if (A)") == "");
    CHECK(messages("#ifndef (Nothing) #else") == "");
    CHECK(messages("#ifdef (Nothing) #elseif (0)") == "");
    CHECK(messages("#ifdef (Nothing) #ifdef (Nothing) #end") == "");
    CHECK(messages("#ifndef (Nothing)").starts_with("error: "));
    CHECK(messages("#ifdef (Nothing) #elseif (1)").starts_with("error: "));
    CHECK(messages("#ifdef (Nothing) #else").starts_with("error: "));
}

TEST_CASE("an error beside a branch is told of without what is wrong in it", "[bind]") {
    CHECK(complaint("#ifdef (Nothing) @ #end ^ 1") ==
          "error unknown-character: this character means nothing here");
}

TEST_CASE("directives go on with the values of an object", "[bind]") {
    const Script done = run(
        "#version 3.7; sphere { <0, 0, 0> #if (1) + x #end, 1 #if (1) + 2 #end translate y #if (1) "
        "* 2 #end }");
    CHECK(done.text == "");
    CHECK(done.shape<Sphere>().radius == 3);
    REQUIRE(done.object().transform);
    CHECK(done.object().transform->point(done.shape<Sphere>().centre) == Vec3(1, 2, 0));
}

}  // namespace candelabra

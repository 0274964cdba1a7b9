// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/objects.h"

#include "csg/extent.h"
#include "support/script.h"
#include "support/scripts.h"
#include "text/message.h"
#include "world/compile.h"

#include <catch2/catch.hpp>

namespace candelabra {

TEST_CASE("every shape can be written, declared, and copied", "[objects]") {
    const std::string shape = GENERATE(Catch::Generators::values<std::string>(
        {"sphere { 0, 1 }", "box { 0, 1 }", "plane { y, 0 }", "disc { 0, y, 1 }",
         "cylinder { 0, y, 1 }", "cone { 0, 1, y, 0 }", "triangle { 0, x, y }",
         "smooth_triangle { 0, z, x, z, y, z }",
         "mesh2 { vertex_vectors { 3, 0, x, y } face_indices { 1, <0, 1, 2> } }"}));
    const std::string word = shape.substr(0, shape.find(' '));
    const Script done = run("#version 3.7; #declare A = " + shape + " " + shape +
                            " A object { A scale 2 } " + word + " { A no_shadow }");
    INFO(shape << "\n" << done.text);
    REQUIRE(done.text.empty());
    REQUIRE(done.scene.objects.size() == 4);
    const std::size_t kind = std::get<Shape>(done.object(0).form).index();
    CHECK(Kinds<Shape>::infos[kind]->name == word);
    for (std::size_t i = 1; i < 4; ++i) CHECK(std::get<Shape>(done.object(i).form).index() == kind);
    CHECK(done.object(2).transform);
    CHECK(done.object(3).no_shadow);
}

TEST_CASE("a union takes objects from everywhere", "[objects]") {
    const Script done =
        run("#version 3.7; #declare A = sphere { 0, 1 } #macro M(N) #for (I, 1, N) sphere { I*x, 1 "
            "} #end #end "
            "union { A object { A translate x } M(3) union { box { 0, 1 } } #if (1) A #end rotate "
            "90*y pigment { rgb 1 } }");
    REQUIRE(done.text.empty());
    const auto& children = std::get<Union>(done.object().form).children;
    REQUIRE(children.size() == 7);
    CHECK(children[0] == children[6]);
    CHECK_FALSE(children[0]->texture);
    CHECK(done.texture().pigment.colour.rgb == Rgb(1));
}

TEST_CASE("objects come from macros and arrays", "[objects]") {
    const Script done =
        run("#version 3.7; #macro Ball(R) sphere { 0, R pigment { rgb R } } #end #macro "
            "Twice(What) object { What } object { What translate x } #end "
            "#declare Balls = array[2] { sphere { 0, 1 }, Ball(2) } object { Balls[1] } object { "
            "Ball(3) } Twice(Ball(4)) Twice(Balls[0])");
    INFO(done.text);
    REQUIRE(done.text.empty());
    REQUIRE(done.scene.objects.size() == 6);
    CHECK(done.shape<Sphere>(0).radius == 2);
    CHECK(done.shape<Sphere>(1).radius == 3);
    CHECK(done.shape<Sphere>(3).radius == 4);
    CHECK(done.texture(2).pigment.colour.rgb == Rgb(4));
}

TEST_CASE("switches are those of the text", "[objects]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 no_shadow no_image no_reflection hollow inverse "
            "double_illuminate } sphere { 0, 1 no_image off }");
    REQUIRE(done.text.empty());
    const Object& all = done.object(0);
    CHECK((all.no_shadow && all.no_image && all.no_reflection && all.hollow && all.inverse &&
           all.double_illuminate));
    CHECK_FALSE(done.object(1).no_image);
}

TEST_CASE("inverse swaps inside and outside each time it is said", "[objects]") {
    const Script done =
        run("#version 3.7; sphere { 0, 1 inverse inverse } #declare Hole = sphere { "
            "0, 1 inverse } object { Hole inverse } object { Hole }");
    REQUIRE(done.text.empty());
    CHECK_FALSE(done.object(0).inverse);
    CHECK_FALSE(done.object(1).inverse);
    CHECK(done.object(2).inverse);
}

TEST_CASE("triangles without area are left out with a warning", "[objects]") {
    const Script done = run(
        "#version 3.7; triangle { 0, x, 2*x } union { triangle { 0, x, 2*x } sphere { 0, 1 } }");
    CHECK(done.said.size() == 2);
    CHECK(done.said[0].severity == Severity::warning);
    CHECK(done.scene.objects.size() == 1);
}

TEST_CASE("wrong objects are told of once", "[objects]") {
    CHECK(complaint("object { }") == "error missing: `object` needs an object");
    CHECK(complaint("object { sphere { 0, 1 } sphere { 0, 1 } }") ==
          "error misplaced: `object` holds one object, and this is a second");
    CHECK(complaint("object { scale 2 sphere { 0, 1 } }") ==
          "error misplaced: in `object` the object comes before what changes it");
    CHECK(complaint("union { sphere { 0, 1 } scale 2 sphere { 0, 1 } }") ==
          "error misplaced: the objects of `union` come before what changes the whole");
    CHECK(complaint("#declare A = sphere { 0, 1 } sphere { 0, 1 A }") ==
          "error misplaced: a declared object comes first in `sphere`, in the place of its values");
    CHECK(complaint("sphere { 0, 1 sphere { 0, 1 } }") ==
          "error misplaced: `sphere` has no place in `sphere`");
    CHECK(complaint("union { anisotropy { 1, 2 } anisotropy { 1, 2 } }") ==
          "error not-implemented: `anisotropy` is not available in this version");
    CHECK(complaint("cylinder { 0, 0, 1 }").rfind("error degenerate: ", 0) == 0);
}

TEST_CASE("objects nest thousands deep, but not without end", "[objects]") {
    const std::string nest =
        "#version 3.7; #macro Nest(N) union { sphere { 0, 1 } #if (N > 1) Nest(N - 1) #end } #end ";
    CHECK(run(nest + "Nest(10000)").text.empty());
    const Script deep = run(nest + "Nest(10001)");
    REQUIRE(deep.said.size() == 1);
    CHECK(deep.said[0].fault == Fault::recursion_limit);
}

TEST_CASE("declared objects inside each other count as well", "[objects]") {
    const std::string loop = GENERATE(Catch::Generators::values<std::string>({
        "#declare A = union { A sphere { I, 1 } }",
        "#declare A = intersection { A sphere { I, 1 } translate x }",
        "#declare A = sphere { I, 1 clipped_by { A } }",
    }));
    const std::string before = "#version 3.7; #declare A = box { 0, 1 } ";
    INFO(loop);
    CHECK(run(before + "#for (I, 1, 10000) " + loop + " #end A").text.empty());
    const Script deep = run(before + "#for (I, 1, 10001) " + loop + " #end A");
    REQUIRE(deep.said.size() == 1);
    CHECK(deep.said[0].fault == Fault::recursion_limit);
}

TEST_CASE("the function of a julia fractal may be a power", "[objects]") {
    const Script done =
        run("#version 3.7; julia_fractal { <0.1, 0, 0, 0> hypercomplex pwr(1.5, 0.8) "
            "slice <0, 0, 0, 1>, 0.2 max_iteration 9 }");
    REQUIRE(done.text.empty());
    const JuliaFractal& julia = *done.shape<Shared<JuliaFractal>>();
    CHECK(julia.exponent == Vec2(1.5, 0.8));
    CHECK(julia.distance == 0.2);
    CHECK(julia.max_iteration == 9);
}

TEST_CASE("the sign of a radius does not count, and what has none is left out") {
    const auto extents = [](const std::string& script) {
        std::string said;
        for (const ObjectHandle& object : scene_of(script).objects) {
            const Box box = extent(*object);
            said += message(box.size().x, ' ', box.size().y, ';');
        }
        return said;
    };
    for (const char* pair : {"sphere { 0, %2 }", "cylinder { 0, y, %2 }", "disc { 0, y, %2 }",
                             "disc { 0, y, 3, %2 }", "blob { sphere { 0, %2, 3 } }"}) {
        const std::string text = pair;
        const std::size_t at = text.find('%');
        CAPTURE(text);
        CHECK(extents(std::string(text).replace(at, 1, "-")) ==
              extents(std::string(text).replace(at, 1, "")));
    }
    CHECK(world_of("#for (I, -9, 9) sphere { 0, I } #end")->geometry.spheres.size() == 18);
    CHECK(extents("difference { sphere { 0, 1 } sphere { 0, 0 } }") == "2 2;");
    for (const char* nothing :
         {"sphere { 0, 0 }", "cylinder { 0, y, 0 }", "cone { 0, 0, y, 0 }", "torus { 1, 0 }",
          "disc { 0, y, 0 }", "disc { 0, y, 1, 2 }", "blob { sphere { 0, 0, 1 } }",
          "triangle { 0, x, 2*x }", "text { internal 1 \" \" 1, 0 }",
          "intersection { sphere { 0, 0 } box { -1, 1 } }",
          "difference { sphere { 0, 0 } box { -1, 1 } }"}) {
        CAPTURE(nothing);
        Hit hit;
        const SharedWorld world = world_of(nothing);
        CHECK_FALSE(world->first_hit({Vec3(0.1, 0.2, -9), unit(Vec3(-0.01, -0.02, 1))}, 0,
                                     RayKind::camera, hit));
    }
}

}  // namespace candelabra

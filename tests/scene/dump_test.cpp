// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/dump.h"

#include "shape/text_turn.h"
#include "support/objects.h"
#include "surface/normal_map.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

/// A scene as the evaluator creates it.
Scene empty_scene() {
    Scene scene;
    scene.background.colour.transmit = 1;
    return scene;
}

const std::string head = "#version 3.7;\ncamera { perspective }\n";

std::string body(std::vector<ObjectHandle> objects) {
    Scene scene = empty_scene();
    scene.objects = std::move(objects);
    const std::string text = dump(scene);
    REQUIRE(text.starts_with(head));
    return text.substr(head.size());
}

}  // namespace

TEST_CASE("an empty scene is all defaults") { CHECK(dump(empty_scene()) == head); }

TEST_CASE("every shape is written with its places in their order") {
    Mesh mesh;
    mesh.vertices = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.faces = {{0, 1, 2}};
    Triangle triangle;
    struct Case {
        Shape shape;
        std::string expected;
    };
    const Case cases[] = {
        {Sphere{Vec3(1, 2, 3), 0.1}, "sphere { <1, 2, 3>, 0.1 }\n"},
        {Sphere{Vec3(0), 1.0 / 3}, "sphere { 0, 0.3333333333333333 }\n"},
        {Cuboid{Vec3(-1), Vec3(1)}, "box { -1, 1 }\n"},
        {Plane{Vec3(0, -1, -0.0), 3}, "plane { <0, -1, -0>, 3 }\n"},
        {Shared<HeightField>(HeightField{.file = "a.gif", .kind = "pot"}),
         "height_field { pot \"a.gif\" }\n"},
        {Shared<HeightField>(HeightField{.file = "a.gif"}), "height_field { \"a.gif\" }\n"},
        {Shared<Mesh>(mesh),
         "mesh2 { vertex_vectors { 3, <0, 0, 0>, <1, 0, 0>, <0, 1, 0> } face_indices { 1, <0, 1, "
         "2> } }\n"},
    };
    for (const Case& each : cases) CHECK(body({object(each.shape)}) == each.expected);
}

TEST_CASE("letters are written without the turn that each text has", "[dump]") {
    Object letters;
    Text text;
    text.text = "A";
    text.font = "a.ttf";
    letters.form = Shape(Shared<Text>(text));
    letters.transform = make_handle<Transform>(text_turn());
    CHECK(body({make_handle<Object>(letters)}).find("matrix") == std::string::npos);
    letters.transform =
        make_handle<Transform>(text_turn().then(Transform::translation(Vec3(1, 2, 3))));
    // The inverse follows, as it has other last bits than that of the matrix.
    CHECK(body({make_handle<Object>(letters)}).find(", 1, 2, 3, ") != std::string::npos);
}

TEST_CASE("modifiers follow: transformation, switches, interior, texture") {
    Object glass;
    glass.form = Sphere();
    glass.transform = make_handle<Transform>(Transform::translation(Vec3(1, 2, 3)));
    glass.no_shadow = true;
    glass.hollow = true;
    glass.interior = make_handle<Interior>(Interior{1.5});
    Texture texture;
    texture.pigment.colour = {Rgb(1), 0.5, 0};
    texture.finish.ambient = Rgb(0);
    texture.finish.reflection.least = Rgb(0.25);
    texture.finish.reflection.greatest = Rgb(0.5);
    texture.finish.reflection.fresnel = true;
    glass.texture = make_handle<Texture>(texture);
    CHECK(body({make_handle<Object>(glass)}) ==
          "sphere { 0, 1 matrix <1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 2, 3> no_shadow hollow interior { "
          "ior 1.5 } "
          "texture { pigment { rgbft <1, 1, 1, 0.5, 0> } "
          "finish { ambient rgb 0 reflection { rgb 0.25, rgb 0.5 fresnel } } } }\n");
}

TEST_CASE("settings, background, camera and lights stand before the objects") {
    Scene scene = empty_scene();
    scene.language_version = 3.6;
    scene.gamma_handling = false;
    scene.settings.max_trace_level = 7;
    LightOctree octree;
    octree.threshold = 0.1;
    scene.settings.light_sampler = octree;
    scene.background.colour = {Rgb(0, 0, 1)};
    Orthographic camera;
    camera.location = Vec3(0, 0, -5);
    camera.look_at = Vec3(0);
    camera.angle = 40;
    scene.camera = camera;
    PointLight light;
    light.location = Vec3(9);
    light.colour = Rgb(1, 1, 0.5);
    light.shadowless = true;
    scene.lights.push_back({light, {}});
    scene.objects.push_back(object(Sphere()));
    CHECK(dump(scene) ==
          "#version 3.6;\n"
          "global_settings { max_trace_level 7 light_sampler { light_octree threshold 0.1 } }\n"
          "background { rgb <0, 0, 1> }\n"
          "camera { orthographic location <0, 0, -5> look_at 0 angle 40 }\n"
          "light_source { 9, rgb <1, 1, 0.5> shadowless }\n"
          "sphere { 0, 1 }\n");
}

TEST_CASE("words are kept whose further values are not given") {
    Scene scene = empty_scene();
    SphericalCamera camera;
    camera.angle = 120;
    scene.camera = camera;
    scene.settings.luminaires_said = true;
    const std::string text = dump(scene);
    INFO(text);
    CHECK(text.find("global_settings { luminaires emission }\n") != std::string::npos);
    CHECK(text.find("camera { spherical angle 120 }\n") != std::string::npos);
}

TEST_CASE("a camera is written with its normal, a light with its window") {
    Scene scene = empty_scene();
    PatternUse bumps;
    bumps.pattern = Bumps{};
    scene.camera_normal.pattern =
        make_handle<PatternedBump>(bumps, BumpSettings(), PatternedBump::Map());
    PlacedLight light{PointLight{}, {}};
    light.projected_through = object(Sphere());
    scene.lights.push_back(light);
    const std::string text = dump(scene);
    INFO(text);
    CHECK(text.find(" normal { bumps ") != std::string::npos);
    CHECK(text.find(" projected_through { sphere { 0, 1 } } }\n") != std::string::npos);
}

TEST_CASE("before version 3.7 it is written that there is a gamma") {
    Scene scene = empty_scene();
    scene.language_version = 3.6;
    CHECK(dump(scene) ==
          "#version 3.6;\nglobal_settings { assumed_gamma 1 }\ncamera { perspective }\n");
    scene.settings.assumed_gamma = 2.2;
    CHECK(dump(scene) ==
          "#version 3.6;\nglobal_settings { assumed_gamma 2.2 }\ncamera { perspective }\n");
    scene.gamma_handling = false;
    scene.settings.assumed_gamma = 1;
    CHECK(dump(scene) == "#version 3.6;\ncamera { perspective }\n");
}

TEST_CASE("an object that occurs more than once is declared once, before its first use") {
    const ObjectHandle lamp = object(Sphere());
    const ObjectHandle pair = group(Csg::together, {lamp, object(Cuboid{Vec3(0), Vec3(2)}), lamp});
    CHECK(body({pair, pair, lamp}) ==
          "#declare Object_1 = sphere { 0, 1 }\n"
          "#declare Object_2 = union {\n"
          "    object { Object_1 }\n"
          "    box { 0, 2 }\n"
          "    object { Object_1 }\n"
          "}\n"
          "object { Object_2 }\n"
          "object { Object_2 }\n"
          "object { Object_1 }\n");
}

TEST_CASE("a union of one object that adds nothing is that object") {
    CHECK(body({group(Csg::together, {group(Csg::together, {object(Sphere())})})}) ==
          "sphere { 0, 1 }\n");
    Object hidden;
    hidden.form = Union{{object(Sphere())}, {}, {}};
    hidden.no_shadow = true;
    CHECK(body({make_handle<Object>(hidden)}) ==
          "union {\n    sphere { 0, 1 }\n    no_shadow\n}\n");
}

TEST_CASE("sharing and depth beyond all bounds give a text of a sensible size") {
    ObjectHandle doubled = object(Sphere());
    for (int i = 0; i < 60; ++i) doubled = group(Csg::together, {doubled, doubled});
    CHECK(body({doubled}).size() < 10000);

    ObjectHandle deep = object(Sphere());
    for (int i = 0; i < 2000; ++i) deep = group(Csg::together, {deep, object(Sphere())});
    const std::string text = body({deep});
    CHECK(text.size() < 500000);
    CHECK(text.find(std::string(4 * 20, ' ')) == std::string::npos);
}

TEST_CASE("a black background is told from none, which is clear in a picture with alpha") {
    Scene scene = empty_scene();
    CHECK(dump(scene).find("background") == std::string::npos);
    scene.background.colour = {};
    CHECK(dump(scene).find("background { rgb 0 }") != std::string::npos);
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "objects/imported_content.h"

#include "scene/dump.h"
#include "support/gltf.h"
#include "support/rgb.h"
#include "support/script.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

constexpr std::string_view four_nodes = R"({"nodes": [
    {"name": "Root", "children": [1, 2, 3], "scale": [2, 2, 2]},
    {"name": "Left", "mesh": 0, "translation": [1, 2, 3]},
    {"name": "Right", "mesh": 0, "rotation": [0, 0.70710678, 0, 0.70710678]},
    {"name": "Flat", "mesh": 0, "scale": [1, 0, 1]}]})";

Script run_model(const std::string& statements, const std::string& file) {
    return run("#version 3.7;\n" + statements, {{"a.gltf", file}});
}

/// The corners of all triangles as the scene has them.
void corners_of(const Object& object, const Transform& outer, std::vector<Vec3>& corners) {
    const Transform whole = object.transform ? object.transform->then(outer) : outer;
    if (const auto* all = std::get_if<Union>(&object.form)) {
        for (const ObjectHandle& child : all->children) corners_of(*child, whole, corners);
        return;
    }
    const Mesh& mesh = *std::get<Shared<Mesh>>(std::get<Shape>(object.form));
    for (const Face& face : mesh.faces)
        for (const int corner : {face[0], face[1], face[2]})
            corners.push_back(whole.point(mesh.vertices[static_cast<std::size_t>(corner)]));
}

std::vector<Vec3> corners_of(const Script& done) {
    std::vector<Vec3> corners;
    for (const ObjectHandle& object : done.scene.objects) corners_of(*object, {}, corners);
    return corners;
}

void check_near(const std::vector<Vec3>& found, const std::vector<Vec3>& expected) {
    REQUIRE(found.size() == expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
        INFO(i << ": " << found[i].x << ' ' << found[i].y << ' ' << found[i].z);
        CHECK(length(found[i] - expected[i]) < 1e-6);
    }
}

void meshes_of(const Object& object, std::vector<const Mesh*>& meshes) {
    if (const auto* all = std::get_if<Union>(&object.form))
        for (const ObjectHandle& child : all->children) meshes_of(*child, meshes);
    else
        meshes.push_back(&*std::get<Shared<Mesh>>(std::get<Shape>(object.form)));
}

}  // namespace

TEST_CASE("parts of a model stand where the file has them, with z the other way", "[objects]") {
    const Script done = run_model("model { file \"a.gltf\" }", gltf(four_nodes));
    INFO(done.text);
    CHECK(done.said.empty());
    // Left: moved and doubled. Right: x leads to -z in the file, and so to +z in the scene. Flat has
    // no size.
    check_near(corners_of(done),
               {{2, 4, -6}, {6, 4, -6}, {2, 6, -6}, {0, 0, 0}, {0, 0, 4}, {0, 2, 0}});
}

TEST_CASE("a part stands on the origin, as large and turned as in the model", "[objects]") {
    const Script left =
        run_model("model { file \"a.gltf\" part \"Left\" translate 10*x }", gltf(four_nodes));
    check_near(corners_of(left), {{10, 0, 0}, {14, 0, 0}, {10, 2, 0}});
    const Script none = run_model("model { file \"a.gltf\" part \"Lift\" }", gltf(four_nodes));
    CHECK(none.text.find("the model has no part \"Lift\"") != std::string::npos);
    CHECK(none.text.find("did you mean \"Left\"?") != std::string::npos);
    const Script flat = run_model("model { file \"a.gltf\" part \"Flat\" }", gltf(four_nodes));
    CHECK(flat.text.find("there is nothing in the model") != std::string::npos);
}

TEST_CASE("a mesh is stored once, however often it is shown", "[objects]") {
    const Script done = run_model(
        "#declare A = model { file \"a.gltf\" }\n#for (I, 1, 3) object { A translate I*x } #end\n"
        "#for (I, 1, 3) model { file \"a.gltf\" part \"Left\" translate I*x } #end",
        gltf(four_nodes));
    INFO(done.text);
    std::vector<const Mesh*> meshes;
    for (const ObjectHandle& object : done.scene.objects) meshes_of(*object, meshes);
    REQUIRE(meshes.size() == 9);
    for (const Mesh* mesh : meshes) CHECK(mesh == meshes.front());
}

TEST_CASE("lights of a model are light sources in units of the scene", "[objects]") {
    const std::string file = gltf(R"({"extensionsUsed": ["KHR_lights_punctual"],
        "nodes": [{"name": "Root", "children": [1, 2, 3]},
            {"translation": [1, 2, 3], "extensions": {"KHR_lights_punctual": {"light": 0}}},
            {"rotation": [0.70710678, 0, 0, -0.70710678],
             "extensions": {"KHR_lights_punctual": {"light": 1}}},
            {"extensions": {"KHR_lights_punctual": {"light": 2}}}],
        "extensions": {"KHR_lights_punctual": {"lights": [
            {"type": "point", "color": [1, 1, 1], "intensity": 50},
            {"type": "spot", "intensity": 7, "spot": {"innerConeAngle": 0.5, "outerConeAngle": 1}},
            {"type": "directional", "intensity": 3}]}}})");
    const std::string units = "global_settings { photometry { unit 1 white 100 } }\n";
    const Script done = run_model(units + "model { file \"a.gltf\" scale 2 }", file);
    INFO(done.text);
    const Script own =
        run("#version 3.7;\n" + units +
            "light_source { <2, 4, -6>, 1 intensity candela(50) }\n"
            "light_source { 0, 1 spotlight point_at -y radius degrees(0.5) falloff degrees(1) "
            "intensity candela(7) }\n"
            "light_source { -2e6*z, rgb lux(3) parallel point_at 0 }");
    INFO(own.text);
    REQUIRE(done.scene.lights.size() == 3);
    REQUIRE(own.scene.lights.size() == 3);
    for (std::size_t i = 0; i < 3; ++i) {
        const PointLight& a = done.scene.lights[i].light;
        const PointLight& b = own.scene.lights[i].light;
        INFO(i);
        CHECK(length(a.location - b.location) < 1e-6);
        CHECK(length(a.colour - b.colour) < 1e-9 * length(b.colour));
        CHECK(a.fade_power == b.fade_power);
        CHECK(a.beam == b.beam);
        CHECK(a.parallel == b.parallel);
        if (i > 0) CHECK(length(axis_of(a) - axis_of(b)) < 1e-7);
        CHECK(a.radius.value_or(0) == Approx(b.radius.value_or(0)));
        CHECK(a.falloff.value_or(0) == Approx(b.falloff.value_or(0)));
    }
}

TEST_CASE("measured lights of a model are those of the same file in the scene", "[objects]") {
    // Brightest towards C90.
    const std::string web =
        "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 5 1 2 0 0 0\n1 1 10\n0 45 90\n"
        "0 90 180 270 360\n100 50 10\n100 200 20\n100 50 10\n100 30 5\n100 50 10\n";
    const std::string file = gltf(R"({"extensionsUsed": ["EXT_lights_ies"], "nodes": [
        {"name": "Root", "children": [1, 2]},
        {"translation": [1, 2, 3], "extensions": {"EXT_lights_ies": {"light": 0}}},
        {"extensions": {"EXT_lights_ies": {"light": 0, "multiplier": 3}}}],
        "extensions": {"EXT_lights_ies": {"lights": [{"uri": "lamp.ies"}]}}})");
    const std::string units = "#version 3.7; global_settings { photometry { unit 1 white 100 } }\n";
    const Script done =
        run(units + "model { file \"a.gltf\" }", {{"a.gltf", file}, {"lamp.ies", web}});
    INFO(done.text);
    // In the file, C0 is along y and C90 along -x of a light that shines along -z.
    const Script own = run(units +
                               "light_source { <1, 2, -3>, 1 ies \"lamp.ies\" aim z c0 y }\n"
                               "light_source { 0, 1 ies \"lamp.ies\" aim z c0 y multiplier 3 }",
                           {{"lamp.ies", web}});
    INFO(own.text);
    REQUIRE(done.scene.lights.size() == 2);
    REQUIRE(own.scene.lights.size() == 2);
    for (std::size_t i = 0; i < 2; ++i) {
        const PointLight& a = done.scene.lights[i].light;
        const PointLight& b = own.scene.lights[i].light;
        for (const Vec3 point :
             {Vec3(-1, 2.1, -2), Vec3(2, 2, -2), Vec3(1, 3, -2), Vec3(1, 1, -2)}) {
            const Incidence one = incidence(a, a.location, point),
                            two = incidence(b, b.location, point);
            CHECK(length(one.colour - two.colour) <= 1e-9 * length(two.colour));
        }
    }
    const PointLight& first = done.scene.lights[0].light;
    const auto at = [&](const Vec3& offset) {
        return incidence(first, first.location, first.location + offset).colour.r;
    };
    CHECK(at({-1, 0, 1}) > 3 * at({1, 0, 1}));  // C90 and C270
    CHECK(at({-1, 0, 1}) > 3 * at({0, 1, 1}));
    CHECK(done.text.empty());
}

TEST_CASE("measured lights that cannot be read are left out with a warning", "[objects]") {
    const auto said = [](const std::string& profile) {
        return run("#version 3.7; model { file \"a.gltf\" }",
                   {{"a.gltf", gltf(R"({"extensionsUsed": ["EXT_lights_ies"], "nodes": [
                        {"name": "Root", "mesh": 0, "extensions": {"EXT_lights_ies": {"light": 0}}}],
                        "extensions": {"EXT_lights_ies": {"lights": [)" +
                                    profile + "]}}}")}})
            .text;
    };
    CHECK(said(R"({"uri": "none.ies"})").find("`none.ies` cannot be read: it is not beside") !=
          std::string::npos);
    CHECK(said(R"({"uri": "data:,"})").find("light profile 0 of the model") != std::string::npos);
}

TEST_CASE("measured lights of a model follow the tilt of their lamp", "[objects]") {
    const std::string web =
        "IESNA:LM-63-2002\nTILT=INCLUDE\n1\n3\n0 45 90\n1 0.5 0.25\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n"
        "0 90\n0\n100 100\n";
    const std::string file = gltf(R"({"extensionsUsed": ["EXT_lights_ies"], "nodes": [
        {"name": "Root", "children": [1, 2]},
        {"extensions": {"EXT_lights_ies": {"light": 0, "multiplier": 3}}},
        {"rotation": [-0.70710678, 0, 0, 0.70710678],
         "extensions": {"EXT_lights_ies": {"light": 0, "multiplier": 3}}}],
        "extensions": {"EXT_lights_ies": {"lights": [{"uri": "lamp.ies"}]}}})");
    Script done =
        run("#version 3.7; model { file \"a.gltf\" }", {{"a.gltf", file}, {"lamp.ies", web}});
    INFO(done.text);
    REQUIRE(done.scene.lights.size() == 2);
    const auto along_aim = [&](std::size_t i) {
        PointLight light = done.scene.lights[i].light;
        settle(light);
        return incidence(light, Vec3(0), light.aim).colour.r;
    };
    // The first one shines along the horizon, the other one straight down.
    CHECK(along_aim(1) > 0);
    CHECK(along_aim(0) == Approx(0.25 * along_aim(1)));
}

TEST_CASE("cameras of a model stand and look where the file has them", "[objects]") {
    const std::string file = gltf(R"({"nodes": [
        {"name": "Root", "mesh": 0, "children": [1, 3], "scale": [2, 2, 2]},
        {"name": "Stand", "translation": [1, 2, 3], "children": [2]},
        {"name": "Near", "camera": 0, "rotation": [0, 0.70710678, 0, 0.70710678]},
        {"name": "Plan", "camera": 1, "rotation": [-0.70710678, 0, 0, 0.70710678]}], "cameras": [
        {"name": "Wide", "type": "perspective", "perspective": {"yfov": 1.57079633, "znear": 0.1}},
        {"type": "orthographic", "orthographic": {"xmag": 3, "ymag": 2, "znear": 0, "zfar": 9}}]})");
    const auto camera = [&](const std::string& words, const std::string& more = "") {
        return run_model("camera { model { file \"a.gltf\" " + words + " } " + more + " }", file);
    };
    // Turned by 90 degrees about y, a camera looks along -x.
    for (const char* words : {"", "part \"Near\"", "part \"Wide\"", "part \"Stand\""}) {
        const Script done = camera(words);
        INFO(words << '\n' << done.text);
        REQUIRE(done.said.empty());
        CHECK(std::holds_alternative<Perspective>(done.scene.camera));
        check_near({done.view().location, *done.view().direction, *done.view().up},
                   {{2, 4, -6}, {-1, 0, 0}, {0, 2, 0}});
        const double aspect = length(*done.view().right) / 2;
        check_near({*done.view().right}, {{0, 0, 2 * aspect}});
    }
    const Script above = camera("part \"Plan\"");
    INFO(above.text);
    CHECK(std::holds_alternative<Orthographic>(above.scene.camera));
    check_near({*above.view().direction, *above.view().up}, {{0, -1, 0}, {0, 0, 4}});
    CHECK(camera("", "angle 30").view().angle == 30);
    const Script none = camera("part \"Neat\"");
    REQUIRE_FALSE(none.said.empty());
    CHECK(none.said[0].message == "the model has no camera \"Neat\"");
    CHECK(none.text.find("did you mean \"Near\"?") != std::string::npos);
    CHECK(camera("part \"Roof\"").text.find("the file has \"Near\", \"Plan\"") !=
          std::string::npos);
    CHECK(run_model("camera { model { file \"a.gltf\" } }", gltf()).said.at(0).message ==
          "the model has no camera");
    CHECK(dump(run(dump(above.scene)).scene) == dump(above.scene));
}

TEST_CASE("files of one mesh are turned as models are", "[objects]") {
    const Script done = run("#version 3.7; model { file \"a.off\" }",
                            {{"a.off", "OFF\n3 1 0\n0 0 1\n1 0 1\n0 1 1\n3 0 1 2\n"}});
    INFO(done.text);
    check_near(corners_of(done), {{0, 0, -1}, {1, 0, -1}, {0, 1, -1}});
}

TEST_CASE("files beside a model are looked for in its folder", "[objects]") {
    const std::string obj = "mtllib ../../a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl Red\nf 1 2 3\n";
    const std::string script = "#version 3.7; model { file \"m/a.obj\" }";
    const Script with = run(script, {{"m/a.obj", obj}, {"m/a.mtl", "newmtl Red\nKd 1 0 0\n"}});
    INFO(with.text);
    CHECK(with.said.empty());
    CHECK(dump(with.scene).find("rgb <1, 0, 0>") != std::string::npos);
    const Script without = run(script, {{"m/a.obj", obj},
                                        {"../../a.mtl", "newmtl Red\nKd 1 0 0\n"},
                                        {"m/../../a.mtl", "newmtl Red\nKd 1 0 0\n"}});
    REQUIRE(without.said.size() == 1);
    CHECK(without.said[0].severity == Severity::warning);
    CHECK(without.said[0].message.find("`a.mtl` is not beside the model") != std::string::npos);
}

TEST_CASE("models that are missing or broken are errors", "[objects]") {
    const auto first = [](const Script& done) {
        REQUIRE(done.said.size() == 1);
        return done.said[0].message;
    };
    CHECK(first(run("#version 3.7; model { file \"none.glb\" }")).find("none.glb") !=
          std::string::npos);
    CHECK(first(run("#version 3.7; model { file \"a.glb\" }", {{"a.glb", glb().substr(0, 99)}}))
              .starts_with("cannot read the model `a.glb`: "));
    CHECK(first(run("#version 3.7; model { }")) == "`model` needs a file");
    CHECK(first(run_model("model { file \"a.gltf\" }", gltf(R"({"meshes": [{"primitives": [
        {"attributes": {"POSITION": 0}, "indices": 99}]}]})")))
              .starts_with("cannot read the model"));
}

TEST_CASE("what is left out of a model is said once", "[objects]") {
    const Script done =
        run_model("#for (I, 1, 3) model { file \"a.gltf\" translate I*x } #end",
                  gltf(R"({"animations": [{"channels": [{"sampler": 0, "target": {"node": 0, "path":
                 "translation"}}], "samplers": [{"input": 3, "output": 4}]}],
                 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
                                "min": [0, 0, 0], "max": [2, 1, 0]},
                 {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"},
                 {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"},
                 {"bufferView": 0, "componentType": 5126, "count": 1, "type": "SCALAR"},
                 {"bufferView": 0, "componentType": 5126, "count": 1, "type": "VEC3"}]})"));
    INFO(done.text);
    REQUIRE(done.said.size() == 1);
    CHECK(done.said[0].message == "this is left out of the model: its movements");
}

}  // namespace candelabra

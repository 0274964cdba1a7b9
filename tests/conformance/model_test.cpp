// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of models beside those of the same scene in the language.
#include "scene/dump.h"
#include "session/make_picture.h"
#include "support/folder.h"
#include "support/gltf.h"
#include "support/models.h"
#include "support/rgb.h"
#include "support/script.h"
#include "text/excerpt.h"

#include <catch2/catch.hpp>

namespace candelabra {

namespace {

const std::string surroundings =
    "#version 3.7;\n"
    "global_settings { assumed_gamma 1 }\n"
    "#default { finish { ambient 0 diffuse 0.8 } }\n"
    "camera { location <0.6, 0.7, -3> look_at <0.6, 0.4, 0> }\n"
    "light_source { <2, 3, -4>, 1 }\n"
    "plane { y, -0.2 pigment { rgb 0.5 } }\n";

/// The triangle of the files in the language, with z the other way.
const std::string own_triangle =
    "mesh2 { vertex_vectors { 3, 0, 2*x, y } uv_vectors { 3, <0, 0>, <1, 0>, <0, 1> } "
    "face_indices { 1, <0, 1, 2> } ";

/// The same triangle, where z is up: what is (x, y, z) elsewhere is (x, -z, y) here.
const std::string fbx_of_triangle = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  { FBXHeaderVersion: 1003
FBXVersion: 7400 }
GlobalSettings:  { Version: 1000
Properties70:  { P: "UpAxis", "int", "Integer", "", 2
P: "UpAxisSign", "int", "Integer", "", 1
P: "FrontAxis", "int", "Integer", "", 1
P: "FrontAxisSign", "int", "Integer", "", -1
P: "CoordAxis", "int", "Integer", "", 0
P: "CoordAxisSign", "int", "Integer", "", 1 } }
Definitions:  { Version: 100
Count: 3 }
Objects:  {
Geometry: 1, "Geometry::Triangle", "Mesh" {
Vertices: *9 { a: 0,0,0,2,0,0,0,0,1 }
PolygonVertexIndex: *3 { a: 0,1,-3 }
LayerElementMaterial: 0 { Version: 101
MappingInformationType: "AllSame"
ReferenceInformationType: "IndexToDirect"
Materials: *1 { a: 0 } }
Layer: 0 { Version: 100
LayerElement:  { Type: "LayerElementMaterial"
TypedIndex: 0 } } }
Model: 2, "Model::Root", "Mesh" { Version: 232 }
Material: 3, "Material::Paint", "" { Version: 102
ShadingModel: "lambert"
Properties70:  { P: "DiffuseColor", "Color", "", "A", 0.5,0.25,0.125 } } }
Connections:  {
C: "OO",2,0
C: "OO",1,2
C: "OO",3,2 }
)";

/// `around` comes before the statements.
std::vector<Rgb> pixels_of(const std::string& statements, const Folder& folder,
                           const std::string& around = surroundings) {
    SessionSettings settings;
    folder.put("scene.pov", around + statements);
    settings.source.path = folder / "scene.pov";
    settings.render.width = 40;
    settings.render.height = 30;
    settings.render.samples = 4;
    std::string said;
    Listener listener;
    listener.diagnostic = [&](const Diagnostic& each, const SourceStore& sources) {
        said += format(each, sources, false);
    };
    const auto picture = make_picture(settings, listener);
    INFO(said);
    CHECK(said.empty());
    REQUIRE(picture);
    return picture->image.pixels;
}

}  // namespace

TEST_CASE("a model of each format shows what the same mesh in the language shows", "[model]") {
    const Folder folder;
    const std::string corners = "0 0 0 2 0 0 0 1 0";
    folder.put("a.gltf", gltf());
    folder.put("a.glb", glb());
    folder.put("a.obj", "mtllib a.mtl\nv 0 0 0\nv 2 0 0\nv 0 1 0\nusemtl Paint\nf 1 2 3\n");
    folder.put("a.mtl", "newmtl Paint\nKd 0.5 0.25 0.125\n");
    folder.put("a.off", "OFF\n3 1 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n");
    folder.put("a.ply",
               "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
               "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
               "end_header\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n");
    folder.put("a.stl",
               "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 2 0 0\nvertex 0 1 0\n"
               "endloop\nendfacet\nendsolid s\n");
    folder.put("a.dae",
               R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"
version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset>
<library_effects><effect id="e"><profile_COMMON><technique sid="t"><lambert>
<diffuse><color>0.5 0.25 0.125 1</color></diffuse></lambert></technique></profile_COMMON></effect>
</library_effects><library_materials><material id="m" name="Paint"><instance_effect url="#e"/>
</material></library_materials><library_geometries><geometry id="g"><mesh><source id="p">
<float_array id="f" count="9">)" +
                   corners + R"(</float_array><technique_common><accessor source="#f" count="3"
stride="3"><param name="X" type="float"/><param name="Y" type="float"/><param name="Z"
type="float"/></accessor></technique_common></source><vertices id="v"><input semantic="POSITION"
source="#p"/></vertices><triangles count="1" material="m"><input semantic="VERTEX" source="#v"
offset="0"/><p>0 1 2</p></triangles></mesh></geometry></library_geometries><library_visual_scenes>
<visual_scene id="s"><node id="n"><instance_geometry url="#g"><bind_material><technique_common>
<instance_material symbol="m" target="#m"/></technique_common></bind_material></instance_geometry>
</node></visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene>
</COLLADA>)");
    folder.put("a.fbx", fbx_of_triangle);
    folder.put("a.3mf", threemf("#FF8000"));
    const std::string colour = "pigment { rgb <0.5, 0.25, 0.125> } ";
    const std::string facets =
        colour + "finish { ambient 0 microfacet { roughness 0.5 metallic 0 } }";
    const auto by_facets = pixels_of(own_triangle + facets + " }", folder);
    const auto by_diffuse =
        pixels_of(own_triangle + colour + "finish { ambient 0 diffuse 1 } }", folder);
    const auto plain = pixels_of(own_triangle + "pigment { rgb 0.3 } }", folder);
    const auto of_file = [&](const std::string& name, const std::string& more = "") {
        return pixels_of("model { file \"" + name + "\" " + more + " }", folder);
    };
    CHECK(of_file("a.gltf") == by_facets);
    CHECK(of_file("a.glb") == by_facets);
    CHECK(of_file("a.obj") == by_diffuse);
    CHECK(of_file("a.dae") == by_diffuse);
    CHECK(of_file("a.fbx") == by_diffuse);
    const auto in_3mf = of_file("a.3mf");
    const auto yellow = pixels_of(
        own_triangle + "pigment { srgb <1, 0.5019608, 0> } finish { ambient 0 diffuse 1 } }",
        folder);
    REQUIRE(in_3mf.size() == yellow.size());
    for (std::size_t i = 0; i < yellow.size(); ++i) CHECK(length(in_3mf[i] - yellow[i]) < 1e-6);
    CHECK(of_file("a.3mf", "replace \"Paint\" texture { pigment { rgb 0.3 } }") == plain);
    for (const char* name : {"a.off", "a.ply", "a.stl"})
        CHECK(of_file(name, "pigment { rgb 0.3 }") == plain);
}

TEST_CASE("cameras of models see what the same camera in the language sees", "[model]") {
    const Folder folder;
    folder.put("a.gltf",
               gltf(R"({"nodes": [{"name": "Stand", "camera": 0, "translation": [1, 2, 3]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 1.28700222, "znear": 0.1}}]})"));
    folder.put("a.dae", dae_of_camera("<perspective><xfov>90</xfov><aspect_ratio>1.33333333"
                                      "</aspect_ratio></perspective>"));
    folder.put("b.dae", dae_of_camera("<orthographic><ymag>1.5</ymag></orthographic>"));
    folder.put("a.fbx", fbx_of_camera());
    const std::string start = "#version 3.7; global_settings { assumed_gamma 1 }\n";
    // Not alike from the left, from above and from the front.
    const std::string objects =
        "light_source { <2, 3, -4>, 1 }\n"
        "cylinder { <1, 2, 0>, <3, 2, 0>, 0.3 pigment { rgb x } finish { ambient 1 } }\n"
        "cylinder { <1, 2, 0>, <1, 3, 0>, 0.3 pigment { rgb y } finish { ambient 1 } }\n"
        "cylinder { <0, 1, -1>, <0, 1, 3>, 0.3 pigment { rgb z } finish { ambient 1 } }\n";
    const auto seen = [&](const std::string& camera) {
        return pixels_of(objects, folder, start + "camera { " + camera + " }\n");
    };
    const auto check_alike = [](const std::vector<Rgb>& one, const std::vector<Rgb>& other) {
        REQUIRE(one.size() == other.size());
        double sum = 0, apart = 0;
        for (std::size_t i = 0; i < one.size(); ++i) {
            sum += length(other[i]);
            apart += length(one[i] - other[i]);
        }
        CHECK(sum > 100);
        CHECK(apart < 1e-3 * sum);
    };
    const std::string place = "location <1, 2, -3> direction z ";
    const auto own = seen(place + "right 2*x up 1.5*y");
    for (const char* name : {"a.gltf", "a.dae", "a.fbx"}) {
        INFO(name);
        check_alike(seen(std::string("model { file \"") + name + "\" }"), own);
    }
    check_alike(seen("model { file \"b.dae\" }"),
                seen("orthographic " + place + "right 4*x up 3*y"));
    check_alike(seen("model { file \"a.gltf\" } angle 60"),
                seen(place + "right 4/3*x up y angle 60"));
}

TEST_CASE("the outside of a model is the side from which its corners run counterclockwise",
          "[model]") {
    const Folder folder;
    folder.put("a.gltf", gltf());
    folder.put("a.off", "OFF\n3 1 0\n0 0 0\n2 0 0\n0 1 0\n3 0 1 2\n");
    const std::string light = " finish { ambient 1 diffuse 0 } }";
    const std::string sides =
        "texture { pigment { rgb x }" + light + " interior_texture { pigment { rgb y }" + light;
    const std::string start = "#version 3.7; camera { location <0.6, 0.4, -3> direction z }\n";
    for (const std::string& model :
         {std::string("model { file \"a.off\" " + sides + " }"),
          "model { file \"a.gltf\" replace \"Paint\" texture { pigment { rgb x }" + light +
              " interior_texture { pigment { rgb y }" + light + " }"}) {
        const auto outside = pixels_of(model, folder, start);
        Rgb sum(0);
        for (const Rgb& pixel : outside) sum += pixel;
        CHECK(sum.r > 10);
        CHECK(sum.g == 0);
    }
}

TEST_CASE("maps of normals turn normals by u and v", "[model]") {
    const Folder folder;
    const std::string map("\xbf\x50\xe6", 3);  // to the right, downwards, outwards
    folder.put("n.ppm", "P6 1 1 255\n" + map);
    const auto part = [&](std::size_t i) {
        return 2 * static_cast<unsigned char>(map[i]) / 255.0 - 1;
    };
    const double right = part(0), up = part(1), outwards = part(2);
    // The map has the axes of u and v, whether v leads up or down in the numbers of a file, and
    // whether the picture is turned or mirrored on the surface.
    struct Row {
        std::string move;
        Vec3 u, v;
    };
    const std::vector<Row> rows = {{R"({"scale": [1, 1]})", {1, 0, 0}, {0, 1, 0}},
                                   {R"({"rotation": 1.57079633})", {0, -1, 0}, {1, 0, 0}},
                                   {R"({"scale": [-1, 1]})", {-1, 0, 0}, {0, 1, 0}},
                                   {R"({"scale": [1, -3]})", {1, 0, 0}, {0, -1, 0}}};
    for (const double scale : {1.0, 0.5})
        for (const Row& row : rows) {
            INFO(row.move << ", scale " << scale);
            folder.put("a.gltf",
                       gltf(R"({"extensionsUsed": ["KHR_texture_transform"], "materials": [
                {"normalTexture": {"index": 0, "scale": )" +
                            std::to_string(scale) +
                            R"(, "extensions": {"KHR_texture_transform": )" + row.move + R"(}},
                 "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5}}],
                "textures": [{"source": 0}], "images": [{"uri": "n.ppm"}]})"));
            const Vec3 normal =
                scale * right * row.u + scale * up * row.v + outwards * Vec3(0, 0, -1);
            const std::string each = "<" + std::to_string(normal.x) + ", " +
                                     std::to_string(normal.y) + ", " + std::to_string(normal.z) +
                                     ">";
            // Three equal normals would count as none, by the rules of the language.
            const auto own = pixels_of(
                "mesh2 { vertex_vectors { 3, 0, 2*x, y } normal_vectors { 3, " + each + ", " +
                    each + " + 0.0002*x, " + each +
                    " + 0.0002*y } face_indices { 1, <0, 1, 2> } pigment { rgb 1 } finish { "
                    "ambient 0 microfacet { roughness 0.5 metallic 0 } } }",
                folder);
            const auto model = pixels_of("model { file \"a.gltf\" }", folder);
            REQUIRE(model.size() == own.size());
            for (std::size_t i = 0; i < own.size(); ++i)
                CHECK(length(model[i] - own[i]) < 1e-3 * (1 + length(own[i])));
        }
}

TEST_CASE("the dump of a model that has its pictures and profiles inside shows the same",
          "[model]") {
    const Folder folder;
    const std::string picture =
        "data:image/x-portable-pixmap;base64," +
        in_base64("P6 2 2 255\n" + std::string("\xff\x40\0\x10\xff\0\x80\0\xff\xff\xff\xff", 12));
    const std::string web =
        "data:application/octet-stream;base64," +
        in_base64("IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 10\n0 60\n0\n900 100\n");
    const std::string file = glb(R"({"extensionsUsed": ["EXT_lights_ies"], "nodes": [
        {"name": "Root", "mesh": 0, "children": [1]},
        {"translation": [0.5, 0.5, 2], "extensions": {"EXT_lights_ies": {"light": 0, "multiplier": 3}}}],
        "extensions": {"EXT_lights_ies": {"lights": [{"uri": ")" +
                                 web + R"("}]}},
        "materials": [{"alphaMode": "MASK", "normalTexture": {"index": 0},
            "pbrMetallicRoughness": {"metallicFactor": 0, "roughnessFactor": 0.5,
            "baseColorFactor": [0.5, 0.25, 1, 1], "baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": ")" +
                                 picture + "\"}]}");
    folder.put("a.glb", file);
    const std::string start =
        "#version 3.7; global_settings { assumed_gamma 1 photometry { unit 1 white 900 } }\n"
        "camera { location <0.6, 0.7, -3> look_at <0.6, 0.4, 0> }\n";
    const std::string statements = "model { file \"a.glb\" }";
    const auto model = pixels_of(statements, folder, start);
    const Script done = run(start + statements, {{"a.glb", file}});
    INFO(done.text);
    const std::string text = dump(done.scene);
    INFO(text);
    CHECK(text.find("picture 0") != std::string::npos);
    CHECK(text.find("profile 0") != std::string::npos);
    CHECK(text.find("alpha_cutoff 0.5") != std::string::npos);
    const auto again = pixels_of(text, folder, "");
    REQUIRE(again.size() == model.size());
    double sum = 0;
    for (std::size_t i = 0; i < model.size(); ++i) {
        CHECK(length(again[i] - model[i]) <= 1e-9 * length(model[i]));
        sum += model[i].r;
    }
    CHECK(sum > 1);
}

TEST_CASE("what emits in a model lights the scene as a luminaire", "[model]") {
    const Folder folder;
    folder.put("a.glb", glb(R"({"extensionsUsed": ["KHR_materials_emissive_strength"],
        "materials": [{"name": "Lamp", "emissiveFactor": [1, 0.5, 0.25],
        "pbrMetallicRoughness": {"baseColorFactor": [0, 0, 0, 1]},
        "extensions": {"KHR_materials_emissive_strength": {"emissiveStrength": 8}}}]})"));
    const auto model = pixels_of("model { file \"a.glb\" translate -0.3*z }", folder);
    const auto own = pixels_of(own_triangle +
                                   "pigment { rgb 1 } finish { ambient 0 diffuse 0 emission "
                                   "<8, 4, 2> } translate -0.3*z }",
                               folder);
    REQUIRE(model.size() == own.size());
    Rgb sum(0);
    for (std::size_t i = 0; i < model.size(); ++i) {
        CHECK(length(model[i] - own[i]) < 2e-3 * (1 + length(own[i])));
        sum += own[i];
    }
    CHECK(sum.r > 100);
}

TEST_CASE("models are not mirrored, and u and v lie as in the file", "[model]") {
    const Folder folder;
    folder.put("a.ppm", "P6 2 2 255\n" + std::string("\xff\0\0\0\xff\0\0\0\xff\xff\xff\xff", 12));
    folder.put("a.gltf", gltf(R"({"materials": [{"pbrMetallicRoughness": {"metallicFactor": 0,
        "roughnessFactor": 0.5, "baseColorTexture": {"index": 0}}}],
        "textures": [{"source": 0}], "images": [{"uri": "a.ppm"}]})"));
    const auto own = pixels_of(own_triangle +
                                   "texture { uv_mapping pigment { image_map { ppm \"a.ppm\" "
                                   "interpolate 2 } } finish { ambient 0 microfacet { roughness "
                                   "0.5 metallic 0 } } } }",
                               folder);
    CHECK(pixels_of("model { file \"a.gltf\" }", folder) == own);
}

}  // namespace candelabra

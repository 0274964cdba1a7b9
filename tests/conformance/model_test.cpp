// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of models beside those of the same scene in the language.
#include "session/make_picture.h"
#include "support/folder.h"
#include "support/gltf.h"
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
    "face_indices { 1, <0, 2, 1> } ";

/// The same triangle, where z is up: what is (x, y, z) elsewhere is (x, -z, y) here.
const std::string fbx_of_triangle = R"(; FBX 7.4.0 project file
FBXHeaderExtension:  { FBXHeaderVersion: 1003
FBXVersion: 7400 }
GlobalSettings:  { Version: 1000
Properties70:  { P: "UpAxis", "int", "Integer", "", 2
P: "UpAxisSign", "int", "Integer", "", 1 } }
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

std::vector<Vec3> pixels_of(const std::string& statements, const Folder& folder) {
    SessionSettings settings;
    folder.put("scene.pov", surroundings + statements);
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
    for (const char* name : {"a.off", "a.ply", "a.stl"})
        CHECK(of_file(name, "pigment { rgb 0.3 }") == plain);
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
    Vec3 sum(0);
    for (std::size_t i = 0; i < model.size(); ++i) {
        CHECK(length(model[i] - own[i]) < 2e-3 * (1 + length(own[i])));
        sum += own[i];
    }
    CHECK(sum.x > 100);
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

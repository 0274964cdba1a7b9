// SPDX-License-Identifier: GPL-3.0-or-later
// Small models of formats other than glTF for tests: cameras of Collada and FBX, and a triangle of 3MF.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace candelabra {

/// A Collada file whose node "n" at (1, 2, 3) has a camera with these optics.
inline std::string dae_of_camera(std::string_view optics) {
    return R"(<?xml version="1.0"?><COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema"
version="1.4.1"><asset><up_axis>Y_UP</up_axis></asset><library_cameras><camera id="c"><optics>
<technique_common>)" +
           std::string(optics) +
           R"(</technique_common></optics></camera></library_cameras>
<library_visual_scenes><visual_scene id="s"><node id="n"><translate>1 2 3</translate>
<instance_camera url="#c"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// An FBX file whose node "Stand" at (1, 2, 3) has a camera that is 90 degrees wide in a picture of
/// 4 by 3, and looks along -z.
inline std::string fbx_of_camera() {
    return R"(; FBX 7.4.0 project file
FBXHeaderExtension:  { FBXHeaderVersion: 1003
FBXVersion: 7400 }
GlobalSettings:  { Version: 1000
Properties70:  { P: "UpAxis", "int", "Integer", "", 1
P: "UpAxisSign", "int", "Integer", "", 1 } }
Definitions:  { Version: 100
Count: 2 }
Objects:  {
NodeAttribute: 1, "NodeAttribute::Cam", "Camera" {
Properties70:  { P: "FieldOfView", "FieldOfView", "", "A",90
P: "AspectWidth", "double", "Number", "",400
P: "AspectHeight", "double", "Number", "",300 }
TypeFlags: "Camera" }
Model: 2, "Model::Stand", "Camera" { Version: 232
Properties70:  { P: "Lcl Translation", "Lcl Translation", "", "A",1,2,3
P: "Lcl Rotation", "Lcl Rotation", "", "A",0,90,0 } } }
Connections:  {
C: "OO",2,0
C: "OO",1,2 }
)";
}

/// A file of ZIP with entries that are stored as they are.
inline std::string zip_of(const std::vector<std::pair<std::string, std::string>>& entries) {
    const auto number = [](std::uint64_t n, int bytes) {
        std::string text;
        for (int i = 0; i < bytes; ++i) text += static_cast<char>(n >> (8 * i) & 255);
        return text;
    };
    const auto check = [](std::string_view bytes) {
        std::uint32_t crc = ~0U;
        for (const char c : bytes) {
            crc ^= static_cast<unsigned char>(c);
            for (int i = 0; i < 8; ++i) crc = crc >> 1 ^ (crc & 1 ? 0xedb88320U : 0U);
        }
        return ~crc;
    };
    std::string files, list;
    for (const auto& [name, text] : entries) {
        const std::string about = number(20, 2) + number(0, 8) + number(check(text), 4) +
                                  number(text.size(), 4) + number(text.size(), 4) +
                                  number(name.size(), 2) + number(0, 2);
        list += "PK\1\2" + number(20, 2) + about + number(0, 10) + number(files.size(), 4) + name;
        files += "PK\3\4" + about + name + text;
    }
    const std::string counts = number(entries.size(), 2);
    return files + list + "PK\5\6" + number(0, 4) + counts + counts + number(list.size(), 4) +
           number(files.size(), 4) + number(0, 2);
}

/// A 3MF file of the triangle of support/gltf.h, whose colour is `colour`, such as #FF8000. Its z
/// leads up: what is (x, y, z) elsewhere is (x, -z, y) here.
inline std::string threemf(std::string_view colour) {
    const std::string model = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02">
<resources><basematerials id="1"><base name="Paint" displaycolor=")" +
                              std::string(colour) + R"("/></basematerials>
<object id="2" type="model" pid="1" pindex="0"><mesh><vertices><vertex x="0" y="0" z="0"/>
<vertex x="2" y="0" z="0"/><vertex x="0" y="0" z="1"/></vertices><triangles>
<triangle v1="0" v2="1" v3="2"/></triangles></mesh></object></resources>
<build><item objectid="2"/></build></model>)";
    return zip_of(
        {{"[Content_Types].xml",
          R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
         {"_rels/.rels",
          R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
         {"3D/3dmodel.model", model}});
}

}  // namespace candelabra

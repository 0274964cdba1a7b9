// SPDX-License-Identifier: GPL-3.0-or-later
// Writes small files of every kind for the fuzz targets of files to begin with: seeds FOLDER makes
// FOLDER/picture, FOLDER/mesh and so on. The first byte of most says what the target takes
// the others for.
#include "camera/film_settings.h"
#include "font/system_font.h"
#include "picture/formats.h"
#include "support/gltf.h"

#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>

using namespace candelabra;

namespace {

using namespace std::string_literals;

void put(const std::filesystem::path& path, const std::string& bytes) {
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
}

template <class Value>
void put_picture(const std::filesystem::path& folder, std::string_view extension,
                 std::string_view compression, std::vector<Value> values, int channels) {
    const int height = static_cast<int>(values.size()) / (4 * channels);
    const RawPicture picture{4, height, channels, std::move(values), extension, compression};
    Diagnostics diagnostics;
    if (const auto bytes = write_stored(picture, diagnostics))
        put(folder / (std::string(extension) + "-" + std::string(compression) + "-" +
                      std::to_string(channels)),
            "\0"s + *bytes);
    else
        std::cerr << diagnostics.all().front().message << "\n";
}

void put_pictures(const std::filesystem::path& folder) {
    for (const int channels : {1, 3}) {
        const auto count = static_cast<std::size_t>(12 * channels);
        std::vector<std::uint8_t> bytes;
        std::vector<float> floats;
        for (std::size_t i = 0; i < count; ++i) {
            bytes.push_back(static_cast<std::uint8_t>(29 * i));
            floats.push_back(static_cast<float>(i) / 8);
        }
        for (const char* extension : {"png", "ppm", "tga", "jpg", "bmp", "gif", "tif"})
            if (channels == 3 || std::string_view(extension) != "gif")
                put_picture(folder, extension, "", bytes, channels);
        for (const char* compression : {"none", "lzw", "zip", "packbits", "jpeg"})
            put_picture(folder, "tif", compression, bytes, channels);
        for (const char* compression :
             {"none", "rle", "zip", "zips", "piz", "pxr24", "b44", "dwaa"})
            put_picture(folder, "exr", compression, floats, channels);
    }
    put_picture(folder, "hdr", "", std::vector<float>(36, 0.5F), 3);
    put(folder / "numbers.tga",
        "\1\0\1\1\0\0\2\0\x18\0\0\0\0\2\0\2\0\x8\x20"
        "abcdef\0\1\1\0"s);
    put(folder / "packed.tga",
        "\1\0\1\x9\0\0\2\0\x18\0\0\0\0\2\0\2\0\x8\x20"
        "abcdef\x82\1\0\0"s);
    put(folder / "short.tga",
        "\1\0\0\2\0\0\0\0\0\0\0\0\0\2\0\1\0\x10\x20"
        "abcd"s);
    put(folder / "written.ppm", "\0P3\n2 1\n255\n1 2 3 4 5 6\n"s);
    put(folder / "bits.pbm", "\0P4\n8 2\n\xaa\x55"s);
}

void put_models(const std::filesystem::path& folder) {
    put(folder / "gltf", "\0"s + gltf());
    put(folder / "glb", "\1"s + glb());
    put(folder / "obj", "\2mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 1\nusemtl m\n"
                        "f 1/1 2/1 3/1\n"s);
    put(folder / "fbx",
        "\3; FBX 7.4.0 project file\nObjects: {\nGeometry: 1, \"Geometry::A\", \"Mesh\" {\n"
        "Vertices: *9 { a: 0,0,0,2,0,0,0,1,0 }\nPolygonVertexIndex: *3 { a: 0,1,-3 } }\n"
        "Model: 2, \"Model::B\", \"Mesh\" { Version: 232 } }\nConnections: {\n"
        "C: \"OO\",2,0\nC: \"OO\",1,2 }\n"s);
    put(folder / "dae",
        "\4<?xml version=\"1.0\"?><COLLADA version=\"1.4.1\"><library_geometries><geometry "
        "id=\"g\"><mesh></mesh></geometry></library_geometries></COLLADA>"s);
    put(folder / "3mf", "\5PK\3\4"s + std::string(30, '\0'));
}

void put_meshes(const std::filesystem::path& folder) {
    put(folder / "obj",
        "\0v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 1\nvn 0 0 1\n"
        "f 1/1/1 3/1/1 2/1/1\nf 1 2 4\nf 2 3 4\nf -4//1 -1 3\n"s);
    const std::string head =
        "\1ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\n"
        "property float y\nproperty float z\nelement face 4\n"
        "property list uchar int vertex_indices\nend_header\n";
    put(folder / "ply", head + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n");
    put(folder / "stl",
        "\2solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
        "vertex 0 1 0\nendloop\nendfacet\nendsolid s\n");
    put(folder / "binary-stl", "\2" + std::string(80, ' ') + "\1\0\0\0"s + std::string(24, '\0') +
                                   "\0\0\x80\x3f\0\0\0\0\0\0\0\0\0\0\0\0\0\0\x80\x3f\0\0\0\0\0\0"s);
    put(folder / "off",
        "\3OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n"
        "3 0 3 2\n");
}

/// Options, the text of a film, and light: the first byte says that the light is to be put into a
/// file.
void put_light(const std::filesystem::path& folder) {
    const std::string options = "--exposure=auto\n--glare=on\n--response=agx\n--grain=1\n";
    put(folder / "plain", "\1\0\0\4\3\0\0\0\x80\x3f\0\0\0\x3f\0\0\xa0\x40\0\0\0\0"s);
    put(folder / "options", "\1"s + options + "\0\0\7\7\377\0\0\x80\x3f\0\0\0\x3f\0\0\xa0\x40"s);
    put(folder / "film", "\1\0"s + to_text(FilmSettings()) +
                             "\0\7\0\0\0\0\x80\x7f\0\0\xc0\x7f\0\0\x80\xff\0\0\0\xbf"s);
    const RawPicture picture{4, 2, 3, std::vector<float>(24, 0.5F), "exr", "none"};
    Diagnostics diagnostics;
    put(folder / "file", "\0"s + options + "\0"s + write_stored(picture, diagnostics).value_or(""));
}

}  // namespace

int main(int count, char** arguments) {
    if (count != 2) return std::cerr << "usage: seeds FOLDER\n", 2;
    const std::filesystem::path folder = arguments[1];
    put_pictures(folder / "picture");
    put_meshes(folder / "mesh");
    put_models(folder / "model");
    // All of a font is more than most runs look at: its tables stand at its beginning.
    for (const char* name : {"timrom.ttf", "cyrvetic.ttf"})
        if (const auto font = system_font(name)) put(folder / "font" / name, "\0"s + *font);
    put(folder / "font" / "none", "\0\0\1\0\0"s);
    put(folder / "font" / "sound", "\1"s);
    put(folder / "font" / "changed", "\1\14\0\1\377\0\20\4\1"s);
    put(folder / "state" / "sound", "\1"s);
    put(folder / "state" / "changed", "\1\20\1\7\0\2\377"s);
    put(folder / "state" / "other", "\0v/1\1"s);
    put(folder / "density" / "bytes",
        "\0\2\0\1\0\3"
        "abcdef"s);
    put(folder / "density" / "words",
        "\0\1\0\2\0\1"
        "abcd"s);
    put(folder / "density" / "long",
        "\0\1\0\1\0\2"
        "abcdefgh"s);
    put_light(folder / "develop");
}

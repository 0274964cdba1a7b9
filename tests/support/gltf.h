// SPDX-License-Identifier: GPL-3.0-or-later
// Small glTF files for the tests of models: one triangle or a pair of them, with any nodes, materials
// and lights.
#pragma once

#include <nlohmann/json.hpp>

#include <cstring>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

inline std::string in_base64(std::string_view bytes) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        unsigned group = 0;
        for (std::size_t j = 0; j < 3; ++j)
            group =
                group << 8 | (i + j < bytes.size() ? static_cast<unsigned char>(bytes[i + j]) : 0U);
        for (std::size_t j = 0; j < 4; ++j)
            text += i + j > bytes.size() ? '=' : digits[group >> (18 - 6 * j) & 63];
    }
    return text;
}

/// The triangle (0, 0, 0), (2, 0, 0), (0, 1, 0), seen from +z, with u and v of its corners.
inline std::string triangle_bytes() {
    constexpr float numbers[] = {0, 0, 0, 2, 0, 0, 0, 1, 0, 0, 1, 1, 1, 0, 0};
    constexpr std::uint16_t corners[] = {0, 1, 2, 0};
    std::string bytes(sizeof numbers + sizeof corners, '\0');
    std::memcpy(bytes.data(), numbers, sizeof numbers);
    std::memcpy(bytes.data() + sizeof numbers, corners, sizeof corners);
    return bytes;
}

/// A file whose node "Root" has a triangle with the first material. `changes` is merged into it
/// (RFC 7386).
inline nlohmann::json gltf_of_triangle(std::string_view changes = "{}") {
    nlohmann::json file = nlohmann::json::parse(R"({
        "asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
        "nodes": [{"name": "Root", "mesh": 0}],
        "meshes": [{"name": "Triangle", "primitives": [
            {"attributes": {"POSITION": 0, "TEXCOORD_0": 2}, "indices": 1, "material": 0}]}],
        "materials": [{"name": "Paint", "pbrMetallicRoughness": {
            "baseColorFactor": [0.5, 0.25, 0.125, 1], "metallicFactor": 0, "roughnessFactor": 0.5}}],
        "accessors": [
            {"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3",
             "min": [0, 0, 0], "max": [2, 1, 0]},
            {"bufferView": 2, "componentType": 5123, "count": 3, "type": "SCALAR"},
            {"bufferView": 1, "componentType": 5126, "count": 3, "type": "VEC2"}],
        "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": 36},
                        {"buffer": 0, "byteOffset": 36, "byteLength": 24},
                        {"buffer": 0, "byteOffset": 60, "byteLength": 6}]})");
    const std::string bytes = triangle_bytes();
    file["buffers"] = {{{"byteLength", bytes.size()},
                        {"uri", "data:application/octet-stream;base64," + in_base64(bytes)}}};
    file.merge_patch(nlohmann::json::parse(changes));
    return file;
}

/// The same as text.
inline std::string gltf(std::string_view changes = "{}") {
    return gltf_of_triangle(changes).dump();
}

/// The same as a binary file.
inline std::string glb(std::string_view changes = "{}") {
    nlohmann::json file = gltf_of_triangle(changes);
    std::string bytes = triangle_bytes();
    file["buffers"] = {{{"byteLength", bytes.size()}}};
    std::string text = file.dump();
    text.append((4 - text.size() % 4) % 4, ' ');
    bytes.append((4 - bytes.size() % 4) % 4, '\0');
    const auto number = [](std::size_t n) {
        std::string four;
        for (int i = 0; i < 4; ++i) four += static_cast<char>(n >> (8 * i) & 255);
        return four;
    };
    return "glTF" + number(2) + number(28 + text.size() + bytes.size()) + number(text.size()) +
           "JSON" + text + number(bytes.size()) + std::string("BIN\0", 4) + bytes;
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/gltf_strength.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace candelabra {

namespace {

using Json = nlohmann::json;

constexpr const char* extension = "KHR_materials_emissive_strength";

/// Of a binary file: its head, and that of its first chunk, which is the text.
constexpr std::size_t file_head = 12, heads = 20;

bool is_binary(std::string_view bytes) {
    return bytes.starts_with("glTF") && bytes.size() >= heads;
}

/// A little-endian number of four bytes. Precondition: they are there.
std::size_t number_at(std::string_view bytes, std::size_t place) {
    std::size_t number = 0;
    for (std::size_t i = 4; i > 0; --i)
        number = number << 8 | static_cast<unsigned char>(bytes[place + i - 1]);
    return number;
}

void put_number(std::string& bytes, std::size_t place, std::size_t number) {
    for (std::size_t i = 0; i < 4; ++i)
        bytes[place + i] = static_cast<char>(number >> (8 * i) & 255);
}

/// Multiplies the emission of a material with its strength, if it has both.
void strengthen(Json& material) {
    const Json::json_pointer place =
        Json::json_pointer() / "extensions" / extension / "emissiveStrength";
    if (!material.is_object() || !material.contains(place)) return;
    const Json& stated = material[place];
    const double strength = stated.is_number() ? stated.get<double>() : 1;
    if (material.contains("emissiveFactor") && material["emissiveFactor"].is_array())
        for (Json& channel : material["emissiveFactor"])
            if (channel.is_number() && std::isfinite(strength))
                channel = channel.get<double>() * std::max(strength, 0.0);
    material["extensions"].erase(extension);
}

/// A binary file with another text.
std::string with_text(std::string_view bytes, std::string_view rest, std::string text) {
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string made(bytes.substr(0, heads));
    made += text;
    made += rest;
    put_number(made, 8, made.size());
    put_number(made, file_head, text.size());
    return made;
}

}  // namespace

std::optional<std::string> with_strengths(std::string_view bytes) {
    const bool binary = is_binary(bytes);
    const std::string_view text = binary ? bytes.substr(heads, number_at(bytes, file_head)) : bytes;
    if (text.find(extension) == text.npos) return std::nullopt;
    Json all = Json::parse(text, nullptr, false);
    if (!all.is_object() || !all.contains("materials") || !all["materials"].is_array())
        return std::nullopt;
    for (Json& material : all["materials"]) strengthen(material);
    std::string changed = all.dump();
    if (!binary) return changed;
    return with_text(bytes, bytes.substr(heads + text.size()), std::move(changed));
}

}  // namespace candelabra

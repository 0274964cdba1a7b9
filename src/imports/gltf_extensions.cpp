// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/gltf_extensions.h"

#include "base/elementary.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <utility>

namespace candelabra {

namespace {

using Json = nlohmann::json;

constexpr std::string_view strength_name = "KHR_materials_emissive_strength",
                           move_name = "KHR_texture_transform", web_name = "EXT_lights_ies",
                           cameras_name = "\"cameras\"";

/// Of a binary file: its head, that of its first chunk, which is the text, and that of the next.
constexpr std::size_t file_head = 12, heads = 20, chunk_head = 8;

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

/// A member of an object, whatever the value is; null if there is none.
const Json* member(const Json& value, std::string_view name) {
    if (!value.is_object()) return nullptr;
    const auto found = value.find(std::string(name));
    return found == value.end() ? nullptr : &*found;
}

/// The extension of this name that a part of the file has; null if it has none.
const Json* extension(const Json& value, std::string_view name) {
    const Json* const all = member(value, "extensions");
    const Json* const found = all ? member(*all, name) : nullptr;
    return found && found->is_object() ? found : nullptr;
}

double number_of(const Json* value, double usual) {
    const double number = value && value->is_number() ? value->get<double>() : usual;
    return std::isfinite(number) ? number : usual;
}

/// The whole number of a member, from 0 on; nothing for other values.
std::optional<std::size_t> index_of(const Json& value, std::string_view name) {
    const Json* const found = member(value, name);
    if (!found || !found->is_number_unsigned()) return std::nullopt;
    return found->get<std::size_t>();
}

template <std::size_t count>
std::array<double, count> numbers_of(const Json* value, std::array<double, count> usual) {
    if (value && value->is_array() && value->size() == count)
        for (std::size_t i = 0; i < count; ++i) usual[i] = number_of(&(*value)[i], usual[i]);
    return usual;
}

/// An entry of a list of the file; null if there is none.
const Json* entry(const Json& all, std::string_view list, std::size_t index) {
    const Json* const found = member(all, list);
    return found && found->is_array() && index < found->size() ? &(*found)[index] : nullptr;
}

/// Multiplies the emission of a material with its strength, if it has both.
void strengthen(Json& material) {
    const Json* const stated = extension(material, strength_name);
    if (!stated) return;
    const double strength = number_of(member(*stated, "emissiveStrength"), 1);
    if (material.contains("emissiveFactor") && material["emissiveFactor"].is_array())
        for (Json& channel : material["emissiveFactor"])
            if (channel.is_number()) channel = channel.get<double>() * std::max(strength, 0.0);
    material["extensions"].erase(std::string(strength_name));
}

/// How the picture of the colour is moved, or that of the light or of the normals of a material
/// without one.
std::optional<PictureMove> move_of(const Json& material) {
    const Json* const metallic = member(material, "pbrMetallicRoughness");
    const Json* shown = metallic ? member(*metallic, "baseColorTexture") : nullptr;
    for (const char* other : {"emissiveTexture", "normalTexture"})
        if (!shown) shown = member(material, other);
    const Json* const stated = shown ? extension(*shown, move_name) : nullptr;
    if (!stated) return std::nullopt;
    PictureMove made;
    made.offset = numbers_of<2>(member(*stated, "offset"), made.offset);
    made.scale = numbers_of<2>(member(*stated, "scale"), made.scale);
    made.turn = number_of(member(*stated, "rotation"), 0);
    return made;
}

/// The mark between a name and a number that has been added to it.
constexpr char mark = '\x1f';

void add_number(Json& part, std::size_t number) {
    const Json* const known = member(part, "name");
    const std::string name = known && known->is_string() ? known->get<std::string>() : "";
    part["name"] = name + mark + std::to_string(number);
}

/// Bytes in base64, up to the first character that is none of it.
std::string from_base64(std::string_view text) {
    constexpr std::string_view digits =
        "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string bytes;
    unsigned group = 0, bits = 0;
    for (const char c : text) {
        const std::size_t digit = digits.find(c);
        if (digit == digits.npos) break;
        group = group << 6 | static_cast<unsigned>(digit);
        bits += 6;
        if (bits < 8) continue;
        bits -= 8;
        bytes += static_cast<char>(group >> bits & 255);
    }
    return bytes;
}

/// What a URI holds: a file beside the model, or bytes of its own.
ImportedFile file_of(const std::string& uri) {
    if (!uri.starts_with("data:")) return {uri, {}};
    const std::size_t comma = uri.find(',');
    return {{}, comma == uri.npos ? "" : from_base64(std::string_view(uri).substr(comma + 1))};
}

/// A file with its text as data.
struct Gltf {
    Json all;
    std::string_view behind;  ///< the chunks behind the text
    const BesideModel& beside;

    /// The bytes of a buffer; empty if there are none.
    std::string buffer(std::size_t number) const {
        const Json* const found = entry(all, "buffers", number);
        const Json* const uri = found ? member(*found, "uri") : nullptr;
        if (uri && uri->is_string()) {
            ImportedFile file = file_of(uri->get<std::string>());
            if (!file.file.empty() && !beside.read(beside.context, file.file, file.bytes))
                return {};
            return std::move(file.bytes);
        }
        return behind.size() > chunk_head ? std::string(behind.substr(chunk_head)) : "";
    }

    /// The bytes of a view of a buffer; empty if there are none.
    std::string view(std::size_t number) const {
        const Json* const found = entry(all, "bufferViews", number);
        if (!found) return {};
        const std::string bytes = buffer(index_of(*found, "buffer").value_or(0));
        const std::size_t begin = index_of(*found, "byteOffset").value_or(0);
        if (begin > bytes.size()) return {};
        return bytes.substr(begin, index_of(*found, "byteLength").value_or(0));
    }

    /// The file of a profile of lights; nothing if there is no such profile.
    std::optional<ImportedFile> profile(std::size_t number) const {
        const Json* const lights = extension(all, web_name);
        const Json* const found = lights ? entry(*lights, "lights", number) : nullptr;
        const Json* const uri = found ? member(*found, "uri") : nullptr;
        if (uri && uri->is_string()) return file_of(uri->get<std::string>());
        const auto place = found ? index_of(*found, "bufferView") : std::nullopt;
        return place ? std::optional(ImportedFile{{}, view(*place)}) : std::nullopt;
    }
};

/// Takes the measured lights of nodes, whose names get numbers.
void take_webs(Gltf& file, GltfExtensions& made) {
    if (!file.all.contains("nodes") || !file.all["nodes"].is_array()) return;
    std::map<std::size_t, int> known;
    Json& nodes = file.all["nodes"];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const Json* const stated = extension(nodes[i], web_name);
        const auto number = stated ? index_of(*stated, "light") : std::nullopt;
        if (!number) continue;
        if (!known.contains(*number)) {
            auto profile = file.profile(*number);
            if (!profile) continue;
            known[*number] = static_cast<int>(made.profiles.size());
            made.profiles.push_back(std::move(*profile));
        }
        ImportedLight light;
        light.kind = ImportedLight::measured;
        light.profile = known[*number];
        const double factor = std::max(number_of(member(*stated, "multiplier"), 1), 0.0);
        light.colour = numbers_of<3>(member(*stated, "color"), {1, 1, 1});
        for (double& channel : light.colour) channel = std::max(channel, 0.0) * factor;
        made.lights[static_cast<int>(i)] = light;
        add_number(nodes[i], i);
    }
}

/// Takes the cameras of nodes, whose names get numbers.
void take_cameras(Gltf& file, GltfExtensions& made) {
    if (!file.all.contains("nodes") || !file.all["nodes"].is_array()) return;
    Json& nodes = file.all["nodes"];
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const auto number = index_of(nodes[i], "camera");
        const Json* const stated = number ? entry(file.all, "cameras", *number) : nullptr;
        if (!stated) continue;
        ImportedCamera camera;
        const Json* const name = member(*stated, "name");
        if (name && name->is_string()) camera.name = name->get<std::string>();
        if (const Json* const view = member(*stated, "perspective")) {
            constexpr double usual = 0.8, widest = 3.1;
            const double angle = std::clamp(number_of(member(*view, "yfov"), usual), 0.0, widest);
            const auto [sine, cosine] = math::sin_cos(angle / 2);
            camera.height = 2 * sine / cosine;
        } else if (const Json* const size = member(*stated, "orthographic")) {
            camera.parallel = true;
            camera.height = 2 * std::abs(number_of(member(*size, "ymag"), 1));
        }
        made.cameras[static_cast<int>(i)] = std::move(camera);
        if (!made.lights.contains(static_cast<int>(i))) add_number(nodes[i], i);
    }
}

/// A binary file with another text.
std::string with_text(std::string_view bytes, std::string_view behind, std::string text) {
    text.append((4 - text.size() % 4) % 4, ' ');
    std::string made(bytes.substr(0, heads));
    made += text;
    made += behind;
    put_number(made, 8, made.size());
    put_number(made, file_head, text.size());
    return made;
}

}  // namespace

std::array<float, 2> PictureMove::moved(const std::array<float, 2>& uv) const {
    const double u = scale[0] * uv[0], v = scale[1] * (1.0 - uv[1]);
    const auto [sine, cosine] = math::sin_cos(turn);
    return {static_cast<float>(cosine * u + sine * v + offset[0]),
            static_cast<float>(1 - (cosine * v - sine * u + offset[1]))};
}

GltfExtensions read_extensions(std::string_view bytes, const BesideModel& beside) {
    GltfExtensions made;
    const bool binary = is_binary(bytes);
    const std::string_view text = binary ? bytes.substr(heads, number_at(bytes, file_head)) : bytes;
    const auto has = [&](std::string_view name) { return text.find(name) != text.npos; };
    if (!has(strength_name) && !has(move_name) && !has(web_name) && !has(cameras_name)) return made;
    Gltf file{Json::parse(text, nullptr, false),
              binary ? bytes.substr(heads + text.size()) : std::string_view(), beside};
    if (!file.all.is_object()) return made;
    if (file.all.contains("materials") && file.all["materials"].is_array()) {
        Json& materials = file.all["materials"];
        for (std::size_t i = 0; i < materials.size(); ++i) {
            strengthen(materials[i]);
            const auto move = move_of(materials[i]);
            if (!move) continue;
            made.moves[static_cast<int>(i)] = *move;
            add_number(materials[i], i);
        }
    }
    take_webs(file, made);
    take_cameras(file, made);
    std::string changed = file.all.dump(-1, ' ', false, Json::error_handler_t::replace);
    made.file = binary ? with_text(bytes, file.behind, std::move(changed)) : std::move(changed);
    return made;
}

int take_number(std::string& name) {
    const std::size_t at = name.rfind(mark);
    if (at == name.npos) return -1;
    int number = -1;
    std::from_chars(name.data() + at + 1, name.data() + name.size(), number);
    name.erase(at);
    return number;
}

}  // namespace candelabra

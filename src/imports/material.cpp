// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/material.h"

#include <assimp/GltfMaterial.h>
#include <assimp/material.h>

#include <algorithm>
#include <cstring>
#include <initializer_list>
#include <optional>
#include <utility>

namespace candelabra {

namespace {

std::optional<double> number(const aiMaterial& material, const char* key, unsigned type,
                             unsigned index) {
    ai_real value = 0;
    if (material.Get(key, type, index, value) != aiReturn_SUCCESS) return std::nullopt;
    return static_cast<double>(value);
}

std::optional<aiColor4D> colour(const aiMaterial& material, const char* key, unsigned type,
                                unsigned index) {
    aiColor4D value(0, 0, 0, 1);
    if (material.Get(key, type, index, value) != aiReturn_SUCCESS) return std::nullopt;
    return value;
}

std::array<double, 3> rgb(const aiColor4D& colour) { return {colour.r, colour.g, colour.b}; }

/// Adds a picture to the model unless it has it already. Returns its number.
int add(ImportedFile picture, ImportedModel& model) {
    const auto same = [&](const ImportedFile& other) {
        return other.file == picture.file && other.bytes == picture.bytes;
    };
    const auto found = std::ranges::find_if(model.pictures, same);
    const auto place = static_cast<int>(found - model.pictures.begin());
    if (found == model.pictures.end()) model.pictures.push_back(std::move(picture));
    return place;
}

/// The number of the first picture of these types; below 0: there is none.
int picture(const aiScene& scene, const aiMaterial& material,
            std::initializer_list<aiTextureType> types, ImportedModel& model) {
    for (const aiTextureType type : types) {
        aiString name;
        if (material.GetTexture(type, 0, &name) != aiReturn_SUCCESS || name.length == 0) continue;
        const aiTexture* const embedded = scene.GetEmbeddedTexture(name.C_Str());
        if (!embedded) return add({name.C_Str(), {}}, model);
        // A height of 0 means that the width counts the bytes of a picture file.
        if (embedded->mHeight == 0 && embedded->pcData)
            return add(
                {{},
                 std::string(reinterpret_cast<const char*>(embedded->pcData), embedded->mWidth)},
                model);
    }
    return -1;
}

/// Reads what physically based materials state.
void read_facets(const aiMaterial& material, ImportedMaterial& made) {
    const auto metallic = number(material, AI_MATKEY_METALLIC_FACTOR);
    const auto roughness = number(material, AI_MATKEY_ROUGHNESS_FACTOR);
    // Assimp makes a roughness of the highlights of FBX files, which may be below 0.
    const bool made_up = number(material, "$raw.Shininess", 0, 0).has_value();
    made.facets = metallic || (roughness && !made_up);
    made.metallic = metallic.value_or(0);
    made.roughness = roughness.value_or(1);
    made.transmission = number(material, AI_MATKEY_TRANSMISSION_FACTOR).value_or(0);
}

/// Reads the highlight of materials by Phong and Blinn. Others have numbers of it without use.
void read_highlight(const aiMaterial& material, ImportedMaterial& made) {
    int model = 0;
    if (material.Get(AI_MATKEY_SHADING_MODEL, model) != aiReturn_SUCCESS ||
        (model != aiShadingMode_Phong && model != aiShadingMode_Blinn &&
         model != aiShadingMode_CookTorrance))
        return;
    const auto light = colour(material, AI_MATKEY_COLOR_SPECULAR);
    const double strength = number(material, AI_MATKEY_SHININESS_STRENGTH).value_or(1);
    made.shininess = number(material, AI_MATKEY_SHININESS).value_or(0);
    if (light) made.specular = strength * (light->r + light->g + light->b) / 3;
}

}  // namespace

ImportedMaterial imported_material(const aiScene& scene, const aiMaterial& material,
                                   ImportedModel& model) {
    ImportedMaterial made;
    made.name = material.GetName().C_Str();
    read_facets(material, made);
    if (!made.facets) read_highlight(material, made);
    const auto base = colour(material, AI_MATKEY_BASE_COLOR);
    const auto diffuse = base ? base : colour(material, AI_MATKEY_COLOR_DIFFUSE);
    if (diffuse) made.colour = rgb(*diffuse);
    made.opacity = number(material, AI_MATKEY_OPACITY).value_or(1);
    if (base) made.opacity = base->a;
    aiString mode;
    if (material.Get(AI_MATKEY_GLTF_ALPHAMODE, mode) == aiReturn_SUCCESS) {
        made.uses_alpha = std::strcmp(mode.C_Str(), "OPAQUE") != 0;
        if (!made.uses_alpha) made.opacity = 1;
        constexpr double usual_cutoff = 0.5;
        if (std::strcmp(mode.C_Str(), "MASK") == 0)
            made.cutoff = std::max(
                number(material, AI_MATKEY_GLTF_ALPHACUTOFF).value_or(usual_cutoff), 0.0);
    }
    if (const auto light = colour(material, AI_MATKEY_COLOR_EMISSIVE)) made.emission = rgb(*light);
    const double strength = number(material, AI_MATKEY_EMISSIVE_INTENSITY).value_or(1);
    for (double& channel : made.emission) channel *= strength;
    made.ior = number(material, AI_MATKEY_REFRACTI).value_or(0);
    made.picture =
        picture(scene, material, {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE}, model);
    made.emission_picture =
        picture(scene, material, {aiTextureType_EMISSION_COLOR, aiTextureType_EMISSIVE}, model);
    if (made.facets)
        made.facet_picture =
            picture(scene, material, {aiTextureType_METALNESS, aiTextureType_UNKNOWN}, model);
    made.normal_picture =
        picture(scene, material, {aiTextureType_NORMALS, aiTextureType_NORMAL_CAMERA}, model);
    made.normal_scale =
        number(material, AI_MATKEY_GLTF_TEXTURE_SCALE(aiTextureType_NORMALS, 0)).value_or(1);
    for (const aiTextureType bumps : {aiTextureType_HEIGHT, aiTextureType_DISPLACEMENT})
        made.heights |= material.GetTextureCount(bumps) > 0;
    return made;
}

unsigned uv_set(const aiMaterial& material) {
    for (const aiTextureType type : {aiTextureType_BASE_COLOR, aiTextureType_DIFFUSE,
                                     aiTextureType_EMISSIVE, aiTextureType_NORMALS}) {
        int set = 0;
        if (material.Get(AI_MATKEY_UVWSRC(type, 0), set) == aiReturn_SUCCESS && set >= 0)
            return static_cast<unsigned>(set);
    }
    return 0;
}

}  // namespace candelabra

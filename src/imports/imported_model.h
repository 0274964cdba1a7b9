// SPDX-License-Identifier: GPL-3.0-or-later
// Models with their parts and materials, as files of glTF, OBJ, FBX, Collada and 3MF have them, in
// plain lists. They are read by Assimp, whose library takes long to load. So this module is a
// library that is opened when a scene first has such a model. Numbers are those of the file: in a
// right-handed space with y up, in the file's units.
#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace candelabra {

/// A picture that a material shows, or what a light has been measured as: a file beside the model,
/// or the bytes of one in the model.
struct ImportedFile {
    std::string file;   ///< as the model spells it; empty: embedded
    std::string bytes;  ///< empty: not embedded
};

struct ImportedMaterial {
    std::string name;
    bool stated = true;  ///< false: only its name is known, as a file beside the model is missing
    std::array<double, 3> colour{1, 1, 1};    ///< linear; multiplied with the picture
    std::array<double, 3> emission{0, 0, 0};  ///< linear, with its strength
    double opacity = 1;
    double transmission = 0;  ///< fraction of light that goes through, tinted by the colour
    double ior = 0;           ///< 0: the file states none
    bool facets = false;      ///< metallic and roughness are stated
    double metallic = 0, roughness = 1;
    double specular = 0, shininess = 0;  ///< of Blinn's highlight
    bool uses_alpha = true;              ///< the alpha of the picture counts
    double cutoff = -1;                  ///< alpha is 0 below it and 1 above; below 0: it stays
    int picture = -1;                    ///< of the colour; below 0: none
    int emission_picture = -1;
    int facet_picture = -1;  ///< green is a factor of roughness, blue one of metallic
    int normal_picture = -1;  ///< of normals in tangent space, with green upwards
    double normal_scale = 1;  ///< factor of their slope
    bool heights = false;     ///< has a map of heights
};

struct ImportedMesh {
    std::vector<std::array<float, 3>> points;
    std::vector<std::array<float, 3>> normals;  ///< one for each point, or none
    std::vector<std::array<float, 2>> uvs;      ///< one for each point, or none; v upwards
    std::vector<std::array<int, 3>> faces;
    int material = -1;      ///< below 0: none
    bool coloured = false;  ///< points have colours
};

/// A light source of KHR_lights_punctual or EXT_lights_ies. It shines along -z of its node.
struct ImportedLight {
    enum Kind : int { point, spot, sun, measured };
    int kind = point;
    /// In candela, or lux of a sun, with its strength. Of a measured light: a factor.
    std::array<double, 3> colour{0, 0, 0};
    int profile = -1;                       ///< of a measured light
    double inner = 0, outer = 0;            ///< of a spot: angles to its axis, in radians
};

/// A camera, in the space of its node.
struct ImportedCamera {
    std::string name;  ///< empty: it has only that of its node
    std::array<double, 3> location{0, 0, 0}, direction{0, 0, -1}, up{0, 1, 0};
    bool parallel = false;
    /// Of the picture, at the distance 1 if rays are not parallel; 0: as wide or high as pixels are
    /// square.
    double width = 0, height = 0;
};

/// A part of the hierarchy. Parents come before their children.
struct ImportedNode {
    std::string name;
    int parent = -1;                     ///< below 0: it is the root
    std::array<double, 12> transform{};  ///< three rows of a matrix for column vectors
    std::vector<int> meshes;
    int light = -1;   ///< below 0: none
    int camera = -1;  ///< below 0: none
};

struct ImportedModel {
    std::vector<ImportedNode> nodes;
    std::vector<ImportedMesh> meshes;
    std::vector<ImportedMaterial> materials;
    std::vector<ImportedFile> pictures;
    std::vector<ImportedLight> lights;
    std::vector<ImportedFile> profiles;  ///< what lights have been measured as
    std::vector<ImportedCamera> cameras;
    int lights_left_out = 0;  ///< lights in a format that states no units
    bool animated = false;
    bool encoded = false;  ///< colours of materials are sRGB and not linear
};

/// Reads a file that the model names; returns whether there is one. `bytes` gets its contents.
struct BesideModel {
    bool (*read)(void* context, std::string_view name, std::string& bytes);
    void* context;
};

/// The entry point. The extension of the name decides the format. Returns an error, or, with a
/// complete result, an empty string. Indices in the result may be wrong, as the file may lie.
struct Imports {
    std::string (*read)(std::string_view name, std::string_view bytes, const BesideModel&,
                        ImportedModel&);
};

/// The name of the library, and of its one function: `const Imports* candelabra_imports()`.
inline constexpr auto imports_library = "libcandelabra_imports.so";
inline constexpr auto imports_function = "candelabra_imports";

}  // namespace candelabra

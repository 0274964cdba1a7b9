// SPDX-License-Identifier: GPL-3.0-or-later
#include "imports/importer.h"

#include "base/degrees.h"
#include "base/elementary.h"
#include "imports/collada_cameras.h"
#include "imports/gltf_extensions.h"
#include "imports/guarded_files.h"
#include "imports/material.h"

#include <assimp/BaseImporter.h>
#include <assimp/camera.h>
#include <assimp/config.h>
#include <assimp/importerdesc.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <assimp/Importer.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace candelabra {

namespace {

/// Whether the space-separated list of extensions has this one.
bool lists(std::string_view list, std::string_view extension) {
    while (!list.empty()) {
        const std::size_t end = std::min(list.find(' '), list.size());
        if (list.substr(0, end) == extension) return true;
        list.remove_prefix(std::min(end + 1, list.size()));
    }
    return false;
}

std::string extension_of(std::string_view name) {
    std::string extension(name.substr(std::min(name.rfind('.'), name.size() - 1) + 1));
    for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return extension;
}

/// Leaves only the readers of this extension, so that no content of a file reaches another one.
void keep_readers(Assimp::Importer& importer, std::string_view extension) {
    for (std::size_t i = importer.GetImporterCount(); i-- > 0;) {
        const aiImporterDesc* const about = importer.GetImporterInfo(i);
        if (about && lists(about->mFileExtensions, extension)) continue;
        Assimp::BaseImporter* const other = importer.GetImporter(i);
        importer.UnregisterLoader(other);
        delete other;
    }
}

/// Whether the material is the one that Assimp gives meshes without one.
bool is_default(const ImportedMaterial& material) {
    const ImportedMaterial usual;
    return material.name == AI_DEFAULT_MATERIAL_NAME ||
           (material.name.empty() && material.facets && material.metallic == 1 &&
            material.roughness == 1 && material.colour == usual.colour && material.opacity == 1 &&
            material.cutoff < 0 && material.emission == usual.emission && material.picture < 0 &&
            material.facet_picture < 0 && material.emission_picture < 0);
}

ImportedMesh imported_mesh(const aiMesh& from, unsigned uv) {
    ImportedMesh made;
    made.points.reserve(from.mNumVertices);
    for (unsigned i = 0; i < from.mNumVertices; ++i)
        made.points.push_back({from.mVertices[i].x, from.mVertices[i].y, from.mVertices[i].z});
    if (from.HasNormals()) {
        made.normals.reserve(from.mNumVertices);
        for (unsigned i = 0; i < from.mNumVertices; ++i)
            made.normals.push_back({from.mNormals[i].x, from.mNormals[i].y, from.mNormals[i].z});
    }
    if (!from.HasTextureCoords(uv)) uv = 0;
    if (from.HasTextureCoords(uv)) {
        made.uvs.reserve(from.mNumVertices);
        for (unsigned i = 0; i < from.mNumVertices; ++i)
            made.uvs.push_back({from.mTextureCoords[uv][i].x, from.mTextureCoords[uv][i].y});
    }
    made.faces.reserve(from.mNumFaces);
    for (unsigned i = 0; i < from.mNumFaces; ++i) {
        const aiFace& face = from.mFaces[i];
        if (face.mNumIndices != 3) continue;
        made.faces.push_back({static_cast<int>(face.mIndices[0]),
                              static_cast<int>(face.mIndices[1]),
                              static_cast<int>(face.mIndices[2])});
    }
    made.coloured = from.HasVertexColors(0);
    return made;
}

std::array<double, 3> numbers(const aiVector3D& v) { return {v.x, v.y, v.z}; }

/// Whether Assimp gives half of the angles of cameras in FBX files, as its description says, and
/// turns what has z up. Versions before 5.3 give the whole angle and do not turn.
bool settles_fbx() {
    return std::pair(aiGetVersionMajor(), aiGetVersionMinor()) >= std::pair(5U, 3U);
}

/// `edges`: the angle from the left edge to the right, by that of Assimp. Aspects below 0 are those
/// of with_told_cameras().
ImportedCamera imported_camera(const aiCamera& from, double edges) {
    ImportedCamera made;
    made.location = numbers(from.mPosition);
    made.direction = numbers(from.mLookAt);
    made.up = numbers(from.mUp);
    constexpr double widest = 3.1;
    const double stated = edges * from.mHorizontalFOV;
    double aspect = from.mAspect;
    made.parallel = aspect < 0;
    if (made.parallel) {
        made.width = 2 * std::abs(stated) / radians_per_degree;
        aspect = aspect == parallel_without_aspect ? 0 : -aspect;
    } else {
        const auto [sine, cosine] = math::sin_cos(std::clamp(stated, 0.0, widest) / 2);
        made.width = 2 * sine / cosine;
    }
    if (!(aspect > 0)) return made;
    made.height = made.width / aspect;
    made.width = 0;
    return made;
}

/// Whether the file states that z is up, and Assimp has not turned it. Only FBX files do; those of
/// Collada have been turned.
bool has_z_up(const aiScene& scene) {
    constexpr std::int32_t z = 2;
    std::int32_t axis = 1;
    return !settles_fbx() && scene.mMetaData && scene.mMetaData->Get("UpAxis", axis) && axis == z;
}

/// Removes what Assimp puts before the names of materials of 3MF, which is the number of their
/// list: "id1_Paint".
void settle_name(ImportedMaterial& material) {
    std::string_view name = material.name;
    if (!name.starts_with("id")) return;
    const std::size_t end = name.find_first_not_of("0123456789", 2);
    if (end != name.npos && end > 2 && name[end] == '_') material.name.erase(0, end + 1);
}

/// Converts a scene that Assimp has read.
class Converter {
public:
    Converter(const aiScene& scene, const GltfExtensions& extensions, ImportedModel& model)
        : scene_(scene), extensions_(extensions), model_(model) {}

    void take_materials() {
        for (unsigned i = 0; i < scene_.mNumMaterials; ++i)
            take_material(imported_material(scene_, *scene_.mMaterials[i], model_));
    }

    void take_meshes() {
        for (unsigned i = 0; i < scene_.mNumMeshes; ++i) {
            // It is done with then, and its memory is used again.
            const std::unique_ptr<aiMesh> mesh(std::exchange(scene_.mMeshes[i], nullptr));
            const aiMesh& from = *mesh;
            const bool has_material = from.mMaterialIndex < scene_.mNumMaterials;
            const aiMaterial* const material =
                has_material ? scene_.mMaterials[from.mMaterialIndex] : nullptr;
            ImportedMesh& made =
                model_.meshes.emplace_back(imported_mesh(from, material ? uv_set(*material) : 0));
            if (!material) continue;
            if (!is_default(model_.materials[from.mMaterialIndex]))
                made.material = static_cast<int>(from.mMaterialIndex);
            const auto move = extensions_.moves.find(numbers_[from.mMaterialIndex]);
            if (move == extensions_.moves.end()) continue;
            for (auto& uv : made.uvs) uv = move->second.moved(uv);
        }
    }

    /// `units` tells whether the format states the units of lights.
    void take_lights(bool units) {
        for (unsigned i = 0; i < scene_.mNumLights; ++i) {
            const aiLight& from = *scene_.mLights[i];
            const bool known = from.mType == aiLightSource_POINT ||
                               from.mType == aiLightSource_SPOT ||
                               from.mType == aiLightSource_DIRECTIONAL;
            if (!units || !known) {
                ++model_.lights_left_out;
                continue;
            }
            ImportedLight light;
            light.kind = from.mType == aiLightSource_POINT  ? ImportedLight::point
                         : from.mType == aiLightSource_SPOT ? ImportedLight::spot
                                                            : ImportedLight::sun;
            const aiColor3D& c = from.mColorDiffuse;
            light.colour = {c.r, c.g, c.b};
            light.inner = from.mAngleInnerCone;
            light.outer = from.mAngleOuterCone;
            lights_[from.mName.C_Str()] = static_cast<int>(model_.lights.size());
            model_.lights.push_back(light);
        }
    }

    /// Those of formats in which Assimp finds the node of each. `edges`: see imported_camera().
    void take_cameras(double edges) {
        for (unsigned i = 0; i < scene_.mNumCameras; ++i) {
            cameras_[scene_.mCameras[i]->mName.C_Str()] = static_cast<int>(model_.cameras.size());
            model_.cameras.push_back(imported_camera(*scene_.mCameras[i], edges));
        }
    }

    /// `z_up` tells whether the file has z up, which is turned to y.
    void take_nodes(bool z_up) {
        if (!scene_.mRootNode) return;
        struct Step {
            const aiNode* node;
            int parent;
        };
        std::vector<Step> open{{scene_.mRootNode, -1}};
        model_.nodes.reserve(count_of(*scene_.mRootNode));
        while (!open.empty()) {
            const auto [from, parent] = open.back();
            open.pop_back();
            const auto number = static_cast<int>(model_.nodes.size());
            model_.nodes.push_back(imported_node(*from, parent));
            const int number_in_file = take_number(model_.nodes.back().name);
            add_camera(number_in_file);
            add_measured(number_in_file, number);
            for (unsigned i = from->mNumChildren; i > 0; --i)
                open.push_back({from->mChildren[i - 1], number});
        }
        if (!z_up) return;
        std::array<double, 12>& t = model_.nodes.front().transform;
        for (std::size_t i = 4; i < 8; ++i) {
            std::swap(t[i], t[i + 4]);
            t[i + 4] = -t[i + 4];
        }
    }

private:
    void take_material(ImportedMaterial material) {
        numbers_.push_back(take_number(material.name));
        model_.materials.push_back(std::move(material));
    }

    /// Adds the camera of a node of a glTF file, if it has one, to the last node.
    void add_camera(int number_in_file) {
        const auto found = extensions_.cameras.find(number_in_file);
        if (found == extensions_.cameras.end()) return;
        model_.nodes.back().camera = static_cast<int>(model_.cameras.size());
        model_.cameras.push_back(found->second);
    }

    /// Adds the measured light of a node of the file, if it has one, as a node in it.
    void add_measured(int number_in_file, int parent) {
        const auto found = extensions_.lights.find(number_in_file);
        if (found == extensions_.lights.end()) return;
        ImportedNode& made = model_.nodes.emplace_back();
        made.parent = parent;
        made.transform = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
        made.light = static_cast<int>(model_.lights.size());
        model_.lights.push_back(found->second);
    }

    /// The number of nodes from this one on.
    static std::size_t count_of(const aiNode& first) {
        std::vector<const aiNode*> all{&first};
        for (std::size_t i = 0; i < all.size(); ++i) {
            const aiNode& node = *all[i];
            all.insert(all.end(), node.mChildren, node.mChildren + node.mNumChildren);
        }
        return all.size();
    }

    ImportedNode imported_node(const aiNode& from, int parent) {
        ImportedNode made;
        made.name = from.mName.C_Str();
        made.parent = parent;
        const aiMatrix4x4& m = from.mTransformation;
        made.transform = {m.a1, m.a2, m.a3, m.a4, m.b1, m.b2, m.b3, m.b4, m.c1, m.c2, m.c3, m.c4};
        for (unsigned i = 0; i < from.mNumMeshes; ++i)
            made.meshes.push_back(static_cast<int>(from.mMeshes[i]));
        const auto light = lights_.find(made.name);
        if (light != lights_.end()) made.light = light->second;
        const auto camera = cameras_.find(made.name);
        if (camera != cameras_.end()) made.camera = camera->second;
        return made;
    }

    const aiScene& scene_;
    const GltfExtensions& extensions_;
    ImportedModel& model_;
    std::vector<int> numbers_;                        ///< of materials in the file
    std::map<std::string, int, std::less<>> lights_;  ///< by the name of their node
    std::map<std::string, int, std::less<>> cameras_;  ///< by the name of their node
};

}  // namespace

std::string import_model(std::string_view name, std::string_view bytes, const BesideModel& beside,
                         ImportedModel& model) {
    const std::string extension = extension_of(name);
    const bool gltf = extension == "gltf" || extension == "glb";
    Assimp::Importer importer;
    keep_readers(importer, extension);
    const std::string own_name(name.substr(name.rfind('/') + 1));
    GltfExtensions extensions;
    if (gltf) extensions = read_extensions(bytes, beside);
    if (extension == "dae") extensions.file = with_told_cameras(bytes);
    if (extensions.file) bytes = *extensions.file;
    auto* const files = new GuardedFiles(own_name, bytes, beside);
    importer.SetIOHandler(files);  // which owns it from now on
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    // Parts of Collada have the names that people see, where they have one.
    importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_USE_COLLADA_NAMES, true);
    unsigned steps = aiProcess_Triangulate | aiProcess_SortByPType;
    // Other formats have each corner of each face as a point of its own.
    if (!gltf) steps |= aiProcess_JoinIdenticalVertices;
    const aiScene* const scene = importer.ReadFile(own_name, steps);
    if (!scene) {
        const std::string problem = importer.GetErrorString();
        return problem.empty() ? "it is damaged" : problem;
    }
    Converter converter(*scene, extensions, model);
    converter.take_materials();
    converter.take_meshes();
    converter.take_lights(gltf);
    if (!gltf) converter.take_cameras(extension == "fbx" && settles_fbx() ? 2 : 1);
    converter.take_nodes(extension == "3mf" || has_z_up(*scene));
    model.encoded = extension == "3mf";
    if (model.encoded) std::ranges::for_each(model.materials, settle_name);
    // Materials of OBJ files are in files of their own.
    if (extension == "obj" && files->misses())
        for (ImportedMaterial& material : model.materials) material.stated = false;
    model.profiles = std::move(extensions.profiles);
    model.animated = scene->mNumAnimations > 0;
    return {};
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// State that the readers of a scene share while one file is evaluated: the evaluator, the defaults
// in force, and caches of results and warnings. Made by evaluate(), passed to every reader.
#pragma once

#include "base/pool.h"
#include "imports/imported_model.h"
#include "interpret/evaluator.h"
#include "picture/read.h"
#include "reading/block_table.h"
#include "reading/constants.h"
#include "reading/memo.h"
#include "reading/shape_plans.h"
#include "reading/texture_store.h"
#include "reading/value_kinds.h"
#include "scene/scene.h"

#include <map>
#include <memory>
#include <set>
#include <string>

namespace candelabra {

struct ImportedContent;  // of objects/, which alone reads models

/// Pictures and light profiles of a model, in its order.
struct ModelFiles {
    std::vector<ImportedFile> pictures, profiles;
};

/// A camera as a value of the language.
struct DeclaredCamera {
    Camera camera;
    Bump normal;  ///< perturbs the directions of its rays
    FilmSettings film;
    Handle<Pigment> bokeh;  ///< the opening of its lens as a picture; null: none
};

/// A material as a value of the language.
struct DeclaredMaterial {
    Handle<Texture> texture;           ///< null: none
    Handle<Texture> interior_texture;  ///< null: as outside
    Handle<Interior> interior;         ///< null: none
};

struct Binder {
    Evaluator& evaluator;
    const BlockTable& blocks;
    Handle<Texture> default_texture = make_handle<Texture>();
    DeclaredCamera default_camera = {};
    TextureStore textures = {};
    // Allocators of the most frequent parts of scenes.
    Pool<Object> pool = {};
    Pool<Texture> texture_pool = {};
    Pool<Transform> transform_pool = {};
    ShapePlans plans = {};
    Constants constants = {};
    Memo<Transform> moves = {};      ///< each transformation by itself
    Memo<Transform> movements = {};  ///< composed with the preceding ones
    Memo<Texture> appearances = {};
    Memo<Texture> moved_appearances = {};
    Memo<Interior> interiors = {};
    Memo<Texture, Object> objects = {};  ///< the base is the default texture
    /// Words without effect that have been reported.
    std::set<std::string, std::less<>> warned = {};
    /// Pictures that have been read, by file and coding.
    std::map<std::pair<std::string, TexelCoding>, Handle<Texels>> pictures = {};
    /// Webs of photometric files, by file and set of lamps.
    std::map<std::pair<std::string, int>, LoadedWeb> webs = {};
    /// Tables of the reflection of roads, by file.
    std::map<std::string, Handle<RoadTable>, std::less<>> road_tables = {};
    /// Models that have been read, by folder and name.
    std::map<std::pair<std::string, std::string>, std::shared_ptr<ImportedContent>> models = {};
    /// Pictures and light profiles of these models, by path.
    std::map<std::string, std::shared_ptr<const ModelFiles>> model_files = {};
    /// Contents of font files, by folder and name.
    std::map<std::pair<std::string, std::string>, std::string> fonts = {};
    /// The value of `assumed_gamma`, once the scene has given it.
    std::optional<double> working_gamma = {};
    std::size_t nesting = 0;  ///< number of objects around the current one
};

}  // namespace candelabra

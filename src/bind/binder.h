// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of a scene share while one file is evaluated: the evaluator, the defaults that
// are in force, and what has been made or said once already. Made by evaluate(), passed to every
// reader.
#pragma once

#include "base/pool.h"
#include "bind/constants.h"
#include "bind/memo.h"
#include "bind/shape_plans.h"
#include "bind/texture_store.h"
#include "bind/value_kinds.h"
#include "interpret/evaluator.h"
#include "picture/read.h"
#include "scene/scene.h"

#include <map>
#include <set>
#include <string>

namespace candelabra {

/// A camera as a value of the language.
struct DeclaredCamera {
    Camera camera;
    Bump normal;  ///< disturbs the directions of its rays
    FilmSettings film;
};

/// A material as a value of the language.
struct DeclaredMaterial {
    Handle<Texture> texture;           ///< null: none
    Handle<Texture> interior_texture;  ///< null: as outside
    Handle<Interior> interior;         ///< null: none
};

struct Binder {
    Evaluator& evaluator;
    Handle<Texture> default_texture = make_handle<Texture>();
    DeclaredCamera default_camera = {};
    TextureStore textures = {};
    // Where what scenes hold most of is made.
    Pool<Object> pool = {};
    Pool<Texture> texture_pool = {};
    Pool<Transform> transform_pool = {};
    ShapePlans plans = {};
    Constants constants = {};
    Memo<Transform> moves = {};      ///< each by itself
    Memo<Transform> movements = {};  ///< with those before it
    Memo<Texture> appearances = {};
    Memo<Texture> moved_appearances = {};
    Memo<Interior> interiors = {};
    Memo<Texture, Object> objects = {};  ///< the base is the default texture
    /// Words that have no effect, and have been reported.
    std::set<std::string, std::less<>> warned = {};
    /// What has been read already, by file and coding.
    std::map<std::pair<std::string, TexelCoding>, Handle<Texels>> pictures = {};
    /// The files of fonts, by folder and name.
    std::map<std::pair<std::string, std::string>, std::string> fonts = {};
    /// `assumed_gamma`, once the scene has said it.
    std::optional<double> working_gamma = {};
    std::size_t nesting = 0;  ///< objects around the one that is read
};

}  // namespace candelabra

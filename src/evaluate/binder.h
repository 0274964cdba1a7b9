// SPDX-License-Identifier: GPL-3.0-or-later
// What the readers of a scene share while one file is evaluated: the evaluator, the defaults that
// are in force, and what has been made or said once already. Made by evaluate(), passed to every
// reader.
#pragma once

#include "evaluate/evaluator.h"
#include "evaluate/texture_store.h"
#include "scene/scene.h"

#include <set>
#include <string>

/// A camera as a value of the language.
struct DeclaredCamera {
    Camera camera;
};

struct Binder {
    Evaluator& evaluator;
    Handle<Texture> default_texture = make_handle<Texture>();
    Camera default_camera = {};
    TextureStore textures = {};
    std::set<std::string, std::less<>> warned =
        {};           ///< words that have no effect, and have been told of
    int nesting = 0;  ///< objects around the one that is read
};

// SPDX-License-Identifier: GPL-3.0-or-later
// A Scene as text: what the evaluator made of a file, with all loops, macros and declarations gone.
// The text depends on the scene only and is a scene itself, which gives the same picture. For
// --dump scene and golden tests.
#pragma once

#include "scene/scene.h"

#include <span>
#include <string>
#include <string_view>

namespace candelabra {

/// What has its default value is left out. Objects that occur more than once, or lie deep, are
/// declared first as Object_1, ...
std::string dump(const Scene&);

/// The film as a block of a camera; empty when there is none.
std::string film_text(const FilmSettings&);

/// A block of a scene that makes no object, as text: its line, or several; empty when the scene has
/// the default.
struct SceneText {
    std::string_view word;
    std::string (*text)(const Scene&);
};
/// In the order of the text.
std::span<const SceneText> scene_texts();

}  // namespace candelabra

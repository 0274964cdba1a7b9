// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a Scene as text: the result of evaluation, without loops, macros and declarations. The
// text depends on the scene only and is itself a scene, which gives the same picture. For --dump
// scene and golden tests.
#pragma once

#include "scene/scene.h"

#include <memory>
#include <span>
#include <string>
#include <string_view>

namespace candelabra {

class FunctionTexts;

/// Keeps how functions are written, which dump() needs. To exist from the evaluation of the scene
/// until its dump; see FunctionTexts.
class WrittenFunctions {
public:
    WrittenFunctions();
    ~WrittenFunctions();

private:
    std::unique_ptr<FunctionTexts> texts_;
};

/// Omits default values. Objects that occur more than once or lie deep are declared first as
/// Object_1, ...
std::string dump(const Scene&);

/// Writes the object with its contents in one line.
std::string in_one_line(const Object&);

/// The film as a block of a camera; empty if the film is off.
std::string film_text(const FilmSettings&);

/// Writes a block of a scene that does not make an object, in one or more lines; empty if the scene
/// has the default.
struct SceneText {
    std::string_view word;
    std::string (*text)(const Scene&);
};
/// In the order of the text.
std::span<const SceneText> scene_texts();

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// Objects: every shape, union, object, and light sources inside of them, with all that changes an
// object. Called for the elements of a scene, for #declare, and for objects in objects.
#pragma once

#include "bind/bind.h"

#include <algorithm>
#include <array>

/// Whether a block with this word makes one object of several.
inline bool combines_objects(NameId word) {
    return word == "union"_word || word == "intersection"_word || word == "difference"_word ||
           word == "merge"_word || word == "light_group"_word || word == "composite"_word;
}

/// Whether a block with this word makes an object.
inline bool makes_object(NameId word) {
    return Kinds<Shape>::find(word) != Kinds<Shape>::count || combines_objects(word) ||
           word == "object"_word || word == "light_source"_word;
}

/// Whether the word is nothing without what follows in braces.
inline bool takes_braces(NameId word) {
    constexpr auto others = std::array{
        "texture"_word,        "pigment"_word,    "normal"_word,           "finish"_word,
        "interior"_word,       "material"_word,   "interior_texture"_word, "camera"_word,
        "color_map"_word,      "colour_map"_word, "light_source"_word,     "background"_word,
        "global_settings"_word};
    return makes_object(word) || std::ranges::find(others, word) != others.end();
}

/// The object of such a block, as a part: without a texture when the text gives none. Null after a
/// report.
ObjectHandle read_object(Binder&, const Element& block);

/// The same for one of several objects in a row: a sphere that is like the one before it is put to
/// the end of `list`, and there is nothing more to do with it (none is returned). Objects there
/// have this texture when they have none of their own.
std::optional<ObjectHandle> read_object_into(std::vector<ObjectHandle>& list,
                                             const Handle<Texture>& texture, Binder&,
                                             const Element& block);

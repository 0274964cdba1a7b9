// SPDX-License-Identifier: GPL-3.0-or-later
// Reads objects: every shape, union, object, and nested light source, with all object modifiers.
// Called for the elements of a scene, for #declare, and for objects in objects.
#pragma once

#include "reading/item_reader.h"

namespace candelabra {

/// Reads a block that makes an object, as a part: the texture is null unless the text gives one.
/// Returns null after a diagnostic.
ObjectHandle read_object(Binder&, const Element& block);

/// Reads one of several objects in a row. A sphere that resembles the preceding one is appended to
/// `list`, and nothing is returned. `texture` is that of objects in the list without one of their
/// own.
std::optional<ObjectHandle> read_object_into(std::vector<ObjectHandle>& list,
                                             const Handle<Texture>& texture, Binder&,
                                             const Element& block);

}  // namespace candelabra

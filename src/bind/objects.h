// SPDX-License-Identifier: GPL-3.0-or-later
// Objects: every shape, union, object, and light sources inside of them, with all that changes an
// object. Called for the elements of a scene, for #declare, and for objects in objects.
#pragma once

#include "bind/bind.h"

namespace candelabra {

/// The object of a block that makes one, as a part: without a texture when the text gives none.
/// Null after a report.
ObjectHandle read_object(Binder&, const Element& block);

/// The same for one of several objects in a row: a sphere that is like the one before it is put to
/// the end of `list`, and there is nothing more to do with it (none is returned). Objects there
/// have this texture when they have none of their own.
std::optional<ObjectHandle> read_object_into(std::vector<ObjectHandle>& list,
                                             const Handle<Texture>& texture, Binder&,
                                             const Element& block);

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// Objects made after a model, from which they differ in little; spheres are put into rows. Called
// by the reader of objects for what comes again and again.
#pragma once

#include "bind/binder.h"

namespace candelabra {

/// The model with what differs; null when something is wrong with its values. `item` is the
/// vocabulary of its shape; null: it combines objects.
ObjectHandle like(Binder&, const Object& model, const ItemInfo* item, const Variable&,
                  const Variation&);

/// Objects that a sphere may join, and the texture of those that have none of their own.
struct RowEnd {
    std::vector<ObjectHandle>& list;
    const Handle<Texture>& texture;
};

/// Puts a sphere that is like the model to the end of the list: into the row that ends it, or as a
/// new one. False: the model is no sphere, or something is wrong with the values; nothing happened.
bool joins(const RowEnd&, const Object& model, const Variation&, Span);

}  // namespace candelabra

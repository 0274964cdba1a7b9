// SPDX-License-Identifier: GPL-3.0-or-later
// Makes objects as variations of a model, and collects spheres in rows. Called by the reader of
// objects for repeated blocks.
#pragma once

#include "reading/binder.h"

namespace candelabra {

/// A copy of the model with the variation; null if its values are invalid. `item` is the vocabulary
/// of the model's shape; null if the model combines objects.
ObjectHandle like(Binder&, const Object& model, const ItemInfo* item, const Variable&,
                  const Variation&);

/// Objects that a sphere may join, and the default texture of objects without one of their own.
struct RowEnd {
    std::vector<ObjectHandle>& list;
    const Handle<Texture>& texture;
};

/// Appends a sphere that varies the model to the list: to the row at its end, or as a new row.
/// Returns false, without effect, if the model is not a sphere or the values are invalid.
bool joins(const RowEnd&, const Object& model, const Variation&, Span);

/// Appends a sphere that was only moved, such as a declared one, to the row at the end of the list,
/// if it differs from these spheres of the same statement only in its place. Returns false, without
/// effect, otherwise.
bool joins(std::vector<ObjectHandle>& list, const Object&);

}  // namespace candelabra

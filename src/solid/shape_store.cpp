// SPDX-License-Identifier: GPL-3.0-or-later
#include "solid/shape_store.h"

namespace {

/// What copies of the shape share when it has to be built; null for shapes that are ready.
const void* shared_content(const Shape& shape) {
    return std::visit(
        [](const auto& stored) -> const void* {
            using Stored = std::remove_cvref_t<decltype(stored)>;
            if constexpr (Prepared<ContentOf<Stored>>)
                return &*stored;
            else
                return nullptr;
        },
        shape);
}

/// A landscape for a place that stretches it: as in POV-Ray, the normals of pixels are of length 1
/// there when they are mixed, not in the unit square.
BuiltHeightField stretched(BuiltHeightField field, const Transform& place) {
    for (Vec3& normal : field.normals) normal /= length(place.normal(normal));
    return field;
}

}  // namespace

BuiltShape ShapeStore::built(const Shape& shape) {
    const void* content = shared_content(shape);
    if (!content) return ::built(shape);
    const auto found = known_.find(content);
    if (found != known_.end()) return found->second.built;
    return known_.emplace(content, Known{shape, ::built(shape)}).first->second.built;
}

BuiltShape ShapeStore::built(const Shape& shape, const Handle<Transform>& place) {
    BuiltShape result = built(shape);
    const auto* field = std::get_if<Shared<BuiltHeightField>>(&result);
    if (!field || !(*field)->smooth || !place || place->uniform_scale() > 0) return result;
    const auto [found, added] = stretched_.try_emplace({&**field, place.get()});
    if (added) found->second = {place, Shared(stretched(**field, *place))};
    return found->second.built;
}

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

}  // namespace

BuiltShape ShapeStore::built(const Shape& shape) {
    const void* content = shared_content(shape);
    if (!content) return ::built(shape);
    const auto found = known_.find(content);
    if (found != known_.end()) return found->second.built;
    return known_.emplace(content, Known{shape, ::built(shape)}).first->second.built;
}

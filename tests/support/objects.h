// SPDX-License-Identifier: GPL-3.0-or-later
// Objects as the language makes them, from shapes and from each other.
#pragma once

#include "scene/scene.h"

#include <utility>
#include <vector>

namespace candelabra {

inline ObjectHandle object(const Shape& shape, bool inverse = false) {
    Object result;
    result.form = shape;
    result.inverse = inverse;
    return make_handle<Object>(result);
}

inline ObjectHandle group(Csg csg, std::vector<ObjectHandle> children) {
    Object result;
    result.form = Union{std::move(children), {}, {}, csg};
    return make_handle<Object>(result);
}

}  // namespace candelabra

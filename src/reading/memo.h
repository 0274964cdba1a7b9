// SPDX-License-Identifier: GPL-3.0-or-later
// Caches the results of constant elements, so that a loop makes them once. The key is the element
// and the base it was applied to: a `finish` changes the texture that is there before. Called by
// the readers of objects, textures and transforms.
#pragma once

#include "base/handle.h"
#include "reading/constants.h"

#include <cstdint>
#include <unordered_map>

namespace candelabra {

/// Caches each T that was made from a Base, which may be null.
template <class Base, class T = Base>
class Memo {
public:
    /// The element's result for the base: the cached one, or a new one by make(), which returns
    /// null on failure. Results of elements without a number are not cached.
    template <class Make>
    Handle<T> made(std::optional<std::uint64_t> element, const Handle<Base>& base, Make make) {
        if (!element) return make();
        const auto known = made_.find(*element);
        if (known != made_.end() && known->second.base == base) return known->second.result;
        Handle<Base> before = base;  // make() may change the base
        Handle<T> result = make();
        if (result) made_[*element] = {std::move(before), result};
        return result;
    }

private:
    struct Made {
        Handle<Base> base;
        Handle<T> result;
    };
    std::unordered_map<std::uint64_t, Made> made_;
};

}  // namespace candelabra

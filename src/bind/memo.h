// SPDX-License-Identifier: GPL-3.0-or-later
// What constant elements have made, so that a loop makes it once. Known by the element and by what
// it was made from: a `finish` changes the texture that is there before. Called by the readers of
// objects, textures and transforms.
#pragma once

#include "base/handle.h"
#include "bind/constants.h"

#include <cstdint>
#include <unordered_map>

namespace candelabra {

/// A T is made from a Base, which may be null.
template <class Base, class T = Base>
class Memo {
public:
    /// The value that the element makes of the base: the one made before, or a new one by make(),
    /// which is null when something is wrong. Elements without a number are not known again.
    template <class Make>
    Handle<T> made(std::optional<std::uint64_t> element, const Handle<Base>& base, Make make) {
        if (!element) return make();
        const auto known = made_.find(*element);
        if (known != made_.end() && known->second.base == base) return known->second.result;
        Handle<Base> before = base;  // which make() may change
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

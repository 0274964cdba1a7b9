// SPDX-License-Identifier: GPL-3.0-or-later
// Values of parts of space, which are found from places: space is halved across the longest side of
// the places in it until a part has its value.
#pragma once

#include "base/box.h"
#include "base/order.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// A pure function of the places from which it was made. Immutable.
class HalvedSpace {
public:
    HalvedSpace() = default;  ///< has no value

    /// Puts the places in order. `position(place)`; `value(places, size, axis)` of all places of a
    /// part, the size of their box and its longest axis: an optional number, which is the part's
    /// value; none: the part is divided. `division(places, axis)` of places in the order of their
    /// positions along the axis: index of the first one of the upper half, above 0.
    template <class Place, class Position, class Value, class Division>
    HalvedSpace(std::span<Place> places, const Position& position, const Value& value,
                const Division& division) {
        if (!places.empty()) divide(places, position, value, division);
    }

    bool empty() const { return parts_.empty(); }
    /// Value of the part that holds a point. Precondition: not empty().
    double at(const Vec3& point) const {
        std::uint32_t here = 0;
        while (parts_[here].second != 0)
            here = point[parts_[here].axis] < parts_[here].border ? here + 1 : parts_[here].second;
        return parts_[here].value;
    }

private:
    struct Part {
        double border = 0;         ///< between its halves
        std::uint32_t second = 0;  ///< the upper half, which the lower one precedes; 0: undivided
        std::int8_t axis = 0;
        double value = 0;
    };

    template <class Place, class Position, class Value, class Division>
    void divide(std::span<Place> places, const Position& position, const Value& value,
                const Division& division) {
        Box box;
        for (const Place& place : places) box = join(box, position(place));
        const Vec3 size = box.size();
        int axis = 0;
        for (const int other : {1, 2})
            if (size[other] > size[axis]) axis = other;
        const std::size_t own = parts_.size();
        parts_.emplace_back();
        if (const auto known = value(places, size, axis)) {
            parts_[own].value = *known;
            return;
        }
        sort_stably(places, {}, [&](const Place& place) { return position(place)[axis]; });
        const std::size_t middle = division(places, axis);
        parts_[own].axis = static_cast<std::int8_t>(axis);
        parts_[own].border = position(places[middle])[axis];
        divide(places.first(middle), position, value, division);
        parts_[own].second = static_cast<std::uint32_t>(parts_.size());
        divide(places.subspan(middle), position, value, division);
    }

    std::vector<Part> parts_;  ///< depth first
};

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// All luminaires of a world. Those of instances follow the others: they are stored once for all
// instances of a prototype, and made in their place when they are asked.
#pragma once

#include "base/handle.h"
#include "lighting/pick.h"
#include "luminaire/luminaire.h"
#include "world/geometry.h"

#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace candelabra {

/// A luminaire that is stored in a list, or was made for the call. A reference to it is valid as
/// long as this object.
class LuminaireAt {
public:
    explicit LuminaireAt(const Luminaire& stored) : it_(&stored) {}
    explicit LuminaireAt(Luminaire&& made) : made_(std::move(made)), it_(&*made_) {}
    LuminaireAt(const LuminaireAt&) = delete;
    LuminaireAt& operator=(const LuminaireAt&) = delete;

    const Luminaire& operator*() const { return *it_; }
    const Luminaire* operator->() const { return it_; }

private:
    std::optional<Luminaire> made_;
    const Luminaire* it_;
};

/// The luminaires of an instance.
struct PlacedLuminaires {
    LightIndex first;          ///< of them in the list
    PrimitiveIndex primitive;  ///< the first one of the instance
    const Prototype* prototype;
    const Transform* place;  ///< a similarity
};

class LuminaireList {
public:
    std::size_t size() const { return own_.size() + placed_count_; }
    bool empty() const { return size() == 0; }
    LuminaireAt operator[](LightIndex light) const {
        return light < own_.size() ? LuminaireAt(own_[light]) : LuminaireAt(made(light));
    }

    /// Has a luminaire fetched from memory, if there is one of the index and it is in no instance.
    void fetch(LightIndex light) const {
        if (light < own_.size()) candelabra::fetch(own_[light]);
    }

    /// Those of no instance, which are the first ones.
    std::vector<Luminaire>& own() { return own_; }
    const std::vector<Luminaire>& own() const { return own_; }

    /// Those of instances, in ascending order.
    std::span<const PlacedLuminaires> placed() const { return placed_; }
    /// Adds the luminaires of an instance, all of whose prototype's can be placed. Returns the
    /// index of the first one.
    LightIndex add(PrimitiveIndex first_primitive, const Prototype&, const Transform& place);

    template <class Use>
    void for_each(Use use) const {
        for (const Luminaire& luminaire : own_) use(luminaire);
        for (LightIndex light = static_cast<LightIndex>(own_.size()); light < size(); ++light)
            use(*(*this)[light]);
    }
    template <class Test>
    bool any_of(Test test) const {
        for (LightIndex light = 0; light < size(); ++light)
            if (test(*(*this)[light])) return true;
        return false;
    }

private:
    Luminaire made(LightIndex) const;

    std::vector<Luminaire> own_;
    std::vector<PlacedLuminaires> placed_;
    std::size_t placed_count_ = 0;
};

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// What a loop need not find out again about an object's block: what differs from pass to pass, and
// that all else means the same as the last time. Used by the reader of objects, which then takes
// the last object as a model and changes nothing but what differs.
#pragma once

#include "bind/variation.h"
#include "scene/scene.h"

#include <deque>

namespace candelabra {

/// One block of an object.
class ShapePlan {
public:
    ShapePlan(Variable variable, bool shape) : variable_(std::move(variable)), shape_(shape) {
        for (const NameId name : variable_.names()) names_.push_back({name, std::nullopt});
    }

    const Variable& variable() const { return variable_; }
    /// Whether it is worth while to go on with it.
    bool promising() const { return vain_ <= max_vain; }
    /// Something about the block was unusual.
    void note_vain() { ++vain_; }

    /// An object that has all but what differs from the same block, or null when that is not known.
    /// It is not moved by what differs.
    const Object* model(const Evaluator&, const Handle<Texture>& default_texture);
    /// The block has just made this object of what differs, and nothing was wrong.
    void learn(const Evaluator&, const Handle<Texture>& default_texture, const Variation&,
               const ObjectHandle&);

private:
    /// A plan that does not serve so much more often than it does is not worth keeping.
    static constexpr int max_vain = 8;

    /// A name in the rest and what it stood for when the model was made.
    struct Known {
        NameId name;
        std::optional<Value> value;  ///< none: it was not declared
    };
    bool unchanged(const Evaluator&) const;

    Variable variable_;
    bool shape_;    ///< otherwise it combines objects
    int vain_ = 0;  ///< models that were made and did not serve
    std::vector<Known> names_;
    Handle<Texture> default_texture_;
    ObjectHandle model_;
};

class ShapePlans {
public:
    /// The plan of an object's block; null when it is met for the first time, is constant as a
    /// whole (Memo is for those), or has none. `item` is the vocabulary of its shape; null: it
    /// combines objects.
    ShapePlan* find(Evaluator&, const Element& block, const ItemInfo* item);

private:
    // What nodes_ says of a block; more: the number of its plan.
    static constexpr std::uint32_t met = 1, hopeless = 2, planned = 3;

    std::vector<std::vector<std::uint32_t>> nodes_;  ///< by source, by node
    std::deque<ShapePlan> plans_;
};

}  // namespace candelabra

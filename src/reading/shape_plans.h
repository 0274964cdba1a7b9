// SPDX-License-Identifier: GPL-3.0-or-later
// Caches the analysis of an object's block in a loop: the values that vary from pass to pass, and
// whether everything else keeps its meaning. The reader of objects then uses the last object as a
// model and changes only the varying values.
#pragma once

#include "reading/variation.h"
#include "scene/scene.h"

#include <deque>

namespace candelabra {

/// The plan of one object's block.
class ShapePlan {
public:
    ShapePlan(Variable variable, bool shape) : variable_(std::move(variable)), shape_(shape) {
        for (const NameId name : variable_.names()) names_.push_back({name, std::nullopt});
    }

    const Variable& variable() const { return variable_; }
    /// Whether the plan is worth keeping.
    bool promising() const { return vain_ <= max_vain; }
    /// Counts a use of the block that the plan could not serve.
    void note_vain() { ++vain_; }

    /// The model for the next object of the block, or null if none is known. The varying movement
    /// is not applied to it.
    const Object* model(const Evaluator&, const Handle<Texture>& default_texture);
    /// Learns the model from an object that the block has just made with this variation and without
    /// errors.
    void learn(const Evaluator&, const Handle<Texture>& default_texture, const Variation&,
               const ObjectHandle&);

private:
    /// Failures in excess of successes after which a plan is dropped.
    static constexpr int max_vain = 8;

    /// A name in the invariant part of the block, and its value when the model was made.
    struct Known {
        NameId name;
        std::optional<Value> value;  ///< none: it was not declared
    };
    bool unchanged(const Evaluator&) const;

    Variable variable_;
    bool shape_;    ///< whether the block is a shape; otherwise it combines objects
    int vain_ = 0;  ///< models that were made in vain, less those that served
    std::vector<Known> names_;
    Handle<Texture> default_texture_;
    ObjectHandle model_;
};

class ShapePlans {
public:
    /// The plan of an object's block. Null at the first visit, for blocks that are entirely
    /// constant (Memo serves those), and for blocks without a plan. `item` is the vocabulary of the
    /// block's shape; null if it combines objects.
    ShapePlan* find(Evaluator&, const Element& block, const ItemInfo* item);

private:
    // Values in nodes_; a higher value is the number of a plan.
    static constexpr std::uint32_t met = 1, hopeless = 2, planned = 3;

    std::vector<std::vector<std::uint32_t>> nodes_;  ///< by source, by node
    std::deque<ShapePlan> plans_;
};

}  // namespace candelabra

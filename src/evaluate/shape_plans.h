// SPDX-License-Identifier: GPL-3.0-or-later
// What a loop need not find out again about a shape's block: with which values it begins, and that
// what follows them means the same as the last time. Used by the reader of objects, which then
// takes the last object as a model and changes nothing but its values.
#pragma once

#include "evaluate/evaluator.h"
#include "scene/scene.h"

#include <deque>

/// The values that a block begins with, as far as they could be computed.
struct LeadingValues {
    static constexpr std::size_t most = 6;

    std::array<Numbers, most> numbers;
    std::array<NodeId, most> nodes{};
    std::size_t count = 0;
    Body rest;  ///< what follows them
};

/// One block of a shape. What follows its values is the rest.
class ShapePlan {
public:
    /// Precondition: analysable().
    ShapePlan(const Body& block, std::size_t values);

    /// Whether all values that the shape needs come first, each as an expression of numbers.
    static bool analysable(Evaluator&, const Body& block, std::size_t values);

    LeadingValues compute(Evaluator&, const Body& block) const;
    bool complete(const LeadingValues& values) const { return values.count == values_; }

    /// An object that has all but its values from the same rest, or null when that is not known.
    const Object* model(const Evaluator&, const Handle<Texture>& default_texture);
    /// The block has just made this object, and nothing was wrong.
    void learn(const Evaluator&, const Handle<Texture>& default_texture, const ObjectHandle&);

private:
    /// A name in the rest and what it stood for when the model was made.
    struct Known {
        NameId name;
        std::optional<Value> value;  ///< none: it was not declared
    };
    bool unchanged(const Evaluator&) const;

    std::size_t values_;
    bool repeatable_;  ///< the rest has nothing but constants and names
    int vain_ = 0;     ///< models that were made and did not serve
    std::vector<Known> names_;
    Handle<Texture> default_texture_;
    ObjectHandle model_;
};

class ShapePlans {
public:
    /// The plan of a shape's block; null when it is met for the first time, is constant as a whole
    /// (Memo is for those), or has none. `item` is
    /// the shape's vocabulary.
    ShapePlan* find(Evaluator&, const Element& block, const ItemInfo& item);

private:
    // What nodes_ says of a block; more: the number of its plan.
    static constexpr std::uint32_t met = 1, hopeless = 2, planned = 3;

    std::vector<std::vector<std::uint32_t>> nodes_;  ///< by source, by node
    std::deque<ShapePlan> plans_;
};

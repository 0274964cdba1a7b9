// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays: making them, and finding elements in them.
#include "evaluate/state.h"
#include "text/message.h"

#include <cmath>

namespace {

std::size_t dimension_at(const ArrayData& array, std::size_t dimension) {
    return dimension < array.sizes.size() ? static_cast<std::size_t>(array.sizes[dimension]) : 0;
}

}  // namespace

Value Evaluator::State::array(const Tree& tree, const node::Array& node, NodeId id) {
    auto result = std::make_shared<ArrayData>();
    std::size_t count = 1;
    for (NodeId size = node.sizes; size != no_node; size = tree[size].next) {
        const std::optional<double> number = this->number(tree, size, "the size of an array");
        if (!number) return Absence::broken;
        const double whole = std::floor(*number + 1e-10);
        if (!(whole >= 1))
            return broken(Fault::out_of_range, tree.span(size),
                          message("the size of an array must be at least 1, but it is ", *number));
        if (whole * static_cast<double>(count) > static_cast<double>(limits.array_elements))
            return broken(Fault::out_of_range, tree.span(id),
                          message("an array has at most ", limits.array_elements, " elements"));
        result->sizes.push_back(static_cast<int>(whole));
        count *= static_cast<std::size_t>(whole);
    }
    if (result->sizes.size() > 5)
        return broken(
            Fault::wrong_count, tree.span(id),
            message("an array has at most 5 dimensions, but this has ", result->sizes.size()));
    if (result->sizes.empty()) {
        report(error(Fault::missing, tree.span(id), "an array needs its size")
                   .with_help("array[3], array[2][5]"));
        return Absence::broken;
    }
    result->elements.assign(count, Absence::uninitialised);
    if (node.content != no_node) {
        std::size_t next = 0;
        if (!fill(*result, 0, next, {&tree, tree.get<node::Braces>(node.content).body},
                  tree.span(node.content)))
            return Absence::broken;
    }
    return result;
}

/// Fills from `{ ... }`, which holds braces for each element of all dimensions but the last.
bool Evaluator::State::fill(ArrayData& array, std::size_t dimension, std::size_t& next, Body body,
                            Span span) {
    const bool innermost = dimension + 1 == array.sizes.size();
    const std::size_t wanted = dimension_at(array, dimension);
    std::size_t count = 0;
    bool good = true;
    std::vector<Element> blocks;
    const auto put = [&](Value value, Span place) {
        if (count++ >= wanted) return;
        if (value.broken()) good = false;
        for (const std::size_t before : {std::size_t{0}, next - (next > 0)})
            if (good && next > 0 && !array.elements[before].absent() &&
                !array.elements[before].same_kind(value)) {
                broken(Fault::wrong_type, place,
                       message("all elements of an array are of one kind: the first is ",
                               kind_name(array.elements[0]), ", and this is ", kind_name(value)));
                good = false;
            }
        array.elements[next++] = std::move(value);
    };
    walk(*body.tree, body.first, [&](const Element& element) {
        if (!good) {
            ++count;
        } else if (innermost && element.kind == Element::Kind::braces) {
            broken(Fault::wrong_type, element.span,
                   "braces for a dimension that this array does not have");
            good = false;
        } else if (innermost) {
            put(evaluator.value_of(element), element.span);
        } else if (element.kind == Element::Kind::braces) {
            if (count++ < wanted)
                good = fill(array, dimension + 1, next, element.body, element.span) && good;
        } else {
            broken(Fault::wrong_type, element.span,
                   message("this array has ", array.sizes.size(),
                           " dimensions: its content is braces in braces"));
            good = false;
        }
    });
    if (good && count != wanted && !stopped_) {
        broken(Fault::wrong_count, span,
               message("here are ", count, " elements for a dimension of ", wanted));
        good = false;
    }
    return good && !stopped_;
}

std::optional<Indices> Evaluator::State::indices(const Tree& tree, NodeId first) {
    Indices result;
    for (NodeId id = first; id != no_node; id = tree[id].next) {
        const std::optional<double> value = number(tree, id, "an index");
        if (!value) return std::nullopt;
        if (result.count == result.values.size()) {
            broken(Fault::wrong_count, tree.span(id),
                   message("at most ", result.values.size(), " indices can follow each other"));
            return std::nullopt;
        }
        result.places[result.count] = tree.span(id);
        result.values[result.count++] = *value;
    }
    return result;
}

std::optional<std::size_t> Evaluator::State::place(const ArrayData& array, const Indices& indices,
                                                   std::size_t& used, Span span) {
    std::size_t result = 0;
    for (std::size_t dimension = 0; dimension < array.sizes.size(); ++dimension, ++used) {
        if (used == indices.count) {
            broken(Fault::wrong_count, span,
                   message("this array has ", array.sizes.size(), " dimensions, and here are ",
                           dimension, " indices"));
            return std::nullopt;
        }
        const double value = indices.values[used];
        const double whole = std::floor(value + 1e-10);
        if (!(whole >= 0 && whole < array.sizes[dimension])) {
            broken(Fault::bad_index, indices.places[used],
                   message("the index must be from 0 to ", array.sizes[dimension] - 1,
                           ", but it is ", value));
            return std::nullopt;
        }
        result = result * dimension_at(array, dimension) + static_cast<std::size_t>(whole);
    }
    return result;
}

bool Evaluator::State::check_array(const Value& value, Span span) {
    if (value.array()) return true;
    if (!value.broken())
        broken(Fault::wrong_type, span,
               message("only arrays have elements, and this is ", kind_name(value)));
    return false;
}

const Value* Evaluator::State::element(const Value& array, const Indices& indices, Span span) {
    const Value* at = &array;
    for (std::size_t used = 0; used < indices.count;) {
        if (!check_array(*at, span)) return nullptr;
        const std::optional<std::size_t> i = place(*at->array(), indices, used, span);
        if (!i) return nullptr;
        at = &at->array()->elements[*i];
    }
    return at;
}

Value* Evaluator::State::edit_element(Value& array, const Indices& indices, Span span) {
    Value* at = &array;
    for (std::size_t used = 0; used < indices.count;) {
        if (!check_array(*at, span)) return nullptr;
        const std::optional<std::size_t> i = place(*at->array(), indices, used, span);
        if (!i) return nullptr;
        at = &at->edit_array().elements[*i];
    }
    return at;
}

const Value* Evaluator::State::other_element(const Value& array, const Indices& indices) {
    // The one behind the whole array's first index is enough to know the kind: elements are set one
    // after the other.
    const Value* at = &array;
    const Value* owner = &array;
    Span nowhere;
    for (std::size_t used = 0; used < indices.count && at->array();) {
        owner = at;
        const std::optional<std::size_t> i = place(*at->array(), indices, used, nowhere);
        if (!i) return nullptr;
        at = &at->array()->elements[*i];
    }
    if (!owner->array()) return nullptr;
    const std::vector<Value>& elements = owner->array()->elements;
    const auto i = static_cast<std::size_t>(at - elements.data());
    for (const std::size_t near : {std::size_t{0}, i - (i > 0), i})
        if (near < elements.size() && !elements[near].absent() && near != i) return &elements[near];
    return nullptr;
}

// SPDX-License-Identifier: GPL-3.0-or-later
// Arrays: making them, and finding elements in them.
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "text/ascii.h"
#include "text/message.h"
#include "text/nearest.h"
#include "text/printable.h"

#include <algorithm>
#include <cmath>

namespace candelabra {

namespace {

std::size_t dimension_at(const ArrayData& array, std::size_t dimension) {
    return dimension < array.sizes().size() ? static_cast<std::size_t>(array.sizes()[dimension])
                                            : 0;
}

/// Whether nothing need be missing where the element is left out: a comma may end a list.
bool is_last_gap(const Element& element) {
    return element.origin.tree->get<node::Omitted>(element.origin.first).last;
}

}  // namespace

Value Expressions::array(const Tree& tree, const node::Array& node, NodeId id) {
    std::vector<int> sizes;
    std::size_t count = 1;
    for (NodeId size = node.sizes; size != no_node; size = tree[size].next) {
        const std::optional<double> number = this->number(tree, size, "the size of an array");
        if (!number) return Absence::broken;
        const double whole = std::floor(*number + 1e-10);
        if (!(whole >= 1))
            return context_.broken(
                Fault::out_of_range, tree.span(size),
                message("the size of an array must be at least 1, but it is ", *number));
        if (whole * static_cast<double>(count) >
            static_cast<double>(context_.costs.limits.array_elements)) {
            context_.report(error(Fault::out_of_range, tree.span(id),
                                  message("an array has at most ",
                                          context_.costs.limits.array_elements, " elements"))
                                .with_help("--limit-elements raises the limit"));
            return Absence::broken;
        }
        sizes.push_back(static_cast<int>(whole));
        count *= static_cast<std::size_t>(whole);
    }
    if (sizes.size() > 5)
        return context_.broken(
            Fault::wrong_count, tree.span(id),
            message("an array has at most 5 dimensions, but this has ", sizes.size()));
    if (!context_.costs.spend(count, tree.span(id))) return Absence::broken;
    const auto kinds = node.mixed ? ArrayData::Kinds::mixed : ArrayData::Kinds::one;
    Handle<ArrayData> result = make_handle<ArrayData>(
        sizes.empty() ? ArrayData::growing(kinds) : ArrayData(std::move(sizes), kinds));
    if (node.content != no_node) {
        std::size_t next = 0;
        if (!fill(result.edit(), 0, next, Statements::braces_element(tree, node.content)))
            return Absence::broken;
    }
    return result;
}

bool Expressions::fill_one(ArrayData& array, std::size_t at, Value value, Span span) {
    if (value.broken()) return false;
    if (array.grows() && at >= array.size()) array.grow(static_cast<int>(at + 1));
    if (!array.fits(at, value)) {
        context_.report(error(Fault::wrong_type, span,
                              message("all elements of an array are of one kind: the first is ",
                                      kind_name(array.at(0)), ", and this is ", kind_name(value)))
                            .with_help("elements of several kinds can be in an `array mixed`"));
        return false;
    }
    array.set(at, std::move(value));
    return true;
}

/// Fills an array from `{ ... }`, with nested braces for all dimensions but the last.
bool Expressions::fill(ArrayData& array, std::size_t dimension, std::size_t& next,
                       const Element& braces) {
    const bool innermost = dimension + 1 == array.sizes().size();
    const std::size_t wanted =
        array.grows() ? context_.costs.limits.array_elements : dimension_at(array, dimension);
    const auto* written = braces.origin.tree->get_if<node::Braces>(braces.origin.first);
    const bool optional = written && written->optional;
    std::size_t count = 0;
    bool good = true;
    context_.statements->walk(*braces.body.tree, braces.body.first, [&](const Element& element) {
        const bool complete = array.grows() || count >= wanted;
        if (element.kind == Element::Kind::omitted && is_last_gap(element) && complete) return;
        if (!good || count++ >= wanted) return;
        if (element.kind == Element::Kind::omitted)
            good = leave_out(array, dimension, next);
        else if (!innermost && element.kind == Element::Kind::braces)
            good = fill(array, dimension + 1, next, element);
        else if (innermost && optional && is_undeclared(element))
            good = leave_out(array, dimension, next);
        else if (innermost && element.kind != Element::Kind::braces)
            good = fill_one(array, next++, context_.evaluator.value_of(element), element.span);
        else
            good = refuse_in_array(array, element);
    });
    if (good && count != wanted && !array.grows() && !context_.stopped()) {
        context_.broken(Fault::wrong_count, braces.span,
                        message("here are ", count, " elements for a dimension of ", wanted));
        good = false;
    }
    return good && !context_.stopped();
}

/// Reports what cannot be an element here. Returns false.
bool Expressions::refuse_in_array(const ArrayData& array, const Element& element) {
    const bool braces = element.kind == Element::Kind::braces;
    context_.broken(Fault::wrong_type, element.span,
                    braces ? "braces for a dimension that this array does not have"
                           : message("this array has ", array.sizes().size(),
                                     " dimensions: its content is braces in braces"));
    return false;
}

/// Leaves the elements of one index of a dimension unset. Returns false after a report.
bool Expressions::leave_out(ArrayData& array, std::size_t dimension, std::size_t& next) {
    std::size_t elements = 1;
    for (std::size_t i = dimension + 1; i < array.sizes().size(); ++i)
        elements *= dimension_at(array, i);
    next += elements;
    if (array.grows() && next > array.size()) array.grow(static_cast<int>(next));
    return true;
}

bool Expressions::is_undeclared(const Element& element) const {
    return element.kind == Element::Kind::word && !context_.names.reserved(element.word);
}

/// Makes a growing array large enough for an index. Returns false after a report.
bool Expressions::make_room(Value& array, const Indices& indices, std::size_t used, Span span) {
    const ArrayData* now = array.array();
    if (!now || !now->grows() || used >= indices.count || indices.text(used)) return true;
    const double index = std::floor(indices.values[used] + tolerance);
    if (!(index >= static_cast<double>(now->size()))) return true;
    if (index >= static_cast<double>(context_.costs.limits.array_elements)) {
        context_.report(error(Fault::out_of_range, span,
                              message("an array has at most ", context_.costs.limits.array_elements,
                                      " elements"))
                            .with_help("--limit-elements raises the limit"));
        return false;
    }
    constexpr std::uint64_t allocating = 100;
    const auto size = static_cast<std::size_t>(index) + 1;
    if (!context_.costs.spend(allocating + (array.alone() ? size - now->size() : 4 * size), span))
        return false;
    array.edit_array().grow(static_cast<int>(size));
    return true;
}

bool Expressions::indices(const Tree& tree, NodeId first, Indices& result) {
    result.tree = &tree;
    result.first = first;
    for (NodeId id = first; id != no_node; id = tree[id].next) {
        Value other = Absence::nothing;
        std::optional<double> number = number_or(tree, id, other);
        const std::string* const text = number ? nullptr : other.text();
        bool room = true;
        if (text) {
            constexpr std::uint64_t asking = 200, each_letter = 20;
            if (!context_.costs.spend(asking + each_letter * text->size(), tree.span(id)))
                return false;
            room = result.add(*text);
        } else {
            if (!number) number = number_in(other, tree, id, "an index");
            if (!number) return false;
            room = result.add(*number);
        }
        if (!room) {
            context_.broken(
                Fault::wrong_count, tree.span(id),
                message("at most ", result.values.size(), " indices can follow each other"));
            return false;
        }
    }
    return true;
}

void Expressions::report_unknown_name(const IndexNames* names, const std::string& name, Span span) {
    if (!names)
        return context_.report(
            error(Fault::bad_index, span,
                  message("this index must be a number: nothing here has a name")));
    const std::vector<std::string_view> known(names->all().begin(), names->all().end());
    Diagnostic problem = error(Fault::bad_index, span,
                               message("there is nothing called `", printable(name), "` here"));
    std::string help = nearest(name, known);
    if (!help.empty()) {
        help = message("did you mean \"", printable(help), "\"?");
    } else {
        constexpr std::size_t most = 8;
        for (std::size_t i = 0; i < std::min(most, known.size()); ++i)
            help += message(i == 0 ? "the names here are " : ", ", printable(known[i]));
        if (known.size() > most) help += ", ...";
    }
    context_.report(problem.with_help(std::move(help)));
}

std::optional<int> Expressions::index_in(const ArrayData& array, std::size_t dimension,
                                         Indices& indices, std::size_t used) {
    if (const std::string* text = indices.text(used)) {
        const bool last = dimension + 1 == array.sizes().size();
        const IndexNames* const names = last ? array.names().get() : nullptr;
        if (const auto found = names ? names->find(*text) : std::nullopt) return found;
        if (indices.expand(used)) return index_in(array, dimension, indices, used);
        if (!indices.asking) report_unknown_name(names, *text, indices.span(used));
        return std::nullopt;
    }
    const int size = array.sizes()[dimension];
    const double whole = indices.values[used] + tolerance;
    if (whole >= 0 && whole < size) return static_cast<int>(whole);
    if (array.grows() && whole >= 0) {
        if (!indices.asking)
            context_.broken(Fault::uninitialised, indices.span(used),
                            "this element of the array was never set");
        return std::nullopt;
    }
    context_.broken(
        Fault::bad_index, indices.span(used),
        message("the index must be from 0 to ", size - 1, ", but it is ", indices.values[used]));
    return std::nullopt;
}

std::optional<std::size_t> Expressions::place(const ArrayData& array, Indices& indices,
                                              std::size_t& used, Span span) {
    std::size_t result = 0;
    for (std::size_t dimension = 0; dimension < array.sizes().size(); ++dimension) {
        if (used == indices.count) {
            context_.broken(
                Fault::wrong_count, span,
                message("this array has ", array.sizes().size(), " dimensions, and here ",
                        dimension == 1 ? "is 1 index" : message("are ", dimension, " indices")));
            return std::nullopt;
        }
        const int size = array.sizes()[dimension];
        double whole = indices.values[used] + tolerance;
        if (!indices.texts.empty() || !(whole >= 0 && whole < size)) {
            const std::optional<int> index = index_in(array, dimension, indices, used);
            if (!index) return std::nullopt;
            whole = *index;
        }
        result = result * static_cast<std::size_t>(size) + static_cast<std::size_t>(whole);
        ++used;
    }
    return result;
}

bool Expressions::check_array(const Value& value, Span span) {
    if (value.array()) return true;
    if (value.broken()) return false;
    Diagnostic problem =
        error(Fault::wrong_type, span,
              message("only arrays have elements, and this is ", kind_name(value)));
    if (const Numbers* numbers = value.numbers(); numbers && numbers->count > 1)
        problem.with_help("the parts of a vector V are V.x, V.y and V.z");
    if (value.text()) problem.with_help("substr(S, 1, 1) is the first letter of a string");
    if (value.handle<Spline>()) problem.with_help("the value of a spline S is written S(0.5)");
    context_.report(std::move(problem));
    return false;
}

Value Expressions::element(const Value& array, Indices& indices, Span span) {
    Value at = array;
    for (std::size_t used = 0; used < indices.count;) {
        if (indices.asking && at.absent()) return at;
        if (indices.asking && !at.array()) return Absence::uninitialised;
        if (!check_array(at, span)) return Absence::broken;
        const std::optional<std::size_t> i = place(*at.array(), indices, used, span);
        if (!i) return Absence::broken;
        at = at.array()->at(*i);
    }
    return at;
}

Expressions::Place Expressions::edit_element(Value& array, Indices& indices, Span span) {
    Value* at = &array;
    for (std::size_t used = 0;;) {
        if (!at->array() && !check_array(*at, span)) return {};
        if (!make_room(*at, indices, used, span)) return {};
        const std::optional<std::size_t> i = place(*at->array(), indices, used, span);
        if (!i) return {};
        // A shared array is copied.
        constexpr std::uint64_t allocating = 100;
        if (!at->alone() && !context_.costs.spend(allocating + 4 * at->array()->size(), span))
            return {};
        ArrayData& edited = at->edit_array();
        if (used == indices.count) return {&edited, *i};
        at = edited.inner(*i);
        if (!at) {
            check_array(edited.at(*i), span);
            return {};
        }
    }
}

}  // namespace candelabra

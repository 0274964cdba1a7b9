// SPDX-License-Identifier: GPL-3.0-or-later
// Colours in expressions, and the parts of vectors and colours.
#include "base/gamma.h"
#include "interpret/expressions.h"
#include "text/message.h"

#include <utility>

namespace candelabra {

int component_of(std::string_view member) {
    struct Entry {
        std::string_view name;
        int component;
    };
    constexpr Entry entries[] = {{"x", 0},
                                 {"y", 1},
                                 {"z", 2},
                                 {"t", 3},
                                 {"u", 0},
                                 {"v", 1},
                                 {"red", 0},
                                 {"green", 1},
                                 {"blue", 2},
                                 {"filter", 3},
                                 {"transmit", 4},
                                 {"gray", grey_component},
                                 {"grey", grey_component}};
    for (const Entry& entry : entries)
        if (entry.name == member) return entry.component;
    return -1;
}

Value Expressions::member(const Tree& tree, const node::Member& node, NodeId id) {
    const Value value = evaluate(tree, node.operand);
    if (value.broken()) return value;
    const std::string_view name = context_.names.spelling(node.member);
    const Numbers* numbers = value.numbers();
    if (!numbers) {
        context_.report(
            error(Fault::wrong_type, tree.span(id),
                  message("`.", name, "` is a part of a vector or a colour, but this is ",
                          kind_name(value)))
                .with_help(value.array()  ? "dimension_size(A, 1) is the size of an array"
                           : value.text() ? "strlen(S) is the length of a string"
                                          : ""));
        return Absence::broken;
    }
    const int component = component_of(name);
    if (component < 0) {
        context_.report(
            error(Fault::unknown_word, tree.span(id),
                  message("a vector or a colour has no part `.", name, "`"))
                .with_help("parts are x y z t, u v, red green blue filter transmit, gray"));
        return Absence::broken;
    }
    if (component == grey_component)
        return grey_weights[0] * numbers->at[0] + grey_weights[1] * numbers->at[1] +
               grey_weights[2] * numbers->at[2];
    if (component >= numbers->count)
        return context_.broken(Fault::bad_index, tree.span(id),
                               message("there is no `.", name, "` in ", kind_name(value)));
    return numbers->at[static_cast<std::size_t>(component)];
}

Value Expressions::prefixed(const Tree& tree, const node::Prefixed& node, NodeId id) {
    const Value value = evaluate(tree, node.operand);
    if (value.broken()) return value;
    const std::string_view prefix = context_.names.spelling(node.prefix);
    const Numbers* given = value.numbers();
    if (!given)
        return context_.broken(
            Fault::wrong_type, tree.span(id),
            message("`", prefix, "` takes numbers, but this is ", kind_and_text(value)));
    const std::string_view form = prefix.substr(prefix.starts_with("s") ? 4 : 3);
    const int wanted = form.empty() ? 3 : form == "ft" ? 5 : 4;
    if (!given->is_scalar() && given->count != wanted)
        context_.report(warning(
            Fault::wrong_count, tree.span(node.operand),
            message("`", prefix, "` takes ", wanted, " numbers, but here are ", given->count)));
    Numbers result = given->promoted(wanted);
    result.count = 5;
    if (form == "t") result.at[4] = std::exchange(result.at[3], 0);
    if (prefix.starts_with("s"))
        for (std::size_t i = 0; i < 3; ++i)
            result.at[i] = from_linear(srgb_decode(result.at[i]), context_.working_gamma);
    return result;
}

bool Expressions::set_channel(const Tree& tree, const node::Channel& node, Numbers& colour) {
    const std::string_view name = context_.names.spelling(node.channel);
    const std::optional<double> amount = number(tree, node.operand, "the amount of", node.channel);
    if (!amount) return false;
    colour.at[static_cast<std::size_t>(name == "alpha" ? 3 : component_of(name))] = *amount;
    return true;
}

Value Expressions::colour(const Tree& tree, const node::Colour& node, NodeId id) {
    Numbers result;
    result.count = 5;
    if (node.base != no_node) {
        const Value base = evaluate(tree, node.base);
        if (base.broken()) return base;
        const Numbers* given = base.numbers();
        if (!given || given->count == 2) {
            constexpr const char* quoted =
                "colours have names without quotes: Red, in colors.inc; in a table they are "
                "written as #ff8800";
            context_.report(error(Fault::wrong_type, tree.span(id),
                                  message("a colour is wanted, but this is ", kind_and_text(base)))
                                .with_help(base.text() ? quoted : ""));
            return Absence::broken;
        }
        result = given->promoted(5);
    }
    for (NodeId channel = node.channels; channel != no_node; channel = tree[channel].next)
        if (!set_channel(tree, tree.get<node::Channel>(channel), result)) return Absence::broken;
    return result;
}

}  // namespace candelabra

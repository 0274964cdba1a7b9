// SPDX-License-Identifier: GPL-3.0-or-later
// Strings that are built from parts: concat() and str() write into one text, without a value for
// each part.
#include "interpret/calls.h"
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "interpret/string_functions.h"
#include "text/message.h"

namespace candelabra {

namespace {

/// Help on the conversion of a value to a string; empty for values other than numbers.
std::string as_text(const Value& value) {
    const Numbers* numbers = value.numbers();
    if (!numbers) return {};
    return numbers->is_scalar()
               ? "str(x, 0, 2) is the number x as a string"
               : message("vstr(", numbers->count, ", v, \", \", 0, 2) is the vector v as a string");
}

}  // namespace

/// Whether concat() or str() is called with as many arguments as it needs, and no directives.
bool Expressions::has_plain_arguments(const Tree& tree, const node::Call& call) const {
    int count = 0;
    for (NodeId at = call.arguments; at != no_node; at = tree[at].next, ++count)
        if (Statements::is_directive(tree, at) || context_.calls->macro_call(tree, at))
            return false;
    return call.name == concat_ ? count > 0 : count == 3;
}

bool Expressions::append_texts(const Tree& tree, NodeId first, std::string& text, NameId function) {
    bool good = true;
    for (NodeId id = first; id != no_node && !context_.stopped(); id = tree[id].next)
        good = append_text(tree, id, text, function) && good;
    return good;
}

bool Expressions::append_text(const Tree& tree, NodeId id, std::string& text, NameId function) {
    if (builds_text(tree, id)) {
        if (!context_.room(tree, id)) return false;
        const auto& call = tree.get<node::Call>(id);
        return call.name == concat_ ? append_texts(tree, call.arguments, text, concat_)
                                    : append_number(tree, call.arguments, text);
    }
    if (const auto* literal = tree.get_if<node::Text>(id)) {
        text += tree.texts[literal->text];
        return context_.costs.may_be_long(text.size(), tree.span(id));
    }
    const Value value = evaluate(tree, id);
    if (value.text()) {
        if (!context_.costs.may_be_long(text.size() + value.text()->size(), tree.span(id)))
            return false;
        text += *value.text();
    } else if (!value.broken()) {
        context_.report(error(Fault::wrong_type, tree.span(id),
                              message("`", context_.names.spelling(function),
                                      "` takes a string here, but this is ", kind_name(value)))
                            .with_help(as_text(value)));
    }
    return value.text() != nullptr;
}

std::optional<double> Expressions::number_argument(const Tree& tree, NodeId id, NameId function) {
    Numbers numbers;
    const bool computed = compute(tree, id, numbers);
    if (computed && numbers.is_scalar()) return numbers.at[0];
    const Value value = computed ? Value(numbers) : walk_expression(tree, id);
    const Numbers* found = value.numbers();
    if (found && found->is_scalar()) return found->at[0];
    if (!value.broken())
        context_.broken(Fault::wrong_type, tree.span(id),
                        message("`", context_.names.spelling(function),
                                "` takes a number here, but this is ", kind_name(value)));
    return std::nullopt;
}

/// Appends str(number, width, digits).
bool Expressions::append_number(const Tree& tree, NodeId first, std::string& text) {
    std::array<double, 3> values{};
    bool good = true;
    NodeId id = first;
    for (double& value : values) {
        const std::optional<double> found = number_argument(tree, id, str_);
        good = good && found;
        value = found.value_or(0);
        id = tree[id].next;
    }
    const std::size_t before = text.size();
    if (good) append_formatted(text, values[0], values[1], values[2]);
    constexpr std::uint64_t formatting = 30;
    return good && context_.costs.spend(formatting + text.size() - before, tree.span(first));
}

}  // namespace candelabra

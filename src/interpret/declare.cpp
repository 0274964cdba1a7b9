// SPDX-License-Identifier: GPL-3.0-or-later
// #declare, #local, #undef.
#include "interpret/expressions.h"
#include "interpret/statements.h"
#include "text/ascii.h"
#include "text/message.h"
#include "vocabulary/reserved.h"

namespace candelabra {

Value Statements::right_side(const Tree& tree, NodeId id) {
    const NodeContent& content = tree[id].content;
    if (const auto* layers = std::get_if<node::Layers>(&content)) {
        std::vector<Element> blocks;
        for (NodeId block = layers->blocks; block != no_node; block = tree[block].next)
            blocks.push_back(block_element(tree, block));
        return context_.expressions->one_value(blocks, tree.span(id));
    }
    std::vector<Element> elements;
    walk_one(tree, id, [&](const Element& element) { elements.push_back(element); });
    return context_.expressions->one_value(elements, tree.span(id));
}

namespace {

/// The first character of another value that follows a value on its line; empty if none does.
std::string_view value_behind(std::string_view rest) {
    const std::size_t at = rest.find_first_not_of(" \t");
    if (at == rest.npos) return {};
    const bool letter = at == 0 && is_letter(rest[at]);
    const bool begins = letter || is_digit(rest[at]) || rest[at] == '(' || rest[at] == '[';
    return begins ? rest.substr(at, 1) : std::string_view();
}

constexpr std::string_view semicolon_rule =
    "#declare and #local of numbers, vectors and colours end in `;`";
constexpr std::string_view old_scenes =
    "; a scene from before version 3.5 may go without, and begins with its version: #version 3.1;";

}  // namespace

/// Reports that a value lacks its semicolon.
void Statements::report_semicolon(const Tree& tree, const node::Declare& node) {
    // A macro may end in a semicolon, and the oldest scenes have none.
    if (context_.version < 3.1 || tree.get_if<node::Call>(node.value)) return;
    const Span end{tree.source, tree[node.value].last, tree[node.value].last};
    const std::string text = "a `;` is missing after this value";
    Diagnostic problem = context_.version >= 3.5 ? error(Fault::semicolon, end, text)
                                                 : warning(Fault::semicolon, end, text);
    const std::string_view rest = context_.sources.text(tree.source).substr(end.last);
    const bool decimal_comma = tree.get_if<node::Number>(node.value) && rest.starts_with(',');
    const std::string_view behind = value_behind(rest);
    if (behind == "[" && tree.get_if<node::Literal>(node.value))
        problem.message = "only arrays have elements";
    else if (!behind.empty())
        problem.message = "between this value and the next an operator is missing, or a `;`";
    if (decimal_comma)
        problem.with_help("a number is written with a point, 1.5, and a vector in <1, 2, 3>");
    else if (behind == "[")
        problem.with_help("the parts of a vector are V.x, V.y, V.z");
    else if (!behind.empty())
        problem.with_help("a product is written with its sign: 2*(3 + 4), 2*sin(1)");
    else if (!std::exchange(semicolons_reported_, true))
        problem.with_help(message(semicolon_rule, context_.version_given ? "" : old_scenes));
    context_.report(problem);
}

/// Declares numbers for a name or element that does not hold numbers yet.
void Statements::declare_numbers(const Tree& tree, const node::Declare& node,
                                 const Numbers& numbers) {
    const auto* name = node.local ? tree.get_if<node::Name>(node.target) : nullptr;
    const Value* before = name ? context_.scope.find(name->name) : nullptr;
    const bool taken = before && (before->macro() || context_.scope.is_local(name->name));
    if (name && !taken)
        context_.scope.declare_fresh_local(name->name, numbers);
    else
        assign(tree, node.target, numbers, node.local);
}

void Statements::declare(const Tree& tree, const node::Declare& node, NodeId id) {
    constexpr std::uint64_t declaring = 20;
    if (!context_.costs.spend(declaring, tree.span(id))) return;
    // Nearly always, numbers replace numbers.
    const auto* name = tree.get_if<node::Name>(node.target);
    Numbers* target = name ? context_.scope.overwritable(name->name, node.local) : nullptr;
    Numbers computed;
    if (context_.expressions->compute(tree, node.value, target ? *target : computed)) {
        check_semicolon(tree, node);
        if (!target) declare_numbers(tree, node, computed);
        return;
    }
    if (name && declare_text(tree, node)) return;
    if (tree.get_if<node::Tuple>(node.target)) return declare_tuple(tree, node, id);
    Value value = context_.expressions->walk_expression(tree, node.value);
    if (context_.stopped()) return;
    if (const Numbers* numbers = value.numbers()) {
        check_semicolon(tree, node);
        // Looked up again, because a macro may have changed the binding of the name.
        target = name ? context_.scope.overwritable(name->name, node.local) : nullptr;
        if (target) {
            *target = *numbers;
            return;
        }
    }
    assign(tree, node.target, std::move(value), node.local);
}

/// As in POV-Ray, textures after a call that yields one are layers on it, as in
/// `#declare T = Base() texture { ... }`. Returns the first node that is not a layer.
NodeId Statements::declare_layers(const Tree& tree, const node::Declare& node, NodeId next) {
    const auto* name = tree.get_if<node::Name>(node.target);
    if (!name || !tree.get_if<node::Call>(node.value) || !context_.handlers.layered) return next;
    for (; !context_.stopped(); next = tree[next].next) {
        const auto* block = tree.get_if<node::Block>(next);
        const Value* found = context_.scope.find(name->name);
        if (!block || block->word != "texture"_word || !found || kind_name(*found) != "a texture")
            break;
        const Value below = *found;
        const Element layer = block_element(tree, next);
        const Value above = context_.handlers.value({&layer, 1});
        if (above.broken() || context_.stopped()) continue;
        assign(tree, node.target, context_.handlers.layered(below, above, layer.word_span),
               node.local);
    }
    return next;
}

bool Statements::declare_text(const Tree& tree, const node::Declare& node) {
    if (!context_.expressions->builds_text(tree, node.value)) return false;
    const NameId name = tree.get<node::Name>(node.target).name;
    const auto& call = tree.get<node::Call>(node.value);
    const auto* first = tree.get_if<node::Name>(call.arguments);
    // `#declare S = concat(S, ...)` appends. The old text is kept while the rest is built, because
    // that may change it.
    const Value* before = context_.scope.find(name);
    const bool appends = context_.expressions->is_concat(call.name) && first &&
                         first->name == name && before && before->text();
    Handle<std::string> old = appends ? before->handle<std::string>() : nullptr;
    std::string text;
    const bool good =
        appends
            ? context_.expressions->append_texts(tree, tree[call.arguments].next, text, call.name)
            : context_.expressions->append_text(tree, node.value, text, call.name);
    if (!good || context_.stopped()) {
        if (!context_.stopped()) assign(tree, node.target, Absence::broken, node.local);
        return true;
    }
    Value* const target = context_.scope.overwritable_text(name, node.local);
    const bool unchanged = appends && target && target->text() == old.get();
    if (appends && !unchanged) text.insert(0, *old);
    old = nullptr;
    const std::size_t length = text.size() + (unchanged ? target->text()->size() : 0);
    // Only the appended text counts as work, unless the whole is copied.
    if (length > context_.costs.limits.text_bytes &&
        !context_.costs.may_be_long(length, tree.span(node.value)))
        return true;
    std::string* const own = target ? target->own_text() : nullptr;
    if (unchanged && own) {
        own->append(text);
        return true;
    }
    if (unchanged && !context_.costs.may_be_long(length, tree.span(node.value))) return true;
    if (unchanged) text.insert(0, *target->text());
    if (own)
        own->assign(text);
    else
        assign(tree, node.target, Value(std::move(text)), node.local);
    return true;
}

void Statements::declare_deprecated(const Tree& tree, const node::Deprecated& node, NodeId id) {
    const auto& declared = tree.get<node::Declare>(node.declare);
    declare(tree, declared, id);
    const auto* name = tree.get_if<node::Name>(declared.target);
    if (!name) return;
    const std::string plain =
        message("`", context_.names.spelling(name->name), "` is not to be used any more");
    const std::string* text =
        node.text == no_node ? &plain : &tree.texts[tree.get<node::Text>(node.text).text];
    context_.deprecated[name->name] = {*text, node.once, {}};
}

/// Declares `#declare (a, B[1],, c) = (1, 2, 3, 4);`, one after the other. A macro may give the
/// parentheses. A target that is left out drops its value.
void Statements::declare_tuple(const Tree& tree, const node::Declare& node, NodeId id) {
    NodeId target = tree.get<node::Tuple>(node.target).content;
    bool as_many = true;
    const auto give = [&](Value&& value) {
        as_many &= target != no_node;
        if (target == no_node) return;
        if (!tree.get_if<node::Omitted>(target)) assign(tree, target, std::move(value), node.local);
        target = tree[target].next;
    };
    if (tree.get_if<node::Call>(node.value)) {
        std::vector<Value> given;
        auto* const around = std::exchange(context_.awaited_tuple, &given);
        const Value result = context_.expressions->walk_expression(tree, node.value);
        as_many = std::exchange(context_.awaited_tuple, around) == nullptr;
        if (context_.stopped() || result.broken()) return;
        if (as_many)
            for (Value& each : given) give(std::move(each));
    } else {
        const auto* values = tree.get_if<node::Tuple>(node.value);
        NodeId value = values ? values->content : no_node;
        for (; target != no_node && value != no_node; value = tree[value].next)
            give(context_.expressions->evaluate(tree, value));
        as_many = value == no_node;
    }
    if (!as_many || target != no_node)
        context_.broken(Fault::wrong_count, tree.span(id), "there must be as many values as names");
}

void Statements::assign(const Tree& tree, NodeId target, Value&& value, bool local) {
    const Span span = tree.span(target);
    if (const auto* name = tree.get_if<node::Name>(target)) {
        const Value* before = context_.scope.find(name->name);
        if (before && before->macro()) {
            context_.broken(Fault::redefinition, span,
                            message("`", context_.names.spelling(name->name),
                                    "` is a macro and cannot become something else"));
            return;
        }
        if (before && before->formula() && (!local || context_.scope.is_local(name->name))) {
            context_.report(
                error(Fault::redefinition, span,
                      message("`", context_.names.spelling(name->name),
                              "` is a function and cannot become something else"))
                    .with_help(message("#undef ", context_.names.spelling(name->name), " first")));
            return;
        }
        if (local)
            context_.scope.declare_local(name->name, std::move(value));
        else
            context_.scope.declare(name->name, std::move(value));
        return;
    }
    if (const auto* index = tree.get_if<node::Index>(target))
        assign_element(tree, *index, target, std::move(value));
    else
        context_.broken(Fault::wrong_type, span, "this cannot be declared");
}

void Statements::assign_element(const Tree& tree, const node::Index& index, NodeId target,
                                Value&& value) {
    constexpr std::uint64_t each = 80;
    context_.costs.work += each;
    const Span span = tree.span(target);
    Indices places;
    if (!context_.expressions->indices(tree, index.indices, places)) return;
    Value* array = context_.scope.edit(index.name);
    if (!array) {
        const std::string_view name = context_.names.spelling(index.name);
        context_.report(error(Fault::unknown_name, span, message("there is no array `", name, "`"))
                            .with_help(message("make it first: #declare ", name, " = array[10];")));
        return;
    }
    const Expressions::Place place = context_.expressions->edit_element(*array, places, span);
    const Numbers* numbers = value.numbers();
    if (place.array && numbers && place.array->max_numbers() > 0)
        place.array->set(place.element, *numbers);
    else if (place.array && !value.broken() && !place.array->fits(place.element, value))
        context_.report(error(Fault::wrong_type, span,
                              message("all elements of an array are of one kind: others are ",
                                      kind_name(place.array->other(place.element)),
                                      ", and this is ", kind_name(value)))
                            .with_help("elements of several kinds can be in an `array mixed`"));
    else if (place.array)
        place.array->set(place.element, std::move(value));
    context_.scope.edited();
}

void Statements::undefine(const Tree& tree, NodeId target) {
    if (const auto* name = tree.get_if<node::Name>(target)) {
        context_.deprecated.erase(name->name);
        if (!context_.scope.undefine(name->name))
            context_.report(warning(
                Fault::unknown_name, tree.span(target),
                message("nothing is declared as `", context_.names.spelling(name->name), "`")));
        return;
    }
    const auto& index = tree.get<node::Index>(target);
    Indices places;
    if (!context_.expressions->indices(tree, index.indices, places)) return;
    Value* array = context_.scope.edit(index.name);
    if (!array) {
        context_.unknown_name(index.name, tree.span(target));
    } else if (const Expressions::Place place =
                   context_.expressions->edit_element(*array, places, tree.span(target));
               place.array) {
        place.array->clear(place.element);
    }
    context_.scope.edited();
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "syntax/parse_state.h"

#include "syntax/contract_words.h"
#include "text/message.h"

#include <algorithm>
#include <array>

namespace candelabra {

List ParseState::append(List list, NodeId node) {
    if (node == no_node) return list.with_comma(false);
    if (list.empty()) return {node, node, false};
    tree[list.last()].next = node;
    return {list.first(), node, false};
}

List ParseState::joined(List a, List b) {
    if (a.empty()) return b;
    if (b.empty()) return a;
    tree[a.last()].next = b.first();
    return {a.first(), b.last(), b.comma()};
}

List ParseState::comma(List list, Stretch place) {
    if (list.comma())
        diagnostics.add(error(Fault::syntax, span(place), "two commas in a row")
                            .with_help("leave one out, or put the missing value between them"));
    return list.with_comma(true);
}

List ParseState::comma_or_gap(List list, Stretch place) {
    if (list.empty() || list.comma())
        list = append(list, add({place.first, place.last}, node::Omitted{false}));
    return list.with_comma(true);
}

List ParseState::last_gap(List list, Stretch end) {
    return list.comma() ? append(list, add({end.first, end.first}, node::Omitted{true})) : list;
}

NodeId ParseState::negative(NodeId operand, Stretch place) {
    const auto* number = tree.get_if<node::Number>(operand);
    if (!number || text[tree[operand].first] == '-')
        return add(place, node::Unary{Operator::minus, operand});
    // Not negated in place: the token may stand in several branches, or in each call of a macro.
    tree.numbers.push_back(-tree.numbers[number->number]);
    tree[operand].content = node::Number{static_cast<std::uint32_t>(tree.numbers.size() - 1)};
    tree[operand].first = place.first;
    return operand;
}

List ParseState::operands(NodeId expression) {
    if (const auto* chain = tree.get_if<node::Chain>(expression))
        return {chain->first, chain->last, false};
    std::vector<NodeId> signs;
    while (const auto* binary = tree.get_if<node::Binary>(expression)) {
        signs.push_back(expression);
        expression = binary->left;
    }
    List result = append({}, expression);
    for (; !signs.empty(); signs.pop_back()) {
        const node::Binary binary = tree.get<node::Binary>(signs.back());
        result = with_operands(result, binary.sign, binary.right);
    }
    return result;
}

List ParseState::with_operands(List list, Operator sign, NodeId expression) {
    const List more = operands(expression);
    const NodeId first = more.first();
    const NodeId rest = tree[first].next;
    tree[first].next = no_node;
    list = append(list, add({tree[first].first, tree[first].last}, node::Joined{sign, first}));
    return rest == no_node ? list : joined(list, {rest, more.last(), false});
}

bool ParseState::may_be_text(NodeId operand) const {
    while (const auto* unary = tree.get_if<node::Unary>(operand)) operand = unary->operand;
    if (const auto* binary = tree.get_if<node::Binary>(operand)) return binary->open;
    const auto* call = tree.get_if<node::Call>(operand);
    return call ? !names.reserved(call->name)
                : tree.gives_elements(operand) || tree.get_if<node::Nothing>(operand);
}

NodeId ParseState::binary(Operator sign, NodeId left, NodeId right, Stretch place) {
    if (!tree.get_if<node::Chain>(left) && !tree.get_if<node::Chain>(right))
        return add(place, node::Binary{left, right, sign, may_be_text(left) || may_be_text(right)});
    const List all = with_operands(operands(left), sign, right);
    return add(place, node::Chain{all.first(), all.last()});
}

NodeId ParseState::goes_on(NodeId expression, NodeId directive, Stretch place) {
    const List all = append(operands(expression), directive);
    return add(place, node::Chain{all.first(), all.last()});
}

NodeId ParseState::continued(List operands, NodeId expression, Stretch place) {
    const List all = joined(operands, this->operands(expression));
    return add(place, node::Chain{all.first(), all.last()});
}

NodeId ParseState::joining(Operator sign, NodeId expression, Stretch place) {
    const List all = with_operands({}, sign, expression);
    return add(place, node::Chain{all.first(), all.last()});
}

NodeId ParseState::group(List directives, List values, Stretch place) {
    if (!values.empty() && values.first() != values.last())
        return add(place, node::Tuple{joined(directives, values).first()});
    return add(place, node::Group{joined(directives, values).first()});
}

NodeId ParseState::vector(List components, Stretch place) {
    // Numbers only: gives the same node as the token that the lexer makes of the simplest form.
    std::array<double, 5> numbers{};
    std::uint32_t count = 0;
    for (NodeId id = components.first(); id != no_node; id = tree[id].next, ++count) {
        const auto* number = tree.get_if<node::Number>(id);
        if (!number || count == numbers.size()) return add(place, node::Vector{components.first()});
        numbers[count] = tree.numbers[number->number];
    }
    if (count < 2) return add(place, node::Vector{components.first()});
    const auto first = static_cast<std::uint32_t>(tree.numbers.size());
    tree.numbers.insert(tree.numbers.end(), numbers.begin(), numbers.begin() + count);
    return add(place, node::Literal{first, count});
}

NodeId ParseState::layered(List blocks, Stretch place) {
    return blocks.first() == blocks.last() ? blocks.first()
                                           : add(place, node::Layers{blocks.first()});
}

NodeId ParseState::declared(NodeId declare, bool local, Stretch place) {
    std::get_if<node::Declare>(&tree[declare].content)->local = local;
    tree[declare].first = place.first;
    return declare;
}

NodeId ParseState::branch(NodeId condition, List body, Stretch place, std::uint32_t end) {
    const std::uint32_t begin = condition == no_node ? place.first : tree[condition].last;
    return add(place, node::Branch{condition, unless_wrong(body, {begin, end})});
}

NodeId ParseState::unless_wrong(List body, Stretch part, bool alone) {
    const NodeId wrong = postpones && diagnostics.failed() ? postponed(part, alone) : no_node;
    return wrong == no_node ? body.first() : wrong;
}

NodeId ParseState::postponed(Stretch part, bool alone) {
    Diagnostics others = diagnostics.fresh();
    Diagnostics inside = diagnostics.fresh();
    const auto covers = [&](Span span) {
        return part.first <= span.first && span.last <= part.last;
    };
    for (const Diagnostic& each : diagnostics.all()) {
        // Brackets that the part leaves open are reported where it ends.
        const bool here =
            alone ? covers(each.span) && std::ranges::all_of(each.labels, covers, &Label::span)
                  : covers(each.span) || std::ranges::any_of(each.labels, covers, &Label::span);
        (here ? inside : others).add(each);
    }
    if (!inside.failed()) return no_node;
    diagnostics = std::move(others);
    tree.postponed.push_back(inside.all());
    return add(part, node::Postponed{static_cast<std::uint32_t>(tree.postponed.size() - 1)});
}

NodeId ParseState::with_channel(NodeId colour, NodeId channel, Stretch place) {
    auto* open = colour == no_node ? nullptr : std::get_if<node::Colour>(&tree[colour].content);
    if (!open) {
        const NodeId made = add(place, node::Colour{colour, channel});
        last_channels[made] = channel;
        return made;
    }
    NodeId& last = last_channels.try_emplace(colour, no_node).first->second;
    (last == no_node ? open->channels : tree[last].next) = channel;
    last = channel;
    tree[colour].first = place.first;
    tree[colour].last = place.last;
    return colour;
}

List ParseState::word_first(NameId word, Stretch place, List rest) {
    const auto* braces = tree.get_if<node::Braces>(rest.first());
    if (!braces) return joined(append({}, add(place, node::Word{word})), rest);
    tree[rest.first()].content = node::Block{word, braces->body};
    tree[rest.first()].first = place.first;
    return rest;
}

List ParseState::without_commas(List values, List names) {
    const auto* first = tree.get_if<node::Name>(values.last());
    const std::string_view type = first ? this->names.spelling(first->name) : std::string_view();
    constexpr auto types = std::array<std::string_view, 4>{"float", "double", "int", "vector"};
    if (std::ranges::find(types, type) != types.end())
        diagnostics.add(error(Fault::syntax, tree.span(values.last()),
                              message("`", type, "` is no type here, but one more parameter"))
                            .with_help("the parameters of a function are numbers, and only named: "
                                       "function(X, Y) { X*Y }"));
    return joined(values, names);
}

List ParseState::parameter(List list, NameId name, Stretch place, List contract) {
    // Words of contracts and `optional` are not reserved. They are keywords beside a name without a
    // comma.
    NodeId last = list.empty() || list.comma() ? no_node : list.last();
    const auto* before = last == no_node ? nullptr : tree.get_if<node::Parameter>(last);
    if (before && is_contract_word(names.spelling(name))) {
        agree(last, joined(append({}, add(place, node::Kind{name, 0})), contract), place.last);
        return list;
    }
    if (before && !before->optional && before->contract == no_node &&
        names.spelling(before->name) == "optional") {
        parameters.erase(before->name);
        tree[last].content = node::Parameter{name, no_node, true};
        tree[last].last = place.last;
    } else {
        last = add(place, node::Parameter{name, no_node, false});
        list = append(list, last);
    }
    note_parameter(name, last, place);
    agree(last, contract, place.last);
    return list;
}

void ParseState::agree(NodeId parameter, List contract, std::uint32_t end) {
    NodeId* at = &std::get<node::Parameter>(tree[parameter].content).contract;
    while (*at != no_node) at = &tree[*at].next;
    *at = contract.first();
    tree[parameter].last = contract.empty() ? end : tree[contract.last()].last;
}

void ParseState::note_parameter(NameId name, NodeId id, Stretch place) {
    const auto [first, is_new] = parameters.try_emplace(name, id);
    if (is_new) return;
    diagnostics.add(error(Fault::redefinition, span(place),
                          message("a second parameter is called `", names.spelling(name), "`"))
                        .pointing(tree.span(first->second), "the first")
                        .with_help("the parameters of a macro have different names"));
}

NodeId ParseState::array_in_parentheses(Stretch place) {
    diagnostics.add(
        error(Fault::syntax, span(place), "the size of an array stands in square brackets")
            .with_help("array[3], or array { 1, 2, 3 }"));
    return add(place, node::Broken{});
}

namespace {

/// The number with a decimal comma at the end of the text, as in `= 1,5`; empty if none.
std::string_view number_with_comma(std::string_view text) {
    constexpr std::string_view digits = "0123456789";
    const std::size_t comma = text.find_last_not_of(digits);
    if (comma == text.npos || comma + 1 == text.size() || text[comma] != ',') return {};
    const std::size_t sign = text.substr(0, comma).find_last_not_of(digits);
    if (sign == text.npos || sign + 1 == comma) return {};
    const std::size_t equal = text.substr(0, sign + 1).find_last_not_of(" -+");
    if (equal == text.npos) return {};
    const bool wants = text[equal] == '=' || text.substr(0, equal + 1).ends_with("#version");
    return wants ? text.substr(sign + 1) : std::string_view();
}

/// Whether a semicolon here is meant to end a declaration of a number. Then the tokens between the
/// number and the semicolon will be reported.
bool ends_declaration(std::string_view text) {
    const std::string_view line = text.substr(text.find_last_of("\r\n") + 1);
    const std::size_t hash = line.rfind('#');
    if (hash == line.npos) return false;
    const std::string_view rest = line.substr(hash);
    return (rest.starts_with("#declare") || rest.starts_with("#local")) &&
           rest.find_first_of(";{}") == rest.npos;
}

}  // namespace

NodeId ParseState::stray_semicolon(Stretch place) {
    // After an error it may be the end of text that was skipped.
    if (diagnostics.failed()) return no_node;
    if (const auto number = number_with_comma(text.substr(0, place.first)); !number.empty()) {
        const auto first = place.first - static_cast<std::uint32_t>(number.size());
        const std::size_t comma = number.find(',');
        diagnostics.add(error(Fault::syntax, span({first, place.first}),
                              "a number is written with a point, not with a comma")
                            .with_help(message("write ", number.substr(0, comma), ".",
                                               number.substr(comma + 1))));
        return no_node;
    }
    if (ends_declaration(text.substr(0, place.first))) return no_node;
    diagnostics.add(warning(Fault::semicolon, span(place), "this `;` has no effect")
                        .with_help("`;` ends a #declare of numbers and nothing else"));
    return no_node;
}

NodeId ParseState::patched_version(NameId program, Stretch place) {
    diagnostics.add(
        error(Fault::out_of_range, span(place),
              message("this scene is written for `", names.spelling(program),
                      "`, a patched POV-Ray whose additions are not known here"))
            .with_help("write `#version 3.7;`, and what only that program has will be reported"));
    return add(place, node::Broken{});
}

}  // namespace candelabra

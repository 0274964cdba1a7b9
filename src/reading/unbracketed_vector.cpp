// SPDX-License-Identifier: GPL-3.0-or-later
#include "reading/unbracketed_vector.h"

#include "interpret/previous.h"
#include "text/message.h"
#include "vocabulary/reserved.h"

#include <algorithm>
#include <array>
#include <vector>

namespace candelabra {

namespace {

constexpr auto words_of_vectors =
    std::array{"translate"_word, "rotate"_word,   "scale"_word,     "location"_word,
               "direction"_word, "right"_word,    "up"_word,        "sky"_word,
               "look_at"_word,   "point_at"_word, "turbulence"_word};

/// Whether the node may be a number: it is not a vector, a colour or a word. The values of names
/// are unknown here.
bool may_be_number(const Tree& tree, NodeId id) {
    return tree.get_if<node::Number>(id) || tree.get_if<node::Unary>(id) ||
           tree.get_if<node::Binary>(id) || tree.get_if<node::Group>(id) ||
           tree.get_if<node::Name>(id) || tree.get_if<node::Index>(id);
}

/// Adjacent numbers in a list.
struct Row {
    NodeId before = no_node;  ///< the node before them
    std::vector<NodeId> numbers;
};

Row row_around(const Element& element) {
    const auto& [tree, node] = element.origin;
    Row row;
    for (row.before = node; row.before != no_node && may_be_number(*tree, row.before);
         row.before = previous(*tree, row.before))
        row.numbers.push_back(row.before);
    std::ranges::reverse(row.numbers);
    for (NodeId id = (*tree)[node].next; id != no_node && may_be_number(*tree, id);
         id = (*tree)[id].next)
        row.numbers.push_back(id);
    return row;
}

bool is_number(const Element& element) {
    const Numbers* numbers = element.value.numbers();
    return element.origin.tree && numbers && numbers->is_scalar();
}

/// The vector as text, `<1, 2, 3>`, or `letters` if an element is not a literal number.
std::string as_vector(const Tree& tree, std::span<const NodeId> numbers, std::string_view letters) {
    std::string result;
    for (const NodeId id : numbers) {
        const auto* number = tree.get_if<node::Number>(id);
        if (!number) return std::string(letters);
        result += message(result.empty() ? "<" : ", ", tree.numbers[number->number]);
    }
    return result + ">";
}

bool is_colour(FieldType type) { return type == FieldType::rgb || type == FieldType::colour; }

std::size_t components(FieldType type) {
    return type == FieldType::vector3 || is_colour(type) ? 3 : type == FieldType::vector2 ? 2 : 1;
}

/// A diagnostic that states the error and the correct form.
Diagnostic report(const Element& element, std::string says, std::string meant) {
    return error(Fault::wrong_count, element.span, std::move(says))
        .with_help(message("write `", meant, "`"));
}

}  // namespace

std::optional<Diagnostic> unbracketed_vector(const Element& element, const Names& names) {
    if (!is_number(element)) return std::nullopt;
    const Tree& tree = *element.origin.tree;
    Row row = row_around(element);
    if (row.before == no_node || row.numbers.empty()) return std::nullopt;
    const auto* word = tree.get_if<node::Word>(row.before);
    if (word && row.numbers.size() > 1) {
        if (std::ranges::find(words_of_vectors, word->word) == words_of_vectors.end())
            return std::nullopt;
        const std::string_view name = names.spelling(word->word);
        return report(element,
                      message("`", name, "` takes one vector, and a vector stands in `< >`"),
                      message(name, ' ', as_vector(tree, row.numbers, "<x, y, z>")));
    }
    // A colour node contains its first number.
    const auto* colour = tree.get_if<node::Colour>(row.before);
    NodeId value = colour && colour->channels == no_node ? colour->base : row.before;
    std::string prefix = colour ? "color " : "";
    if (const auto* prefixed = tree.get_if<node::Prefixed>(value)) {
        prefix += message(names.spelling(prefixed->prefix), ' ');
        value = prefixed->operand;
    }
    if (prefix.empty() || value == no_node || !may_be_number(tree, value)) return std::nullopt;
    row.numbers.insert(row.numbers.begin(), value);
    return report(element, "the numbers of a colour stand in `< >`",
                  message(prefix, as_vector(tree, row.numbers, "<r, g, b>")));
}

std::optional<Diagnostic> unbracketed_vectors(const Element& element, const ItemInfo& item) {
    if (!is_number(element)) return std::nullopt;
    const Tree& tree = *element.origin.tree;
    const Row row = row_around(element);
    const auto most = static_cast<std::size_t>(item.positional);
    if (row.before != no_node || row.numbers.size() <= most) return std::nullopt;
    std::string meant = message(item.name, " {");
    std::span<const NodeId> rest = row.numbers;
    for (const FieldInfo& field : item.fields.first(most)) {
        const std::size_t count = components(field.type);
        if (count > rest.size()) return std::nullopt;
        const auto* number = tree.get_if<node::Number>(rest.front());
        meant += rest.size() == row.numbers.size() ? " " : ", ";
        if (is_colour(field.type)) meant += "rgb ";
        meant += count > 1 ? as_vector(tree, rest.first(count), "<x, y, z>")
                 : number  ? message(tree.numbers[number->number])
                           : std::string(field.name);
        rest = rest.subspan(count);
    }
    if (!rest.empty()) return std::nullopt;
    return report(element,
                  message("`", item.name, "` takes ", most, most == 1 ? " value" : " values",
                          ", and a vector among them stands in `< >`"),
                  meant + " }");
}

std::string moved_without_times(const Element& element, const Names& names) {
    const auto& [tree, node] = element.origin;
    if (!tree || node == no_node || !element.value.numbers()) return {};
    const NodeId first = previous(*tree, node);
    if (first == no_node) return {};
    const auto* axis = tree->get_if<node::Constant>(node);
    const auto* number = tree->get_if<node::Number>(axis ? first : node);
    if (!axis) axis = tree->get_if<node::Constant>(first);
    const NodeId move = axis && number ? previous(*tree, first) : no_node;
    const auto* word = move == no_node ? nullptr : tree->get_if<node::Word>(move);
    const bool moves = word && (word->word == "translate"_word || word->word == "rotate"_word);
    if (!moves) return {};
    return message(names.spelling(word->word), ' ', names.spelling(axis->word), '*',
                   tree->numbers[number->number]);
}

bool begins_comment(const Element& element, const Evaluator& evaluator) {
    constexpr int least = 3;
    const auto& [tree, node] = element.origin;
    NodeId id = node;
    for (int words = 0; words < least; ++words, id = (*tree)[id].next) {
        const auto* name = id == no_node ? nullptr : tree->get_if<node::Name>(id);
        if (!name || evaluator.find(name->name)) return false;
    }
    return true;
}

bool follows_message(const Element& element) {
    const auto& [tree, node] = element.origin;
    const NodeId before = tree ? previous(*tree, node) : no_node;
    return before != no_node &&
           (tree->get_if<node::Message>(before) || tree->get_if<node::Text>(before));
}

bool follows_report(const Element& element, const Diagnostics& diagnostics) {
    const bool value = element.kind == Element::Kind::value || element.kind == Element::Kind::entry;
    if (!value || diagnostics.count() == 0) return false;
    const auto [fault, place] = diagnostics.last();
    constexpr std::uint32_t separator = 2;  // a comma and a blank
    return fault == Fault::semicolon && place.source == element.span.source &&
           place.last <= element.span.first && element.span.first - place.last <= separator;
}

}  // namespace candelabra

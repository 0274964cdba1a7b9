// SPDX-License-Identifier: GPL-3.0-or-later
// The fast path to numbers. Literals and names are read directly; other expressions run as the
// programs that compiler.cpp makes of them. Expressions with anything to report are left to
// walk_expression().
#include "interpret/expressions.h"
#include "text/message.h"
#include "vocabulary/reserved.h"

#include <algorithm>

namespace candelabra {

bool Expressions::compute(const Tree& tree, NodeId id, Numbers& result) {
    const NodeContent& content = tree[id].content;
    if (const auto* name = std::get_if<node::Name>(&content)) {
        context_.note_use(name->name, tree, id);
        const Value* found = context_.scope.find(name->name);
        const Numbers* numbers = found ? found->numbers() : nullptr;
        if (numbers) result = *numbers;
        return numbers != nullptr;
    }
    if (const auto* number = std::get_if<node::Number>(&content)) {
        result = Numbers::scalar(tree.numbers[number->number]);
        return true;
    }
    if (codes_.excluded(tree, id)) return false;
    for (Code* code = codes_.find(tree, id); code; code = code->other.get())
        if (load(*code)) return run(*code, result);
    if (!codes_.wanted(tree, id)) return false;
    Code* const code = compile(tree, id);
    return code && load(*code) && run(*code, result);
}

std::optional<double> Expressions::compute_scalar(const Tree& tree, NodeId id) {
    Numbers result;
    if (!compute(tree, id, result) || !result.is_scalar()) return std::nullopt;
    return result.at[0];
}

/// Loads the names into the registers. False if their kinds are not those that the code is for.
bool Expressions::load(Code& code) const {
    double* const registers = code.registers.data();
    for (const Code::Input& input : code.inputs) {
        const Value* found = context_.scope.find(input.name);
        const Numbers* numbers = found ? found->numbers() : nullptr;
        if (!numbers || numbers->count != input.count) return false;
        registers[input.first] = numbers->at[0];
        for (std::size_t i = 1; i < input.count; ++i) registers[input.first + i] = numbers->at[i];
    }
    for (const Code::Callee& callee : code.callees) {
        const Value* found = context_.scope.find(callee.name);
        if (!found || found->shared_place() != callee.function) return false;
    }
    return true;
}

bool Expressions::run(Code& code, Numbers& result) {
    const std::size_t begin = code.random ? context_.world.random.begin_attempt() : 0;
    std::uint32_t passes = 0;
    const bool good = execute(code.program, code.registers.data(), passes);
    context_.costs.work += code.cost;  // loops count their passes themselves
    if (!good) {
        if (code.random) context_.world.random.take_back(begin);
        return false;
    }
    const double* const registers = code.registers.data();
    result = Numbers::scalar(registers[code.program.result[0]]);
    result.count = static_cast<int>(code.program.results);
    for (std::size_t i = 1; i < code.program.results; ++i)
        result.at[i] = registers[code.program.result[i]];
    return true;
}

namespace {

/// Help for a scene that uses a word like `x` as a name of its own.
std::string about_axis(const Tree& tree, NodeId id) {
    while (const auto* group = tree.get_if<node::Group>(id)) id = group->content;
    const auto* binary = tree.get_if<node::Binary>(id);
    for (const NodeId side : {binary ? binary->left : id, binary ? binary->right : id}) {
        const auto* constant = tree.get_if<node::Constant>(side);
        for (const auto& [axis, help] :
             {std::pair{"x"_word, "`x` is the vector <1, 0, 0>; `X` may be a name"},
              std::pair{"y"_word, "`y` is the vector <0, 1, 0>; `Y` may be a name"},
              std::pair{"z"_word, "`z` is the vector <0, 0, 1>; `Z` may be a name"}})
            if (constant && constant->word == axis) return help;
    }
    return {};
}

}  // namespace

std::optional<double> Expressions::number_or(const Tree& tree, NodeId id, Value& other) {
    if (const auto* name = tree.get_if<node::Name>(id)) {
        context_.note_use(name->name, tree, id);
        const Value* found = context_.scope.find(name->name);
        const Numbers* known = found ? found->numbers() : nullptr;
        if (known && known->is_scalar()) return known->at[0];
    }
    Numbers numbers;
    const bool computed = compute(tree, id, numbers);
    if (computed && numbers.is_scalar()) return numbers.at[0];
    other = computed ? Value(numbers) : walk_expression(tree, id);
    return std::nullopt;
}

std::optional<double> Expressions::number(const Tree& tree, NodeId id, std::string_view what,
                                          NameId word) {
    Value other = Absence::nothing;
    if (const auto found = number_or(tree, id, other)) return found;
    return number_in(other, tree, id, what, word);
}

std::optional<double> Expressions::number_in(const Value& value, const Tree& tree, NodeId id,
                                             std::string_view what, NameId word) {
    if (const Numbers* found = value.numbers(); found && found->is_scalar()) return found->at[0];
    const std::string named =
        word == no_name ? std::string() : message(" `", context_.names.spelling(word), "`");
    if (value.broken()) return std::nullopt;
    context_.report(error(Fault::wrong_type, tree.span(id),
                          message(what, named, " must be a number, but it is ", kind_name(value)))
                        .with_help(about_axis(tree, id)));
    return std::nullopt;
}

}  // namespace candelabra

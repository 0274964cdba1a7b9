// SPDX-License-Identifier: GPL-3.0-or-later
// The fast way to numbers: literals and names are read, other expressions run as the programs that
// compile.cpp makes of them. Whatever has to be reported is left to walk_expression().
#include "evaluate/state.h"

#include <algorithm>

bool Evaluator::State::compute(const Tree& tree, NodeId id, Numbers& result) {
    const NodeContent& content = tree[id].content;
    if (const auto* name = std::get_if<node::Name>(&content)) {
        note_use(name->name, tree, id);
        const Value* found = scope.find(name->name);
        const Numbers* numbers = found ? found->numbers() : nullptr;
        if (numbers) result = *numbers;
        return numbers != nullptr;
    }
    if (const auto* number = std::get_if<node::Number>(&content)) {
        result = Numbers::scalar(tree.numbers[number->number]);
        return true;
    }
    if (codes.excluded(tree, id)) return false;
    for (Code* code = codes.find(tree, id); code; code = code->other.get())
        if (load(*code)) return run(*code, result);
    if (!codes.wanted(tree, id)) return false;
    Code* const code = compile(tree, id);
    return code && load(*code) && run(*code, result);
}

std::optional<double> Evaluator::State::compute_scalar(const Tree& tree, NodeId id) {
    Numbers result;
    if (!compute(tree, id, result) || !result.is_scalar()) return std::nullopt;
    return result.at[0];
}

/// Whether the names are of the kinds that the code is for; then they are in its registers.
bool Evaluator::State::load(Code& code) const {
    double* const registers = code.registers.data();
    for (const Code::Input& input : code.inputs) {
        const Value* found = scope.find(input.name);
        const Numbers* numbers = found ? found->numbers() : nullptr;
        if (!numbers || numbers->count != input.count) return false;
        registers[input.first] = numbers->at[0];
        for (std::size_t i = 1; i < input.count; ++i) registers[input.first + i] = numbers->at[i];
    }
    for (const Code::Callee& callee : code.callees) {
        const Value* found = scope.find(callee.name);
        if (!found || found->shared_place() != callee.function) return false;
    }
    return true;
}

bool Evaluator::State::run(Code& code, Numbers& result) {
    const std::size_t begin = code.random ? world.random.begin_attempt() : 0;
    if (!execute(code.program, code.registers.data())) {
        if (code.random) world.random.take_back(begin);
        return false;
    }
    const double* const registers = code.registers.data();
    result = Numbers::scalar(registers[code.program.result[0]]);
    result.count = static_cast<int>(code.program.results);
    for (std::size_t i = 1; i < code.program.results; ++i)
        result.at[i] = registers[code.program.result[i]];
    return true;
}

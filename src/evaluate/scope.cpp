// SPDX-License-Identifier: GPL-3.0-or-later
#include "evaluate/scope.h"

const Value* Scope::element(const Reference& reference) {
    const ArrayData* array = reference.cell->array();
    const auto i = static_cast<std::size_t>(reference.element);
    return array && i < array->elements.size() ? &array->elements[i] : nullptr;
}

Value* Scope::edit(NameId name) {
    const Reference found = reference(name);
    if (!found.cell || found.element < 0) return found.cell;
    return element(found)
               ? &found.cell->edit_array().elements[static_cast<std::size_t>(found.element)]
               : nullptr;
}

Scope::Reference Scope::reference(NameId name) const {
    return static_cast<std::size_t>(name) < slots_.size()
               ? slots_[static_cast<std::size_t>(name)].reference
               : Reference();
}

Scope::Slot& Scope::slot(NameId name) {
    const auto i = static_cast<std::size_t>(name);
    if (i >= slots_.size()) slots_.resize(i + i / 2 + 64);
    return slots_[i];
}

Value* Scope::new_cell(Value value) {
    if (free_cells_.empty()) return &cells_.emplace_back(std::move(value));
    Value* const cell = free_cells_.back();
    free_cells_.pop_back();
    *cell = std::move(value);
    return cell;
}

/// A fresh binding of the current frame over whatever the name stood for.
Scope::Slot& Scope::bind(NameId name) {
    Slot& top = slot(name);
    if (!frames_.empty()) hidden_.push_back({name, top});
    top = {{}, static_cast<std::uint32_t>(frames_.size()), false};
    return top;
}

void Scope::declare(NameId name, Value value) {
    if (Value* cell = edit(name)) {
        *cell = std::move(value);
        return;
    }
    slot(name) = {{new_cell(std::move(value)), -1}, 0, false};
}

void Scope::declare_local(NameId name, Value value) {
    Slot& top = slot(name);
    if (top.reference.cell && top.frame == frames_.size()) {
        if (Value* cell = edit(name)) *cell = std::move(value);
        return;
    }
    Value* const cell = new_cell(std::move(value));
    bind(name).reference = {cell, -1};
}

void Scope::bind_parameter(NameId name, Value value) {
    Value* const cell = new_cell(std::move(value));
    bind(name).reference = {cell, -1};
}

void Scope::alias(NameId name, Reference reference) {
    Slot& top = bind(name);
    top.reference = reference;
    top.alias = true;
}

void Scope::restore(Hidden& hidden) {
    Slot& top = slot(hidden.name);
    if (top.reference.cell && !top.alias) {
        *top.reference.cell = Absence::nothing;
        free_cells_.push_back(top.reference.cell);
    }
    top = hidden.slot;
}

bool Scope::undefine(NameId name) {
    Slot& top = slot(name);
    if (!top.reference.cell) return false;
    if (top.frame == 0) {
        // The cell stays: a parameter may refer to it.
        top = {};
        return true;
    }
    for (std::size_t i = hidden_.size(); i-- > 0;) {
        if (hidden_[i].name != name) continue;
        const Slot below = hidden_[i].slot;
        hidden_.erase(hidden_.begin() + static_cast<std::ptrdiff_t>(i));
        for (std::size_t& frame : frames_) frame -= frame > i;
        slots_[static_cast<std::size_t>(name)] = below;
        break;
    }
    return true;
}

void Scope::leave() {
    for (const std::size_t first = frames_.back(); hidden_.size() > first; hidden_.pop_back())
        restore(hidden_.back());
    frames_.pop_back();
}

std::vector<NameId> Scope::names() const {
    std::vector<NameId> result;
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (slots_[i].reference.cell) result.push_back(NameId(i));
    return result;
}

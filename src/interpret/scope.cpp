// SPDX-License-Identifier: GPL-3.0-or-later
#include "interpret/scope.h"

#include "interpret/array_data.h"

#include <algorithm>

namespace candelabra {

namespace {

Value element_of(const Scope::Reference& origin) {
    const ArrayData* array = origin.cell->array();
    const auto i = static_cast<std::size_t>(origin.element);
    return array && i < array->size() ? array->at(i) : Value(Absence::uninitialised);
}

}  // namespace

void Scope::learn(NameId whole, NameId name, bool global) {
    slot(whole).kind = Kind::scoped;
    scoped_[whole] = {name, global};
}

const Value* Scope::find_scoped(NameId name) const {
    const auto& [other, global] = scoped_.at(name);
    if (!global) return is_local(other) ? find(other) : nullptr;
    // The first binding that was ever hidden is the outermost.
    const auto first = std::ranges::find(hidden_, other, &Hidden::name);
    return first == hidden_.end() ? find(other) : first->slot.cell;
}

Scope::Slot& Scope::global_slot(NameId name) {
    const auto first = std::ranges::find(hidden_, name, &Hidden::name);
    return first == hidden_.end() ? slot(name) : first->slot;
}

void Scope::declare_global(NameId name, Value value) {
    Slot& place = global_slot(name);
    if (place.cell)
        *place.cell = std::move(value);
    else
        place = {new_cell(std::move(value)), 0, Kind::own};
    edited();
}

Value* Scope::edit(NameId name) {
    if (const Scoped* other = scoped(name)) {
        if (other->global) return global_slot(other->name).cell;
        return is_local(other->name) ? edit(other->name) : nullptr;
    }
    Slot& top = slot(name);
    if (top.kind != Kind::element) return top.cell;
    const Reference origin = element(name).origin;
    // Without the copy, an array in the element is not shared and is edited in place.
    if (top.cell->array()) *top.cell = Absence::uninitialised;
    Value* inner = origin.cell->array()
                       ? origin.cell->edit_array().inner(static_cast<std::size_t>(origin.element))
                       : nullptr;
    return inner ? inner : top.cell;
}

Scope::Reference Scope::reference(NameId name) const {
    const Value* const found = find(name);
    if (!found) return {};
    if (const Scoped* other = scoped(name))
        return other->global ? Reference{const_cast<Value*>(found), -1} : reference(other->name);
    const Slot& top = slots_[static_cast<std::size_t>(name)];
    return top.kind == Kind::element ? element(name).origin : Reference{top.cell, -1};
}

/// The element that a name's newest binding refers to. Precondition: it refers to one.
const Scope::Element& Scope::element(NameId name) const {
    return *std::find_if(elements_.rbegin(), elements_.rend(),
                         [&](const Element& element) { return element.name == name; });
}

void Scope::refresh() {
    for (const Element& element : elements_) *element.copy = element_of(element.origin);
}

void Scope::make_slots(NameId name) {
    const auto i = static_cast<std::size_t>(name);
    slots_.resize(i + i / 2 + 64);
}

Value* Scope::new_cell(Value value) {
    Value* const cell = fresh_cell();
    *cell = std::move(value);
    return cell;
}

/// Changes the value of a bound name.
void Scope::change(NameId name, Value value) {
    const Slot& top = slot(name);
    if (top.kind == Kind::element) {
        const Reference origin = element(name).origin;
        const auto i = static_cast<std::size_t>(origin.element);
        if (origin.cell->array() && i < origin.cell->array()->size())
            origin.cell->edit_array().set(i, std::move(value));
    } else {
        *top.cell = std::move(value);
    }
    edited();
}

void Scope::declare(NameId name, Value value) {
    if (const Scoped* other = scoped(name))
        return other->global ? declare_global(other->name, std::move(value))
                             : declare_local(other->name, std::move(value));
    if (slot(name).cell) return change(name, std::move(value));
    slot(name) = {new_cell(std::move(value)), 0, Kind::own};
}

void Scope::declare_local(NameId name, Value value) {
    if (scoped(name)) return declare(name, std::move(value));
    const Slot& top = slot(name);
    if (top.cell && top.frame == frames_.size()) return change(name, std::move(value));
    bind(name, new_cell(std::move(value)), Kind::own);
}

void Scope::bind_parameter(NameId name, Value* fresh) { bind(name, fresh, Kind::own); }

void Scope::alias(NameId name, Reference reference) {
    if (reference.element < 0) {
        bind(name, reference.cell, Kind::alias);
        return;
    }
    Value* const copy = new_cell(element_of(reference));
    bind(name, copy, Kind::element);
    elements_.push_back({name, reference, copy});
}

/// Releases a binding. The caller restores the one below it.
void Scope::drop(NameId name, const Slot& slot) {
    if (!slot.cell || slot.kind == Kind::alias) return;
    if (slot.kind == Kind::element)
        elements_.erase(elements_.begin() + (&element(name) - elements_.data()));
    give_back(slot.cell);
}

bool Scope::undefine(NameId name) {
    if (const Scoped* other = scoped(name)) {
        if (!find(name)) return false;
        if (!other->global) return undefine(other->name);
        global_slot(other->name) = {};
        return true;
    }
    Slot& top = slot(name);
    if (!top.cell) return false;
    if (top.kind == Kind::element) drop(name, top);
    // Other cells stay: a parameter may refer to them.
    if (top.frame == 0) {
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
    for (const std::size_t first = frames_.back(); hidden_.size() > first; hidden_.pop_back()) {
        const Hidden& hidden = hidden_.back();
        Slot& top = slots_[static_cast<std::size_t>(hidden.name)];
        drop(hidden.name, top);
        top = hidden.slot;
    }
    frames_.pop_back();
}

std::vector<NameId> Scope::names() const {
    std::vector<NameId> result;
    for (std::size_t i = 0; i < slots_.size(); ++i)
        if (slots_[i].cell) result.push_back(NameId(i));
    return result;
}

}  // namespace candelabra

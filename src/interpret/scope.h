// SPDX-License-Identifier: GPL-3.0-or-later
// The bindings of names. Scoping is dynamic, as in POV-Ray: each open macro call and include file
// has a frame, and a look-up finds the newest binding. Each name holds its newest binding directly,
// so a look-up is one load. A frame records the bindings that its own ones hid, and restores them
// when it is left.
#pragma once

#include "interpret/value.h"
#include "vocabulary/words.h"

#include <cstdint>
#include <deque>
#include <unordered_map>
#include <vector>

namespace candelabra {

class Scope {
public:
    /// The place of a value: a variable, or an element of an array variable. Parameters by
    /// reference hold one.
    struct Reference {
        Value* cell = nullptr;
        std::int64_t element = -1;
    };

    /// The value of the newest binding, or null.
    const Value* find(NameId name) const {
        const auto i = static_cast<std::size_t>(name);
        if (i >= slots_.size()) return nullptr;
        const Slot& top = slots_[i];
        return top.cell || top.kind != Kind::scoped ? top.cell : find_scoped(name);
    }
    /// Makes `whole` a name of what `name` is bound to in the innermost frame, or, if `global`, in
    /// the outermost. All else that is done to `whole` is done to that binding.
    void learn(NameId whole, NameId name, bool global);
    /// The value of the newest binding, for changing it if it is an array; or null. edited() must
    /// follow.
    Value* edit(NameId name);
    void edited() {
        if (!elements_.empty()) refresh();
    }
    /// The numbers that a `#declare` or `#local` of numbers may overwrite in place. If null,
    /// declare() or declare_local() must be called.
    Numbers* overwritable(NameId name, bool local) {
        Value* const cell = own_cell(name, local);
        return cell ? cell->edit_numbers() : nullptr;
    }
    /// The same for a string.
    Value* overwritable_text(NameId name, bool local) {
        Value* const cell = own_cell(name, local);
        return cell && cell->text() ? cell : nullptr;
    }

    /// Whether the newest binding belongs to the current frame.
    bool is_local(NameId name) const {
        if (const Scoped* other = scoped(name))
            return other->global ? frames_.empty() : is_local(other->name);
        return find(name) && slots_[static_cast<std::size_t>(name)].frame == frames_.size();
    }
    /// The place of a name's value, for passing it on. Its cell is null for an undeclared name.
    Reference reference(NameId name) const;

    /// `#declare`: changes the newest binding, or makes a global one.
    void declare(NameId name, Value value);
    /// `#local`: changes the binding of this frame, or makes one.
    void declare_local(NameId name, Value value);
    /// A cell for a parameter by value, to be bound in a fresh frame or given back.
    Value* fresh_cell() {
        if (free_cells_.empty()) return &cells_.emplace_back(Absence::nothing);
        Value* const cell = free_cells_.back();
        free_cells_.pop_back();
        return cell;
    }
    void bind_parameter(NameId name, Value* fresh);
    void give_back(Value* fresh) {
        // Numbers own nothing to free, and the next value often is numbers.
        if (!fresh->numbers()) *fresh = Absence::nothing;
        free_cells_.push_back(fresh);
    }
    /// `#local` of numbers for a name without a binding in this frame.
    void declare_fresh_local(NameId name, const Numbers& numbers) {
        Value* const cell = fresh_cell();
        *cell = numbers;
        bind(name, cell, Kind::own);
    }
    /// Binds a parameter by reference: another name for the place. The frame must be fresh.
    void alias(NameId name, Reference);
    /// `#undef`: removes the newest binding. False if there was none.
    bool undefine(NameId name);

    void enter() { frames_.push_back(hidden_.size()); }
    void leave();
    std::size_t depth() const { return frames_.size(); }

    /// All names that have a binding.
    std::vector<NameId> names() const;

private:
    enum class Kind : std::uint8_t {
        own,      ///< the cell belongs to the binding
        alias,    ///< the cell belongs to another binding
        element,  ///< the cell is a copy of an element of an array: see elements_
        scoped,   ///< never bound itself: see scoped_
    };
    struct Scoped {
        NameId name;
        bool global;
    };
    struct Slot {
        Value* cell = nullptr;
        std::uint32_t frame = 0;  ///< 0: global
        Kind kind = Kind::own;
    };
    struct Hidden {
        NameId name;
        Slot slot;
    };
    /// A name for an element of an array. Elements may be packed, so there is no value to point to:
    /// the name has a copy, which is updated at every change of the array.
    struct Element {
        NameId name;
        Reference origin;
        Value* copy;
    };

    /// The cell that a declaration of the name changes, if it is not a copy of an element.
    Value* own_cell(NameId name, bool local) {
        const auto i = static_cast<std::size_t>(name);
        if (i >= slots_.size()) return nullptr;
        const Slot& top = slots_[i];
        const bool other = top.kind == Kind::element || (local && top.frame != frames_.size());
        return other ? nullptr : top.cell;
    }
    Slot& slot(NameId name) {
        if (static_cast<std::size_t>(name) >= slots_.size()) make_slots(name);
        return slots_[static_cast<std::size_t>(name)];
    }
    void make_slots(NameId name);
    /// Binds the name in the current frame, over its previous binding.
    void bind(NameId name, Value* cell, Kind kind) {
        Slot& top = slot(name);
        if (!frames_.empty()) hidden_.push_back({name, top});
        top = {cell, static_cast<std::uint32_t>(frames_.size()), kind};
    }
    /// What a name of learn() stands for; null for other names.
    const Scoped* scoped(NameId name) const {
        const auto i = static_cast<std::size_t>(name);
        const bool is_one = i < slots_.size() && slots_[i].kind == Kind::scoped;
        return is_one ? &scoped_.at(name) : nullptr;
    }
    const Value* find_scoped(NameId name) const;
    /// The slot of the outermost binding.
    Slot& global_slot(NameId name);
    void declare_global(NameId name, Value value);
    Value* new_cell(Value value);
    void change(NameId name, Value value);
    const Element& element(NameId name) const;
    void refresh();
    void drop(NameId name, const Slot&);

    std::vector<Slot> slots_;  ///< by name
    std::unordered_map<NameId, Scoped> scoped_;
    std::vector<Hidden> hidden_;
    std::vector<std::size_t> frames_;  ///< where in hidden_ each begins
    std::vector<Element> elements_;
    std::deque<Value> cells_;
    std::vector<Value*> free_cells_;
};

}  // namespace candelabra

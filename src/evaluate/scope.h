// SPDX-License-Identifier: GPL-3.0-or-later
// What names stand for. Scoping is POV-Ray's, dynamic: a frame for each macro call and each include
// file that is open, and a look-up finds the newest. Each name holds its newest binding directly,
// so a look-up is one load; a frame remembers what its bindings hid and puts it back when it is
// left.
#pragma once

#include "evaluate/value.h"
#include "vocabulary/words.h"

#include <cstdint>
#include <deque>
#include <vector>

class Scope {
public:
    /// Where a value lies: a variable, or an element of an array that is one. What parameters by
    /// reference hold.
    struct Reference {
        Value* cell = nullptr;
        std::int64_t element = -1;
    };

    /// The value of the newest binding, or null.
    const Value* find(NameId name) const {
        if (static_cast<std::size_t>(name) >= slots_.size()) return nullptr;
        const Slot& slot = slots_[static_cast<std::size_t>(name)];
        return slot.reference.element < 0 ? slot.reference.cell : element(slot.reference);
    }
    /// The same for writing.
    Value* edit(NameId name);

    /// The place behind a name, for passing it on; its cell is null when the name is not declared.
    Reference reference(NameId name) const;

    /// `#declare`: changes the newest binding, or makes a global one.
    void declare(NameId name, Value value);
    /// `#local`: changes the binding of this frame, or makes one.
    void declare_local(NameId name, Value value);
    /// A parameter by value, in a fresh frame.
    void bind_parameter(NameId name, Value value);
    /// A parameter by reference: another name for what is there. The frame must be fresh.
    void alias(NameId name, Reference);
    /// `#undef`: takes the newest binding away. False if there was none.
    bool undefine(NameId name);

    void enter() { frames_.push_back(hidden_.size()); }
    void leave();
    std::size_t depth() const { return frames_.size(); }

    /// All names that have a binding.
    std::vector<NameId> names() const;

private:
    struct Slot {
        Reference reference;
        std::uint32_t frame = 0;  ///< 0: global
        bool alias = false;
    };
    struct Hidden {
        NameId name;
        Slot slot;
    };

    static const Value* element(const Reference&);
    Slot& slot(NameId name);
    Slot& bind(NameId name);
    Value* new_cell(Value value);
    void restore(Hidden&);

    std::vector<Slot> slots_;  ///< by name
    std::vector<Hidden> hidden_;
    std::vector<std::size_t> frames_;  ///< where in hidden_ each begins
    std::deque<Value> cells_;
    std::vector<Value*> free_cells_;
};

// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the evaluator that makes functions and macros, and calls them. Internal to the
// evaluator.
#pragma once

#include "formula/formula.h"
#include "interpret/context.h"
#include "interpret/macro.h"
#include "interpret/sink.h"
#include "interpret/statements.h"

#include <cstddef>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace candelabra {

class Calls {
public:
    explicit Calls(Context& context) : context_(context) {}

    // ---- call.cpp
    /// The value of a call: of a function, a spline or a macro.
    Value call(const Tree&, const node::Call&, NodeId);
    bool defined(const Tree&, NodeId target);
    /// Whether the name, in a call, stands for a function or a spline, not for a macro.
    bool is_function(NameId) const;
    /// A call of a function or a spline; `name` is for messages.
    Value call_value(const Tree&, const Value& called, NameId name, NodeId first, Span);

    // ---- user_function.cpp
    Value function(const Tree&, const node::Function&, NodeId);
    /// Whether a function may be called with that many arguments_; if not, reports.
    bool check_count(NameId function, std::size_t count, const Formula&, Span);

    // ---- macro.cpp
    void define_macro(const Tree&, const node::Macro&, NodeId);
    /// Runs a macro; its elements go to `take`.
    Flow call_macro(const Tree&, const node::Call&, NodeId, const Sink& take);
    /// The node if it calls a macro; null for other nodes.
    const node::Call* macro_call(const Tree&, NodeId) const;

private:
    Value call_function(const Tree&, const node::Call&, NodeId);
    void receive(const Tree&, NodeId first, int count, const Value&);
    void walk_arguments(const Tree&, NodeId first, FunctionRef<void(Value, Span)> take);

    std::optional<std::vector<NameId>> parameters(const Tree&, const node::Function&, NodeId);
    bool take_size(const Tree&, const node::Function&, Formula&);
    Handle<Formula> written_function(const Tree&, const node::Function&, NodeId);
    Handle<Formula> named_function(const Tree&, const node::Function&, NodeId);
    bool may_give_block(const Tree&, NodeId first, int depth = 0) const;
    Handle<Formula> block_function(const Tree&, NodeId body, NodeId);
    Handle<Formula> element_formula(const Element&);
    Value call_formula(const Tree&, Handle<Formula>, NameId, NodeId first, Span);
    Value call_spline(const Tree&, Handle<Spline>, NameId, NodeId first, Span);

    /// Opens a call: its parameters are bound until leave_macro(). Returns null, with nothing to
    /// leave, after a report.
    const MacroData* enter_macro(const Tree&, const node::Call&, NodeId);
    void leave_macro();
    /// The macro that is called, or null after a report.
    const MacroData* called_macro(const Tree&, const node::Call&, NodeId);
    struct Argument {
        Scope::Reference place;
        bool by_value = false;  ///< the cell is a fresh one
        bool omitted = false;   ///< the parameter stays undeclared
        Span given;             ///< where it stands in the call
    };
    /// Puts a value into a cell of its own. Returns false if the value is broken.
    template <class Given>
    bool by_value(Given&& value, Argument& result) {
        result.by_value = true;
        result.place.cell = context_.scope.fresh_cell();
        *result.place.cell = std::forward<Given>(value);
        return !result.place.cell->broken();
    }
    bool pass_values(const Tree&, const node::Call& inner, NodeId);
    /// Computes the arguments_ and appends them to `arguments`. Returns false after a report.
    bool pass_arguments(const Tree&, const node::Call&, NodeId, const MacroData&);
    /// Whether the arguments_ from `base` on, bound to the parameters of the macro that is being
    /// entered, are what these accept. Each that is not is reported.
    bool keeps_contracts(const MacroData&, std::size_t base);
    /// The bounds of a parameter as numbers. Nothing after a report, or if a bound is an argument
    /// that was refused (then not all are `kept`).
    std::optional<std::vector<MacroContract::Limit>> limits_of(const MacroData::Parameter&,
                                                               const Tree&, bool kept);
    void report_arguments(const MacroData&, std::size_t count, const Tree&, NodeId call);
    bool gives_nothing(const Tree&, NodeId);
    bool pass_argument(const Tree&, NodeId, const MacroData&, std::size_t place, Argument&);
    bool argument(const Tree&, NodeId, Argument&);
    bool argument_element(const Tree&, const node::Index&, NodeId, Argument&);

    Context& context_;
    std::map<std::pair<SourceId, NodeId>, MacroData> macros_;  ///< by place of definition
    std::vector<Argument> arguments_;                          ///< of the calls that are being made
};

}  // namespace candelabra

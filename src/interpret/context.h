// SPDX-License-Identifier: GPL-3.0-or-later
// The state that the parts of the evaluator share. Each part knows the others by the context alone,
// and includes the headers of those that it calls. Internal to the evaluator. The parts:
//   - Expressions: values (compute, expression, chain, colours, array, texts)
//   - Calls: functions and macros (call, user_function, macro)
//   - Statements: walks over lists, and directives (walk, directive, declare)
//   - DataFiles: #fopen, #fclose, #read, #write (files)
#pragma once

#include "interpret/costs.h"
#include "interpret/evaluator.h"
#include "interpret/file_trees.h"
#include "interpret/frames.h"
#include "interpret/functions.h"
#include "interpret/scope.h"

#include <cstdint>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace candelabra {

class Calls;
class Expressions;
class DataFiles;
class Statements;

/// The component of numbers that a member names (`.x`), grey_component, or -1 for none.
int component_of(std::string_view member);
inline constexpr int grey_component = 5;
inline constexpr auto grey_weights = std::array{0.297, 0.589, 0.114};

struct Context {
    Context(Evaluator&, SourceStore&, const Loader&, Names&, Diagnostics&, const RunFacts&);

    void add_functions(std::span<const FunctionInfo>);

    // ---- reports
    /// Reports, and stops evaluation once the limit of errors is reached.
    void report(Diagnostic diagnostic) {
        diagnostics.add(std::move(diagnostic));
        if (diagnostics.full()) stop();
    }
    /// Reports an error. The value is broken.
    Value broken(Fault, Span, std::string message);
    /// Reports that nothing is declared as this name, and what may be meant.
    Value unknown_name(NameId, Span);
    void stop() { stopped_ = true; }
    bool stopped() const { return stopped_; }
    /// Whether there is stack left to recurse further. Reports if there is not.
    bool room(const Tree& tree, NodeId id) {
        const char here = 0;
        return !stack_end || &here > stack_end || no_room(tree, id);
    }
    /// To be called where a name is used: warns if it is deprecated.
    void note_use(NameId name, const Tree& tree, NodeId id) {
        if (!deprecated.empty()) warn_deprecated(name, tree.span(id));
    }

    // ---- places in files
    bool in_library(Span) const;
    /// A place in the library as that of the scene's call that led there.
    Span outside_library(Span) const;
    /// Errors in the library are reported where the scene calls it.
    void point_at_scene(Diagnostic&) const;
    /// The folder from which a name is looked up; for a library macro, that of the scene's call.
    std::string data_folder(Span) const;
    /// The span from the word of a declaration, which may be long, to the name that it declares.
    Span heading(const Tree&, NodeId declaration, NameId) const;

    Evaluator& evaluator;
    SourceStore& sources;
    Loader loader;  ///< knows the files that this run has written
    Names& names;
    Diagnostics& diagnostics;
    RunFacts facts;
    ElementHandlers handlers;
    Costs costs{*this};
    Scope scope;
    Frames frames;
    FileTrees trees{sources, loader, names, diagnostics};
    FunctionWorld world;
    std::vector<const FunctionInfo*> functions;  ///< by name; null: none
    struct Deprecation {
        std::string text;
        bool once = false;
        std::set<std::pair<SourceId, std::uint32_t>> places;  ///< at which it has been reported
    };
    std::map<NameId, Deprecation> deprecated;
    double version = 3.7;
    bool version_given = false;
    double working_gamma = 1;  ///< of colours, set by assumed_gamma
    LightUnits light_units;
    bool light_units_used = false;  ///< a function has converted an amount of light
    std::shared_ptr<SceneNoise> noise = std::make_shared<SceneNoise>();
    Body reported;  ///< the last word that the binder has reported
    /// Receives the values in parentheses that a macro gives to `#declare (a, b) = M();`. Null if
    /// none are expected.
    std::vector<Value>* awaited_tuple = nullptr;
    /// The call that is a word of a block, before the parentheses of its value.
    Body word_call;
    const char* stack_end = nullptr;  ///< lowest address that the stack may reach; null: unlimited

    // ---- the parts
    Expressions* expressions = nullptr;
    Calls* calls = nullptr;
    Statements* statements = nullptr;
    DataFiles* files = nullptr;

private:
    bool no_room(const Tree&, NodeId);
    void warn_deprecated(NameId, Span);
    std::pair<const Tree*, NodeId> own_declaration(NameId, Span use) const;

    bool stopped_ = false;
};

}  // namespace candelabra

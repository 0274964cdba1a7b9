// SPDX-License-Identifier: GPL-3.0-or-later
// Open macros: they open braces for another macro to close, or close braces opened elsewhere:
//
//     #macro Begin(R) union { sphere { 0, R } #end
//     #macro End() } #end
//     Begin(2) box { -1, 1 } End()
//
// or hold operators that lack an operand, `#macro Half() / 2 #end`, or half a pair of parentheses.
// Their bodies are not lists of elements, so they have no place in the tree: their text replaces
// each call. The text of `#macro More() + 2 #end` does so only after a value: (1 More()). An
// argument of one token replaces its parameter. So does an argument of numbers after a value, in
// parentheses. Any other argument is declared in front, under a name of its own (R_of_Begin);
// #locals get such names as well. Files that include one another share open macros.
#pragma once

#include "syntax/token.h"
#include "syntax/tree.h"
#include "text/diagnostic.h"

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

namespace candelabra {

/// An open macro, as all files of a scene share it.
struct OpenMacro {
    NameId name;
    Token opener;  ///< #macro
    Token end;     ///< #end
    int braces;    ///< number of braces that it leaves open
    std::vector<NameId> parameters;
    std::vector<Token> body;
    Tree values = {};  ///< numbers and strings of the body; its source is the macro's file
    std::vector<NameId> declared = {}, locals = {};  ///< names by #declare, by #local
    /// The last bracket that it leaves open, or the first that it did not open. end_of_file: none.
    Token odd = {};
    bool continues = false;  ///< a whole value with a sign: open only after another value
    bool called = false;     ///< in another file
};

/// Open macros in the order of their definitions.
using OpenMacroList = std::vector<std::shared_ptr<OpenMacro>>;

/// Parses the file that `#include "name"` names, for this language version, and adds the open
/// macros that it defines. A file that cannot be read has none.
using IncludeReader =
    std::function<void(const std::string& name, Span, double version, OpenMacroList&)>;

class OpenMacros {
public:
    /// `known`: open macros known at the start of this file and, in the end, after it. Without a
    /// reader, included files add none.
    OpenMacros(Names& names, Tree& tree, Diagnostics& diagnostics, OpenMacroList& known,
               IncludeReader reader)
        : names_(names),
          tree_(tree),
          diagnostics_(diagnostics),
          known_(known),
          reader_(std::move(reader)) {
        learn_known();
    }

    using Tokens = std::vector<Token>;

    /// Help messages for an unmatched brace of a macro.
    static constexpr const char* unclosed =
        "add the missing `}`; or let another macro, defined outside of directives as this one is, "
        "close it: #macro End() } #end";
    static constexpr const char* unopened =
        "leave it out; or let another macro, defined outside of directives as this one is, open "
        "it: #macro Begin() union { #end";

    struct Macro {
        std::shared_ptr<OpenMacro> shared;
        Tokens body;                            ///< with this file's numbers and strings
        std::vector<std::uint32_t> calls = {};  ///< offsets of its calls in this file
    };

    bool empty() const { return macros_.empty(); }
    /// Takes the tokens from #macro to #end. Returns false if the body is a list of elements or
    /// they are not a macro: then it is not open, or open only where it is called after a value.
    bool define(const Tokens& macro);
    /// Learns the open macros of a file, at #include and this string.
    void include(const Token& file, double version);
    /// The open macro that a call expands after a token of kind `before`, or null.
    Macro* find(NameId name, TokenKind before);
    /// Returns the tokens that replace a call. `arguments` include their parentheses. A wrong
    /// number of arguments is reported.
    Tokens expand(Macro&, const Token& call, std::span<const Token> arguments);

    /// Whether an unmatched brace belongs to a macro. If so, the macro is reported, once.
    bool blame(const Token& brace);
    /// If the calls so far have opened more braces than they closed, reports the macros at fault.
    /// Returns whether any of them had not been reported before.
    bool blame_all();
    /// Whether a macro of this file was called before it was known to be open.
    bool called_too_early() const;
    /// Reports the macros of this file that were never called: the bracket that they leave open may
    /// be an oversight.
    void report_idle();

private:
    /// Returns false if the macro has been reported before.
    bool report(const OpenMacro&);
    using Instead = std::unordered_map<NameId, Tokens>;

    void learn_known();
    void learn(const std::shared_ptr<OpenMacro>&);
    void forget(NameId);
    bool is_own(const OpenMacro& macro) const { return macro.values.source == tree_.source; }
    bool may_stand_in_parentheses(std::span<const Token> value, const OpenMacro&, NameId) const;
    /// Returns the tokens that replace names of a body, and adds declarations that they need to
    /// `result`.
    Instead bind(const OpenMacro&, const Token& call,
                 const std::vector<std::span<const Token>>& values, Tokens& result);
    Span span(const Token& token) const { return {tree_.source, token.first, token.last}; }

    Names& names_;
    Tree& tree_;
    Diagnostics& diagnostics_;
    OpenMacroList& known_;
    IncludeReader reader_;
    std::vector<Macro> macros_;                        ///< all that were ever known
    std::unordered_map<NameId, std::size_t> by_name_;  ///< index of the last macro of each name
    /// Where each name was first defined as a list of elements outside of directives.
    std::unordered_map<NameId, std::uint32_t> closed_;
    /// Reported places: the same macro may be known from the previous parse of the file.
    std::vector<Span> told_;
};

}  // namespace candelabra

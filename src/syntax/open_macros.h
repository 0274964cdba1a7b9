// SPDX-License-Identifier: GPL-3.0-or-later
// Macros that open braces for another one to close, or close what they have not opened:
//
//     #macro Begin(R) union { sphere { 0, R } #end
//     #macro End() } #end
//     Begin(2) box { -1, 1 } End()
//
// and those that hold operators without their operands, `#macro Half() / 2 #end`, or half a pair of
// parentheses. They are no lists of elements, so they have no place in the tree: their text stands
// where they are called; that of `#macro More() + 2 #end` only behind a value: (1 More()). An
// argument of one token stands where its parameter does, and so does one of numbers behind a value,
// in parentheses; any other is declared in front, by a name of its own (R_of_Begin), which #locals
// get as well. Files that include one another share them.
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

/// What any file of a scene has to know of an open macro.
struct OpenMacro {
    NameId name;
    Token opener;  ///< #macro
    Token end;     ///< #end
    int braces;    ///< how many it leaves open
    std::vector<NameId> parameters;
    std::vector<Token> body;
    Tree values = {};  ///< where the numbers and strings of the body lie; its source is the file's
    std::vector<NameId> declared = {}, locals = {};  ///< by #declare and by #local
    /// The last brace that it leaves open, or the first that it did not open; or nothing.
    Token odd = {};
    bool continues = false;  ///< a whole value with a sign: open only behind another value
    bool called = false;     ///< in another file
};

/// In the order in which they were defined.
using OpenMacroList = std::vector<std::shared_ptr<OpenMacro>>;

/// Parses what `#include "name"` names, for a language of that version, and adds the open macros
/// that it defines; a file that cannot be read has none.
using IncludeReader =
    std::function<void(const std::string& name, Span, double version, OpenMacroList&)>;

class OpenMacros {
public:
    /// `known`: by this file, from its beginning and, in the end, behind it. No reader: only its
    /// own.
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

    /// For messages: the way out for a brace of a macro that does not match.
    static constexpr const char* unclosed =
        "add the missing `}`; or let another macro, defined outside of directives as this one is, "
        "close it: #macro End() } #end";
    static constexpr const char* unopened =
        "leave it out; or let another macro, defined outside of directives as this one is, open "
        "it: #macro Begin() union { #end";

    struct Macro {
        std::shared_ptr<OpenMacro> shared;
        Tokens body;                            ///< with this file's numbers and strings
        std::vector<std::uint32_t> calls = {};  ///< where it is called in this file
    };

    bool empty() const { return macros_.empty(); }
    /// From #macro to its #end. False when it is a list of elements, or not written as a macro is:
    /// then it is none of these, or only where it is called behind a value.
    bool define(const Tokens& macro);
    /// At #include and this string.
    void include(const Token& file, double version);
    /// The macro that a call is replaced for, which comes behind a token of this kind.
    Macro* find(NameId name, TokenKind before);
    /// What stands for a call; `arguments` with their parentheses. A wrong number of them is
    /// reported.
    Tokens expand(Macro&, const Token& call, std::span<const Token> arguments);

    /// Whether a brace that does not match is one of a macro's; then that is reported, once.
    bool blame(const Token& brace);
    /// Whether the calls up to here have opened more braces than they closed, by macros that are
    /// reported here for the first time.
    bool blame_all();
    /// Whether a macro of this file was called before it was known to be one of these.
    bool called_too_early() const;
    /// Reports the macros of this file that were never called: what they leave open may be an
    /// oversight.
    void report_idle();

private:
    /// False: it has been reported.
    bool report(const OpenMacro&);
    using Instead = std::unordered_map<NameId, Tokens>;

    void learn_known();
    void learn(const std::shared_ptr<OpenMacro>&);
    void forget(NameId);
    bool is_own(const OpenMacro& macro) const { return macro.values.source == tree_.source; }
    bool may_stand_in_parentheses(std::span<const Token> value, const OpenMacro&, NameId) const;
    /// What stands for the names of a body; what has to be declared for it goes to the result.
    Instead bind(const OpenMacro&, const Token& call,
                 const std::vector<std::span<const Token>>& values, Tokens& result);
    Span span(const Token& token) const { return {tree_.source, token.first, token.last}; }

    Names& names_;
    Tree& tree_;
    Diagnostics& diagnostics_;
    OpenMacroList& known_;
    IncludeReader reader_;
    std::vector<Macro> macros_;                        ///< all that were ever known
    std::unordered_map<NameId, std::size_t> by_name_;  ///< the last of each name
    /// Where each name was first given to a list of elements outside of directives.
    std::unordered_map<NameId, std::uint32_t> closed_;
    /// What has been reported: the same macro may be known from the last time the file was parsed.
    std::vector<Span> told_;
};

}  // namespace candelabra

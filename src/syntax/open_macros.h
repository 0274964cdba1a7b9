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
// argument of one token stands where its parameter does; any other is declared in front, by a name
// of its own (R_of_Begin), which #locals get as well.
#pragma once

#include "syntax/token.h"
#include "text/diagnostic.h"

#include <span>
#include <unordered_map>
#include <vector>

class OpenMacros {
public:
    OpenMacros(Names& names, SourceId source, Diagnostics& diagnostics)
        : names_(names), source_(source), diagnostics_(diagnostics) {}

    using Tokens = std::vector<Token>;

    /// For messages: the way out for a brace of a macro that does not match.
    static constexpr const char* unclosed =
        "add the missing `}`; or let another macro of this file, defined outside of directives as "
        "this one is, close it: #macro End() } #end";
    static constexpr const char* unopened =
        "leave it out; or let another macro of this file, defined outside of directives as this "
        "one is, open it: #macro Begin() union { #end";

    struct Macro {
        NameId name;
        Token opener;  ///< #macro
        Token end;     ///< #end
        int braces;    ///< how many it leaves open
        std::vector<NameId> parameters;
        Tokens body;
        std::vector<NameId> declared = {}, locals = {};  ///< by #declare and by #local
        /// The last brace that it leaves open, or the first that it did not open; or nothing.
        Token odd = {};
        bool continues = false;  ///< a whole value with a sign: open only behind another value
        int calls = 0;
        bool told = false;  ///< it has been reported
    };

    bool empty() const { return macros_.empty(); }
    /// From #macro to its #end. False when it is a list of elements, or not written as a macro is:
    /// then it is none of these, or only where it is called behind a value.
    bool define(const Tokens& macro);
    /// The macro that a call is replaced for, which comes behind a token of this kind.
    Macro* find(NameId name, TokenKind before);
    /// What stands for a call; `arguments` with their parentheses. A wrong number of them is
    /// reported.
    Tokens expand(Macro&, const Token& call, std::span<const Token> arguments);

    /// Whether a brace that does not match is one of a macro's; then that is reported, once.
    bool blame(const Token& brace);
    /// Whether the calls up to here have opened more braces than they closed; then the macros that
    /// do are reported.
    bool blame_all();
    /// Reports the macros that were never called: what they leave open may be an oversight.
    void report_idle();

private:
    void report(Macro&);
    using Instead = std::unordered_map<NameId, Token>;

    /// What stands for the names of a body; what has to be declared for it goes to the result.
    Instead bind(const Macro&, const Token& call, const std::vector<std::span<const Token>>& values,
                 Tokens& result);
    Span span(const Token& token) const { return {source_, token.first, token.last}; }

    Names& names_;
    SourceId source_;
    Diagnostics& diagnostics_;
    std::vector<Macro> macros_;                        ///< in the order of the text
    std::unordered_map<NameId, std::size_t> by_name_;  ///< the last of each name
};

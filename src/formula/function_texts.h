// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of functions, for the dump of a scene. Programs do not tell how they were written, so
// the compiler of functions keeps their texts while somebody wants them.
#pragma once

#include "base/handle.h"
#include "formula/formula.h"

#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

namespace candelabra {

/// How a function is written in the language.
struct FormulaText {
    /// In a body, a number between these stands for the name of one of `called`.
    static constexpr char begin = '\1', end = '\2';

    std::string parameters;  ///< `(a, b)`; empty: x, y and z, or those that the body implies
    std::string body;        ///< within the braces
    std::vector<Handle<Formula>> called;
};

/// Keeps the texts of all functions that are made while it exists. Precondition: there is only one,
/// and one scene at a time is evaluated meanwhile. No result depends on it.
class FunctionTexts {
public:
    FunctionTexts() { current() = this; }
    FunctionTexts(const FunctionTexts&) = delete;
    FunctionTexts& operator=(const FunctionTexts&) = delete;
    ~FunctionTexts() { current() = nullptr; }

    /// Null if nobody wants texts.
    static FunctionTexts* kept() { return current(); }

    void keep(const Handle<Formula>& formula, FormulaText text) {
        known_.insert_or_assign(formula.get(), Known{formula, std::move(text)});
    }
    /// Null if it is not known.
    const FormulaText* find(const Formula* formula) const {
        const auto found = known_.find(formula);
        return found == known_.end() ? nullptr : &found->second.text;
    }

private:
    struct Known {
        Handle<Formula> formula;  ///< kept, so that no address is reused
        FormulaText text;
    };

    /// Functions are compiled through many layers that do not know of texts.
    static FunctionTexts*& current() {
        static FunctionTexts* here = nullptr;
        return here;
    }

    std::unordered_map<const Formula*, Known> known_;
};

/// The same function, whose body in the language is kept if somebody wants it.
template <class Body>
Handle<Formula> with_text(Handle<Formula> formula, Body body) {
    if (FunctionTexts* const texts = FunctionTexts::kept()) texts->keep(formula, {{}, body(), {}});
    return formula;
}

}  // namespace candelabra

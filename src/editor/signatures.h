// SPDX-License-Identifier: GPL-3.0-or-later
// The parameters of the macro or function in whose call the user is typing, and all arguments of
// calls.
#pragma once

#include "editor/workspace.h"

#include <optional>
#include <string>
#include <vector>

namespace candelabra {

struct Signature {
    std::string label;                    ///< Light_Ring(Lamp, Count, Radius)
    std::vector<std::string> parameters;  ///< parts of the label
    std::size_t active = 0;               ///< index of the argument at the place, from 0
    std::string help;                     ///< may be empty
};

/// An argument of a call, found by its tokens.
struct CallArgument {
    const Token* call;   ///< the word before the parenthesis
    std::size_t index;   ///< among the arguments, from 0
    const Token* token;  ///< its first
};

/// Returns the arguments of all calls in a file in order, but not the parameters of definitions.
/// Blocks within arguments have calls of their own.
std::vector<CallArgument> arguments_in(const EditedFile&);

/// Returns the signature of the macro that is called by the token, with its first argument active;
/// nothing if it is no macro.
std::optional<Signature> macro_signature(Workspace&, const EditedFile&, const Token& call);

/// Returns nothing if the place is not inside a call.
std::optional<Signature> signature_at(Workspace&, const std::string& path, std::uint32_t offset);

}  // namespace candelabra

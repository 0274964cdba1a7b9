// SPDX-License-Identifier: GPL-3.0-or-later
// Evaluates the text of a scene to a Scene: the only entry point of this module. Called by the
// application and by tests. Continues after errors where possible; the Scene is then incomplete and
// must not be rendered.
#pragma once

#include "interpret/evaluator.h"
#include "scene/scene.h"

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace candelabra {

struct EvaluateOptions {
    /// Names declared before the scene begins: Declare=Depth=5.
    std::vector<std::pair<std::string, std::variant<double, std::string, Numbers>>> declares;
    RunFacts facts;
    Limits limits;
    /// Name of a declared object that replaces all objects of the scene; empty: none.
    std::string only;
    /// Receives the output of #debug and similar directives as it comes; empty: it is discarded.
    std::function<void(std::string_view)> print;
    /// Returns true if the scene is no longer wanted. It then ends early, without a message, and is
    /// incomplete. May be empty.
    std::function<bool()> ended = {};
};

/// `main` is a source in the store. Adds all problems to the diagnostics, with the frames that lead
/// to them.
Scene evaluate(SourceStore&, const Loader&, SourceId main, const EvaluateOptions&, Diagnostics&);

}  // namespace candelabra

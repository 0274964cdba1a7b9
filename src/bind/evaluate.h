// SPDX-License-Identifier: GPL-3.0-or-later
// From the text of a scene to the Scene: the one entry to this module. Called by the application
// and by tests. Goes on after errors where it can; when there are any, the Scene has holes and is
// not meant to be rendered.
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
    /// Names that are declared before the scene begins: Declare=Depth=5.
    std::vector<std::pair<std::string, std::variant<double, std::string>>> declares;
    RunFacts facts;
    Limits limits;
    /// The name of a declared object that is all of the scene; empty: what the scene shows.
    std::string only;
    /// What #debug and its relatives say, as it comes; empty: nobody listens.
    std::function<void(std::string_view)> print;
};

/// `main` has been added to the sources. All problems go to the diagnostics, with the frames that
/// lead to them.
Scene evaluate(SourceStore&, const Loader&, SourceId main, const EvaluateOptions&, Diagnostics&);

}  // namespace candelabra

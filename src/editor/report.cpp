// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/report.h"

#include "bind/evaluate.h"
#include "syntax/lint.h"
#include "syntax/parser.h"
#include "world/compile.h"
#include "world/review.h"

namespace candelabra {

namespace {

/// A scene that is being typed may contain endless loops.
constexpr std::uint64_t max_steps = 5'000'000;

}  // namespace

void report(const Workspace& workspace, const std::string& path,
            const std::string& folder_for_writing, Report& result) {
    const std::string folder = directory_of(path);
    const std::optional<Found> found =
        workspace.loader(folder, FileAccess()).load(path, "", FileKind::data);
    if (!found) return;
    const SourceId main = result.sources.add(path, found->text);
    if (path.ends_with(".inc")) {
        Names names;
        const Tree tree =
            parse(main, result.sources, names, result.diagnostics, {.included = true});
        lint(tree, names, result.diagnostics);
        return;
    }
    FileAccess access({workspace.library()}, {folder_for_writing});
    access.reads(scene_folders(folder, {}));
    EvaluateOptions options;
    options.limits.steps = max_steps;
    const Scene scene = evaluate(result.sources, workspace.loader(folder, access), main, options,
                                 result.diagnostics);
    if (!result.diagnostics.failed())
        review(scene, *survey(scene, result.diagnostics), result.diagnostics);
}

}  // namespace candelabra

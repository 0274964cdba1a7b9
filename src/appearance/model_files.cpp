// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/model_files.h"

#include "text/message.h"
#include "text/printable.h"

#include <memory>
#include <utility>
#include <vector>

namespace candelabra {

namespace {

/// The files of a model that has been read, or is read now; null after a diagnostic.
std::shared_ptr<const ModelFiles> files_of(OpenBlock& block, const Found& model) {
    const std::shared_ptr<const ModelFiles>& known = block.binder.model_files[model.path];
    if (!known) read_model(block, model);
    return known;
}

using List = std::vector<ImportedFile> ModelFiles::*;

std::optional<Found> file_of_model(OpenBlock& block, const std::string& model, int number,
                                   std::string_view what, List list) {
    const Span place = block.file_place();
    const Evaluator& evaluator = block.binder.evaluator;
    const auto found = block.binder.evaluator.load_found(model, place);
    block.broken |= !found;
    if (!found) return std::nullopt;
    if (!has_parts(found->path)) {
        block.report(error(Fault::misplaced, place,
                           message("`", what, "` is for files of models, and `",
                                   printable(found->path), "` is none")));
        return std::nullopt;
    }
    const auto files = files_of(block, *found);
    block.broken |= !files;
    if (!files) return std::nullopt;
    const std::vector<ImportedFile>& all = (*files).*list;
    const auto index = static_cast<std::size_t>(number);
    if (index >= all.size()) {
        block.report(error(
            Fault::out_of_range, place,
            message("there is no `", what, "` ", number, " in the model, which has ", all.size())));
        return std::nullopt;
    }
    const std::string called = message(found->path, ", ", what, ' ', number);
    if (all[index].file.empty()) return Found{called, all[index].bytes};
    const std::string name = name_beside(all[index].file);
    auto beside = name.empty()
                      ? std::nullopt
                      : evaluator.loader().load(name, directory_of(found->path), FileKind::data);
    if (!beside)
        block.report(
            error(Fault::io, place, message("`", printable(name), "` is not beside the model")));
    return beside;
}

}  // namespace

std::optional<UnpackedModel> read_model(OpenBlock& block, const Found& file) {
    const Evaluator& evaluator = block.binder.evaluator;
    const std::string folder = directory_of(file.path);
    std::string missing;
    const auto beside = [&](const std::string& name) -> std::optional<std::string> {
        auto found = evaluator.loader().load(name, folder, FileKind::data);
        if (found) return std::move(found->text);
        // The reader of the model then tries other names in the place of this one.
        if (missing.empty()) missing = name;
        return std::nullopt;
    };
    auto model =
        import_model(file, beside, block.binder.evaluator.diagnostics(), block.file_place());
    if (!model) return std::nullopt;
    if (!missing.empty())
        block.report(warning(Fault::io, block.file_place(),
                             message("`", printable(missing),
                                     "` is not beside the model, so what it has is left out")));
    block.binder.model_files[file.path] =
        std::make_shared<ModelFiles>(ModelFiles{model->model.pictures, model->model.profiles});
    return model;
}

std::optional<Found> picture_of_model(OpenBlock& block, const std::string& model, int number) {
    return file_of_model(block, model, number, "picture", &ModelFiles::pictures);
}

std::optional<Found> profile_of_model(OpenBlock& block, const std::string& model, int number) {
    return file_of_model(block, model, number, "profile", &ModelFiles::profiles);
}

}  // namespace candelabra

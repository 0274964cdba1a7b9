// SPDX-License-Identifier: GPL-3.0-or-later
#include "tasks/export_mesh.h"

#include "output/mesh_export.h"
#include "picture/file.h"

#include <optional>
#include <string>

namespace candelabra {

int export_mesh(SceneSteps& steps) {
    const std::optional<Scene> scene = steps.valid_scene();
    if (!scene) return exit_status::scene;
    const std::string& path = steps.options().mesh_file;
    const std::string mesh =
        exported_mesh(*scene, mesh_format(path).value_or(MeshFormat::ply), steps.diagnostics());
    if (!mesh.empty()) write_file(path, mesh, steps.diagnostics());
    return steps.say_diagnostics() ? exit_status::file : exit_status::done;
}

}  // namespace candelabra

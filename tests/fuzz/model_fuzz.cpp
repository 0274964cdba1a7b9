// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a model, whose kind the first byte says, and as what another process has packed: no
// crash of the program, and no place that is not there.
#include "fuzz/target.h"
#include "meshing/model_import.h"
#include "meshing/packed_model.h"

#include <array>
#include <cstdlib>

using namespace candelabra;

namespace {

void check(const UnpackedModel& model) {
    for (const Mesh& mesh : model.meshes)
        for (const Face& face : mesh.faces)
            for (const int corner : face)
                if (corner < 0 || static_cast<std::size_t>(corner) >= mesh.vertices.size())
                    std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    static constexpr std::array names = {"a.gltf", "a.glb", "a.obj", "a.fbx", "a.dae", "a.3mf"};
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    UnpackedModel unpacked;
    if (unpack(bytes, unpacked).empty()) check(unpacked);
    Diagnostics diagnostics;
    const auto beside = [&](const std::string& name) -> std::optional<std::string> {
        if (name_beside(name) != name) std::abort();
        return name.size() % 2 == 0 ? std::optional(bytes) : std::nullopt;
    };
    const auto model =
        import_model({names[data[0] % names.size()], bytes}, beside, diagnostics, {});
    if (model) check(*model);
    if (!model && diagnostics.all().size() != 1) std::abort();
    return 0;
}

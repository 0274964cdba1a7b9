// SPDX-License-Identifier: GPL-3.0-or-later
#include "output/world_report.h"

#include "index/statistics.h"
#include "text/message.h"
#include "vocabulary/written.h"

#include <algorithm>

namespace candelabra {

namespace {

std::string written_out(const Vec3& v) { return message("<", v.x, ", ", v.y, ", ", v.z, ">"); }

std::string sampler_text(const World& world) {
    LightSampler sampler = world.rules.settings.light_sampler;
    const ItemInfo& info = *Kinds<LightSampler>::infos[sampler.index()];
    const std::string fields = written_fields(info, Kinds<LightSampler>::address(sampler));
    return message(info.name, fields.empty() ? "" : " ", fields);
}

/// Returns the number of luminaires of each form, and the greatest radiance.
std::string luminaire_text(const World& world) {
    std::size_t spheres = 0, triangles = 0;
    double greatest = 0;
    world.lights.luminaires.for_each([&](const Luminaire& luminaire) {
        spheres += std::holds_alternative<SphereEmitter>(luminaire.emitter);
        triangles += std::holds_alternative<TriangleEmitter>(luminaire.emitter);
        greatest = std::max(greatest, max_component(luminaire.radiance));
    });
    for (const MediaBox& box : world.lights.media)
        greatest = std::max(greatest, max_component(box.radiance));
    const std::size_t all = world.lights.glowing(), volumes = world.lights.media.size();
    return message(all, " (", spheres, " spheres, ", triangles, " triangles, ",
                   all - spheres - triangles - volumes, " others",
                   volumes > 0 ? message(", ", volumes, " boxes of media") : "",
                   "), greatest radiance ", greatest);
}

/// Empty if there are no instances.
std::string instance_text(const Geometry& geometry) {
    if (geometry.instances.empty()) return {};
    return message("instances: ", geometry.instances.size(), " of ", geometry.prototypes.size(),
                   geometry.prototypes.size() == 1 ? " union, " : " unions, ",
                   geometry.primitive_count() - geometry.instanced_begin(), " primitives in all\n");
}

}  // namespace

std::string report(const World& world) {
    const TreeStatistics tree = statistics(world.geometry.tree);
    const Projection& camera = world.stated_view.camera;
    return message(
        "objects: ", world.provenance.object_count, "\n",
        "primitives: ", world.geometry.spheres.size(), " spheres, ",
        world.geometry.triangles.size(), " triangles, ", world.geometry.shapes.size(),
        " other shapes, ", world.geometry.composites.size(), " composites; ",
        world.geometry.infinite.all.size(), " infinite\n", instance_text(world.geometry),
        "materials: ", world.appearance.materials.size(), "\n",
        "luminaires: ", luminaire_text(world), "\n", "light sampler: ", sampler_text(world), "\n",
        "light sources: ", world.lights.sources.size(), "\n",
        "index: ", Kinds<RayIndex>::infos[world.rules.settings.index.index()]->name, ", ",
        tree.nodes, " nodes, ", tree.leaves, " leaves, depth ", tree.max_depth, ", ", tree.bytes,
        " bytes\n", "camera: ", camera.parallel ? "parallel rays" : "rays from a point",
        ", location ", written_out(camera.location), ", direction ", written_out(camera.direction),
        ", right ", written_out(camera.right), ", up ", written_out(camera.up), "\n",
        "max_trace_level: ", world.rules.settings.max_trace_level, "\n");
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// A world as a camera sees it: the camera, and all that is prepared for the place from which it
// looks, such as the cells of the light samplers. Many shots may share a world; making one does not
// change it.
#pragma once

#include "base/function_ref.h"
#include "lighting/sampler.h"
#include "scene/settings.h"
#include "world/lamp.h"
#include "world/world.h"

#include <cstdint>
#include <vector>

namespace candelabra {

struct ShotSettings {
    int width = 320, height = 240;  ///< of the picture; they set how finely light is evaluated
    int threads = 0;                ///< 0: one per core; the result is the same
    /// Whether hierarchies choose the lights, without surveys of the scene, instead of the scene's
    /// light sampler: for pictures of few rays, as the cells of a light octree would need more.
    bool quick = false;

    static ShotSettings of(const RenderSettings& settings) {
        return {settings.width, settings.height, settings.threads};
    }
};

/// Returns the settings of a film that the camera exposes. Glare is measured in degrees, which the
/// field of view converts into pixels.
FilmSettings film_in(const Projection&, const FilmSettings&);

struct Shot {
    /// Makes a camera of one that the scene states.
    using Placed = FunctionRef<Projection(const Projection&)>;

    /// The view that the scene states.
    explicit Shot(SharedWorld, const ShotSettings& = {});
    /// The view of other cameras: `placed` is called for each moment of the shutter.
    Shot(SharedWorld, const ShotSettings&, Placed placed);
    Shot(Shot&&) = default;  ///< not copied: the samplers refer to the bent normals
    Shot& operator=(Shot&&) = default;

    /// Number of moments at which the open shutter sees the world, including the first one.
    std::size_t moments() const { return 1 + later.size(); }
    const Shot& moment(std::size_t number) const { return number == 0 ? *this : later[number - 1]; }

    /// A light that the sampler chooses, other than the sky.
    Lamp lamp(LightIndex light) const;

    /// Fraction of the rays that leave a luminaire on its inner side, for emit().
    double inner_rays(const Luminaire&) const;

    SharedWorld world;
    WorldView view;
    std::uint64_t pixels;            ///< of the picture
    Box near;                        ///< where media deserve most effort; empty if there are none
    std::vector<Vec3> bent_normals;  ///< see find_bent_normals()
    /// Chooses among the luminaires, the sky, and the sources of one set.
    BuiltLightSampler sampler;
    /// That set, whose sources come after the luminaires; null: there is none.
    const SourceSet* joined = nullptr;
    /// For each other source set; a default one where all sources are asked.
    std::vector<BuiltLightSampler> of_sources;
    std::vector<Shot> later;  ///< of World::shutter
};

}  // namespace candelabra

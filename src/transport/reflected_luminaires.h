// SPDX-License-Identifier: GPL-3.0-or-later
// Reflected light as luminaires (the imposters of the paper's section 5): points of diffuse
// surfaces that light has reached, in a light hierarchy of their own, so that indirect light at a
// point takes one shadow ray. They do not light points that are too near; light from near surfaces
// is found by a separate ray (Kollig and Keller, "Illumination in the Presence of Weak
// Singularities", 2004). Both together are unbiased over the generations.
#pragma once

#include "transport/air_to_camera.h"
#include "transport/generations.h"
#include "transport/light_path.h"
#include "transport/reflection_density.h"
#include "transport/seen_share.h"

#include <cmath>

namespace candelabra {

/// The reflected luminaires of one generation, and the strategy that chooses among them.
struct ReflectedSet {
    std::vector<ReflectedLuminaire> list;
    std::vector<double> bounds;  ///< of each: see ReflectedLuminaires::bound()
    BuiltLightSampler sampler;   ///< chooses among them for surfaces
    BuiltLightSampler in_air;    ///< chooses among them for places in media, if they light these
};

class ReflectedLuminaires {
public:
    /// The shot must outlive this. `count`: light paths in a generation. `threads`: 0: one per
    /// core; the result does not depend on it.
    ReflectedLuminaires(const Shot&, std::uint32_t count, int max_reflections, int seed,
                        int threads);

    /// See generation_serving().
    static constexpr std::uint32_t single_samples = 4, shared_samples = 4;

    /// Number of consecutive samples that are served from memory.
    static constexpr std::uint32_t samples_at_once = 32;

    std::shared_ptr<const ReflectedSet> generation(std::uint32_t number);

    /// Whether light is reflected or scattered more than once at all.
    bool any() const { return !density_.empty() || !density_in_air_.empty(); }
    /// Whether they stand for light that media scatter, too, and light media.
    bool in_air() const { return paths_.scatter(); }
    /// Bound of the geometry term of reflected luminaires at a place of a surface, on the side of
    /// the unit normal; light beyond it is found by paths. So none of them counts for more than a
    /// small part of the light that the scene, and the surface about it, sends out. It is 0 where
    /// the camera sees next to nothing that the place lights, or through too much air: reflected
    /// luminaires there would mostly be chosen in vain. Precondition: any().
    double bound(const Vec3& place, const Vec3& normal) const {
        return density_.empty() || is_far_in_air(place) || is_hardly_seen(place, normal)
                   ? 0
                   : std::fmin(greatest_bound_, per_density_ * density_.at(place));
    }
    /// The same in a medium: light from there is about that of all places within the usual
    /// distance between two of them.
    double bound_in_air(const Vec3& place) const {
        return density_in_air_.empty() || is_far_in_air(place)
                   ? 0
                   : per_density_in_air_ * density_in_air_.at(place);
    }
    /// Number of light paths in a generation.
    std::uint32_t count() const { return count_; }

private:
    /// Minimum fraction of what the camera sees from which a reflected luminaire must be visible,
    /// times the square of the greatest cosine at which it faces the lit region.
    static constexpr double least_seen = 0.04;
    /// Minimum transmittance of the air between a reflected luminaire and the camera.
    static constexpr double least_left = 0.005;

    std::vector<ReflectedLuminaire> sent(const LightPaths&, std::uint32_t count,
                                         std::uint64_t stream) const;
    ReflectedSet made(std::uint32_t number) const;
    /// Far ground lights what is seen at a flat angle, by few light paths that stand for much.
    bool is_hardly_seen(const Vec3& place, const Vec3& normal) const {
        const double facing = paths_.region().greatest_cosine(place, normal);
        return seen_.at(place, normal) * facing * facing < least_seen;
    }
    bool is_far_in_air(const Vec3& place) const { return air_.transmittance(place) < least_left; }
    void find_bound(const std::vector<ReflectedLuminaire>& tried);
    void find_seen(const std::vector<ReflectedLuminaire>& tried);

    const Shot& shot_;
    int max_reflections_;
    LightPaths paths_;
    AirToCamera air_;
    std::uint32_t count_;
    std::uint64_t seed_;
    int threads_;
    ReflectionDensity density_, density_in_air_;  ///< of light paths that light nothing else
    double greatest_bound_ = 0, per_density_ = 0, per_density_in_air_ = 0;
    SeenShare seen_;
    Generations<ReflectedSet> generations_;
};

/// Null where the scene does not ask for any, no light is reflected from surface to surface, or
/// where rays meet a surface depends on their start: light that leaves it would be lost on its way.
std::shared_ptr<ReflectedLuminaires> reflected_luminaires_of(const Shot&, int seed, int threads);

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// One sample of a pixel: its ray, and what the integrator and the other sums of the film get of it.
#pragma once

#include "base/handle.h"
#include "base/rgb.h"
#include "film/pixel_filter.h"
#include "film/render_state.h"
#include "render/hooks.h"
#include "render/plan.h"
#include "transport/integrator.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

/// What a sample saw.
struct SeenSample {
    Rgb colour;
    std::uint32_t shadow_rays;
    bool negative;  ///< the filter is negative at the sample
};

/// Follows the rays of samples. A copy serves one thread; copies are cheap, but to make one from a
/// plan is not, because the objects around the camera are found among all objects.
class SampleTracer {
public:
    SampleTracer(const RenderPlan&, const RenderHooks&, const Film&);

    /// Prepares what all copies share for a sample of each pixel, with several threads.
    void prepare(std::uint32_t sample) const;

    /// Follows the ray of a sample, and adds its values besides the colour to `extra`, none of them
    /// if the work ends meanwhile. Samples cycle through the moments of the shutter.
    SeenSample look(int x, int y, std::uint32_t sample, std::span<ExactSum> extra);

    /// The hit at the centre of a pixel, for gather_middle().
    PrimaryHit seen_at_middle(int x, int y) const;

    /// Adds the rays that were followed.
    void add_rays(LightLedger&) const;

    /// Factor on the radiance for display.
    double exposure() const { return exposure_; }

private:
    PicturePoint point(int x, int y) const;
    FilteredPlace place(const Key&) const;
    void gather(const Rgb& colour, const Ray&, const Key&, std::size_t moment, std::span<ExactSum>);
    double illuminance(const Ray&, const Key&, std::size_t moment);

    const RenderPlan* plan_;
    const RenderHooks* hooks_;
    const Film* film_;
    Handle<PixelFilter> filter_;
    double exposure_;
    std::vector<Integrator> integrators_;  ///< one for each moment
    std::vector<Integrator> meters_;       ///< the same for illuminance; empty: it is not wanted
    std::vector<ExactSum> apart_;          ///< buffer for a sample that is subtracted
};

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
// One tile of a picture, which one thread makes.
#pragma once

#include "film/tile_samples.h"
#include "render/interruption.h"
#include "render/sample.h"

#include <cstdint>
#include <span>
#include <vector>

namespace candelabra {

class TileMaker final : public TileSamples {
public:
    TileMaker(RenderState& state, const Region& region, const RenderHooks& hooks,
              const SampleTracer& tracer, Interruption& interruption)
        : TileSamples(state, region),
          first_sample_(state.shard.first_sample),
          aovs_(hooks.aovs),
          tracer_(tracer),
          interruption_(interruption) {}

    std::uint64_t bring(int x, int y, std::uint32_t samples) override;
    PixelSample look(int x, int y, std::uint32_t sample) override;
    void add(int x, int y, const PixelSample&) override;
    double clear(int x, int y) const override;
    bool stopped() override;

    void add_rays(LightLedger& rays) const { tracer_.add_rays(rays); }

private:
    std::span<ExactSum> aovs_of(int x, int y) const { return film().extra(film().index(x, y)); }

    const std::uint32_t first_sample_;
    const Aovs aovs_;
    SampleTracer tracer_;
    Interruption& interruption_;
    std::uint64_t made_ = 0;            ///< samples that pixels got
    std::vector<ExactSum> extra_ = {};  ///< buffer for the sums of one ray
};

}  // namespace candelabra

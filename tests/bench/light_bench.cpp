// SPDX-License-Identifier: GPL-3.0-or-later
// How the light sampling strategies compare on the paper's pair of sphereflakes (Figure 6): noise
// against a converged picture, rays and CPU time, and the time with 7381 luminaires over the time
// with one. Run by hand:
//   light_bench [CONVERGED.exr]     320x320, rays through the pixel centres; without it, one is
//   rendered first
#include "base/parallel.h"
#include "evaluate/evaluate.h"
#include "picture/read.h"
#include "render/render.h"
#include "support/scripts.h"
#include "world/compile.h"

#include <ctime>

#include <cstdio>
#include <string>
#include <vector>

namespace {

constexpr double straight_at_a_luminaire =
    4.9;  // such pixels have no noise and would hide the others'

struct Noise {
    double mean_ratio, rmse, relative_mse;
};

Noise compare(const Image& image, const Image& converged) {
    double mean = 0, converged_mean = 0, squares = 0, converged_squares = 0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < image.pixels.size(); ++i) {
        const double c = converged.pixels[i].y, v = image.pixels[i].y;
        if (c > straight_at_a_luminaire) continue;
        mean += v;
        converged_mean += c;
        squares += (v - c) * (v - c);
        converged_squares += c * c;
        ++count;
    }
    return {mean / converged_mean, std::sqrt(squares / static_cast<double>(count)),
            squares / converged_squares};
}

RenderSettings settings_for(int samples) {
    RenderSettings settings;
    settings.width = settings.height = 320;
    settings.antialias = false;
    settings.samples = samples;
    settings.threads = 1;
    return settings;
}

struct Run {
    Rendering rendering;
    double cpu_seconds;
};

Run timed(const World& world, int samples) {
    const std::clock_t start = std::clock();
    Rendering rendering = render(world, settings_for(samples));
    return {std::move(rendering), static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC};
}

World flakes(const LightSampler& sampler, bool one_luminaire) {
    return world_of_file("examples/paper/fig6.pov",
                         one_luminaire ? Declares{{"Luminaires", 1.0}} : Declares{}, sampler);
}

}  // namespace

int main(int argc, char** argv) {
    Diagnostics diagnostics;
    Image converged;
    if (argc > 1) {
        if (auto picture = read_picture(argv[1], diagnostics))
            converged = std::move(*picture);
        else
            return std::fprintf(stderr, "light_bench: cannot read %s\n", argv[1]), 3;
    } else {
        std::printf("rendering a converged picture first\n");
        RenderSettings settings = settings_for(2048);
        settings.seed = 4711;
        settings.threads = 0;
        converged = render(flakes(LightOctree{}, false), settings).image;
    }

    struct Row {
        LightSampler sampler;
        int samples;
    };
    LightBvh mis; mis.mis = true;
    LightOctree alone; alone.alone = true;
    auto brdf = [](double x) { LightOctree o; o.brdf = x; return o; };
    const std::vector<Row> rows = {{LightBvh{}, 4}, {mis, 4}, {alone, 4}, {brdf(0), 4}, {brdf(0.3), 4}, {brdf(0.5), 4}, {brdf(0.7), 4}, {brdf(0.9), 4}};
    const Run opponent = timed(flakes(LightBvh{}, false), 10);
    const Noise opponent_noise = compare(opponent.rendering.image, converged);
    std::printf("%-15s %7s %12s %8s %8s %8s %9s %9s   %s\n", "strategy", "samples", "shadow rays",
                "CPU s", "mean", "RMSE", "rel. MSE", "MSE x s", "MSE x s over light_bvh's");
    for (const Row& row : rows) {
        const Run run = timed(flakes(row.sampler, false), row.samples);
        const Noise noise = compare(run.rendering.image, converged);
        const double cost = noise.rmse * noise.rmse * run.cpu_seconds;
        const double opponent_cost =
            opponent_noise.rmse * opponent_noise.rmse * opponent.cpu_seconds;
        const std::string name(Kinds<LightSampler>::infos[row.sampler.index()]->name);
        std::printf("%-15s %7d %12llu %8.2f %8.4f %8.4f %9.4f %9.4f   %.2f\n", name.c_str(),
                    row.samples, static_cast<unsigned long long>(run.rendering.rays.shadow),
                    run.cpu_seconds, noise.mean_ratio, noise.rmse, noise.relative_mse, cost,
                    cost / opponent_cost);
        std::fflush(stdout);
    }
    for (const LightSampler& sampler : {LightSampler(LightBvh{}), LightSampler(LightOctree{})}) {
        const double many = timed(flakes(sampler, false), 10).cpu_seconds;
        const double one = timed(flakes(sampler, true), 10).cpu_seconds;
        std::printf("%s, 10 samples: %.2f s with 7381 luminaires, %.2f s with one: %.2f times\n",
                    std::string(Kinds<LightSampler>::infos[sampler.index()]->name).c_str(), many,
                    one, many / one);
    }
}

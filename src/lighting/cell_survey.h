// SPDX-License-Identifier: GPL-3.0-or-later
// The survey of a cell of the light octree: some thousand rays that are traced when the cell is
// made. They measure how much of the light that its cut promises arrives, which light is seen from
// there, and how noisy each way of sampling it is.
#pragma once

#include "lighting/light_cut.h"
#include "lighting/light_guide.h"
#include "lighting/light_query.h"
#include "lighting/sky_survey.h"

#include <span>
#include <vector>

namespace candelabra {

/// Means over the luminaires of an entry, weighted by their light.
struct EntryLook {
    double luminance, solid_angle;  ///< as seen from about the cell's centre
};

/// Results of the rays that survey a cell.
struct CellSurvey {
    std::optional<LightGuide> outlook;  ///< none: no directions are sampled from it
    double by_direction = 0;            ///< fraction of shadow rays to be sampled from the outlook
    bool as_scattered = false;          ///< all shadow rays should be sampled from the BSDF
    /// Expected standard deviation of one shadow ray's irradiance, per unit of the cut's total
    /// weight at a point; below 0: not known.
    double noise = -1;
    /// Expected irradiance in the same unit; known if the noise is.
    double irradiance = 0;

    /// Variance over squared mean of choosing luminaires, known if the noise is.
    double noise_of_choice = INFINITY;
    std::optional<SkySurvey> sky = {};  ///< if it is one of the lights; the noise is not set then
    DrawnLight lamps = {};              ///< all other lights, per unit of the total weight
    /// With a sky: variance over squared mean of what is sampled from the outlook, or from the BSDF
    /// if all shadow rays are; infinite if it is not known.
    double noise_of_directions = INFINITY;

    /// The choice among all lights at a point where the cut has a total weight. Precondition: there
    /// is a sky.
    SharedDraw among_all(const Receiver&, double total) const;
    /// Fraction of the shadow rays that surfaces with highlights should sample from their BSDF,
    /// given the weights of the light that they reflect: the smaller luminaires are beside the
    /// lobes, the fewer of these directions hit any, and the less the lobes vary over one.
    /// `looks` are those of the entries. Precondition: knows_by_surface().
    double by_surface(const CutWeights&, const BsdfLobes&, std::span<const EntryLook> looks) const;
    bool knows_by_surface() const { return irradiance > 0; }
    /// What is expected of one shadow ray there, if any light is.
    std::optional<LightEstimate::ShadowRay> ray_of(const SharedDraw&) const;
};

/// Surveys cells. Deterministic. Refers to the lights and to their tree.
class CellSurveyor {
public:
    /// `max_by_direction`: maximum fraction of the shadow rays to be sampled from the outlook.
    CellSurveyor(const ChoosableLights&, const LightTree&, const Viewer&, double max_by_direction);

    /// Whether no sampled direction hits any light.
    bool no_surfaces() const { return no_surfaces_; }

    /// Surveys a cell, and scales its cut's entries by the arriving fraction of their light. In the
    /// air: for points between surfaces.
    CellSurvey operator()(const Box& cell, bool in_air, LightCut&, const LightProbe&) const;

    /// The looks of the entries of a cell, from some luminaires of each, drawn by their light.
    std::vector<EntryLook> looks_of(const LightCut&, const Box& cell) const;

private:
    /// Result of shadow rays to chosen luminaires: variance over squared mean, and mean irradiance
    /// per unit of the total weight.
    struct Found {
        double noise, irradiance;
        /// Of the light sources and of the luminaires by themselves, where there are both.
        DrawnLight sources = {}, luminaires = {};
    };
    Found found_by_choice(const LightCut&, std::span<const SurveyPlace>, const LightProbe&) const;
    void with_sources(CellSurvey&, const Found&, double outlook) const;
    double share_of_outlook(double found, double choice, double outlook) const;
    CellSurvey with_sky(CellSurvey, const Found& by_choice, double weight,
                        std::span<const SkyRay>) const;
    std::vector<float> counted(std::span<const float> shares, const LightCut&, const Box&) const;

    const ChoosableLights& lights_;
    const LightTree& tree_;
    Viewer viewer_;
    double max_by_direction_;
    LightBall ball_;
    double brightest_ = 0;                           ///< luminance
    bool all_surfaces_ = true, no_surfaces_ = true;  ///< lights have surfaces
};

}  // namespace candelabra

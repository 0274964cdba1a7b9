// SPDX-License-Identifier: GPL-3.0-or-later
// The numbers of light strategies that were found by trial. Behind each stands what shows its
// effect: a paragraph or a row of tests/bench/README.md, section "Light" if no other is named, or a
// test. Change a number only by measuring that again. Numbers that follow from a precision or from
// a formula stand where they are used.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace candelabra::tuning {

/// Luminaires in a hierarchy: see "Build and shadow rays".
struct Hierarchy {
    /// Borders at which cuts of a node are tried, plus one.
    int bins;
    /// Nodes with more luminaires are only cut across their longest side: the axis matters little
    /// there, but time does.
    std::size_t many;
};
inline constexpr Hierarchy light_tree{16, std::size_t{1} << 12};
inline constexpr Hierarchy light_bvh{12, std::size_t{1} << 14};

/// The opponent in benchmarks, `light_bvh`: minimum fractions of the full brightness for a node at
/// the edge of the horizon, and for one seen from the side.
inline constexpr double min_height = 1e-4, min_facing = 1e-2;

// Clusters and cuts.

/// Clusters nearer than this multiple of their radius are divided at the point itself: "Long rows"
/// and the rows `flake` and `city`.
inline constexpr double near_radii = 6;
/// The same for clusters whose luminaires shine to different sides, because a point gets the light
/// of some of them only: "Which way windows face".
inline constexpr double near_radii_turned = 12;
/// The same for surfaces with highlights: squared radii for each unit of the sharpness of the
/// sharpest lobe, which reflects the light of some members only: "Lamps in a lobe".
inline constexpr double near_radii2_of_lobe = 1;
/// Single luminaires brighter than this multiple of all clusters are left out when the clusters'
/// noise is judged, because they may turn out to be occluded: "A hidden sun", row `sun`.
inline constexpr double outshining = 20;
/// Minimum reflectance of surfaces without a diffuse part, because highlights differ a little from
/// the formula, and minimum height of entries over the horizon, as a cosine, by which weights are
/// divided: "Glossy surfaces", row `glossy`.
inline constexpr double min_diffuse = 0.02;
inline constexpr float min_cosine = 0.05f;

// Cells.

/// Factor by which the noise of a cell without a survey exceeds the bound before the cell is
/// divided, because weighing the entries at each point compensates for less: the strategy `alone`
/// of the rows `flake`, `city` and `room`.
inline constexpr double divided_above = 20;
/// Size in pixels, as seen by the eye, above which cells are divided, because they contain many
/// hits, whose views differ. Smaller cells stay whole if they are surveyed, so that the survey's
/// rays are a small part of all rays: "Cells", "More entries".
inline constexpr double coarse_pixels = 32;
/// Bounds on this size as an angle (size over distance), for large and for small pictures: "Cells".
inline constexpr double min_coarse = 0.03, greatest_coarse = 0.5;
/// Factor on this size for cells between surfaces, where light varies less: "Air".
inline constexpr double coarser_in_air = 2;
/// Maximum size of cells where all rays of the camera are parallel, in widths of the view:
/// tests/statistics, scenes of any scale.
inline constexpr double most_views = 4;
/// Number of levels below cells that are too large by which noise may divide cells without a survey
/// in any case: one lamp that is far makes the whole cube large, and its first levels say nothing.
/// Chosen by reflected luminaires over an endless plane: "Indirect light".
inline constexpr int finer_levels = 5;

// Surveys.

/// Number of lines that look for surfaces in a cell, and number of places that suffice: "Cells".
inline constexpr std::uint32_t place_lines = 48, enough_places = 12;
/// Maximum light of a place, as a multiple of that of the place with the least light: `city`.
inline constexpr double max_counted = 4;
/// Number of shadow rays for each entry: "More entries"; and of places from which they start.
inline constexpr std::uint32_t entry_rays = 6;
inline constexpr std::size_t max_entry_places = 8;
/// Minimum and maximum share of an entry, as multiples of the mean; the minimum is for far entries:
/// "A hidden sun", `city`.
inline constexpr double min_share = 0.1, max_share = 4;
/// Fraction of the arriving light that all entries with the minimum share may count together,
/// because a sun behind shutters must not take all rays: "A hidden sun", row `sun`.
inline constexpr double max_unseen = 0.1;
/// Near luminaires look different from different points of a cell, and so count more than the
/// survey says. Together they are raised by at most this multiple of the survey's total of all
/// entries, and each alone by at most this multiple. So occluded luminaires cause little noise,
/// however bright, and those that are visible against the survey are not too rare: row `sun`,
/// tests/statistics/hidden_test.cpp.
inline constexpr double max_raised = 1, max_raised_alone = 0.1;
/// Number of shadow rays that measure the noise of choosing luminaires in a cell: "More samples".
inline constexpr std::uint32_t trials = 48;
/// Minimum variance over squared mean of both ways of sampling, because surfaces differ: `flake`.
inline constexpr double min_noise = 0.02;
/// Factor on the noise of the choice against that of the outlook, because the rays that measured
/// the choice had also trained it: `flake`, `city`.
inline constexpr double doubt = 3;

/// Number of rays to the sky: "The sky".
inline constexpr std::uint32_t sky_rays = 64;
/// Minimum fraction of the choices that the sky has, and that all other lights have, where both may
/// light a point, because a few places of a cell may see what its survey does not: "The sky".
inline constexpr double min_of_either = 0.25;

// Directions.

/// Rays traced for each bin of the light guide: results of some are compared with those of the
/// others.
inline constexpr std::size_t guide_tries = 2;
/// Distance, in its radii, from which the luminaires' ball is treated as a ball: `flake`.
inline constexpr double well_outside = 1.15;
/// Fraction of a bin's estimate that is taken from its neighbours: `flake`, `city`.
inline constexpr double from_neighbours = 0.3;
/// Weights of the mean of all bins, in rays per bin, among which each cell's rays choose; with the
/// last one the picture is nearly uniform.
inline constexpr std::array<double, 5> caution = {1, 2, 6, 20, 1e6};
/// Minimum fraction of the shadow rays that are sampled from the outlook, which finds luminaires
/// that nearly touch the point. The fraction decreases with the noise of the choice below
/// little_noise, and is 0 if there is none at all: "The paper's figures" (Figure 2).
inline constexpr double min_by_direction = 0.1, little_noise = 0.1, no_noise = 1e-6;
/// Maximum ratio of the brightest luminaire to the mean visible luminance at which surfaces may
/// sample directions from their BSDF alone, because no ray can then bring much more than others:
/// "Cells" (the room with `Same=1`).
inline constexpr double max_glare = 16;
/// Fraction of the shadow rays that surfaces without a diffuse part sample from their BSDF: "Glossy
/// surfaces", row `glossy`.
inline constexpr double max_by_surface = 0.5;
/// Fraction of this that they keep where luminaires are small beside the lobe, so that few of these
/// directions hit any: "Lamps in a lobe".
inline constexpr double least_by_surface = 0.1;

// The paper's strategies.

/// Distance, in radii, within which triangles are evaluated exactly.
inline constexpr double exact_radii = 4;
/// Maximum list length of a cell; of more luminaires the brightest are taken, and the others count
/// as dim. Row `million`.
inline constexpr std::size_t longest_list = 2048;
/// A cut helps if the lists of the parts are at most this fraction of the whole's, on average.
/// After this number of cuts in a row that did not help, cells stay whole, because smaller ones
/// would not help either: row `million`.
inline constexpr double helpful = 0.9;
inline constexpr int patience = 3;
/// Fraction of the dim luminaires' probability that is shared evenly; the rest is by intensity.
/// (The paper shares all of it evenly, but luminaires are rarely that alike: on a sphereflake,
/// whose luminaires come in four sizes with equal sums, the variance is then 15 times greater.)
inline constexpr double even_share = 0.1;
/// Minimum estimate of the dim luminaires, as a fraction of their light if they were all straight
/// above the point. So a few unlucky representatives do not turn the rest into rare fireflies, and
/// the search ends if all are below the horizon. (The paper draws until one is above, which may
/// never happen.)
inline constexpr double min_dim_height = 0.05;

}  // namespace candelabra::tuning

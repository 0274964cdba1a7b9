// SPDX-License-Identifier: GPL-3.0-or-later
// The features of a scene: factors with levels, of which each scene has one. A scene is a stage (a
// floor, a ball, a camera) with one tested object, its lights and its surroundings. Levels come
// from the vocabulary where it lists kinds, so a new shape, pattern or strategy is a new level.
#pragma once

#include "proof/covering.h"
#include "proof/element.h"

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace candelabra::proof {

/// Properties of levels for which some laws do not hold. A law names those that it leaves out.
enum Trait : unsigned {
    no_trait = 0,
    lengths = 1 << 0,        ///< has lengths that do not grow with the scene
    directions = 1 << 1,     ///< has directions of space that do not turn with the scene
    nonlinear = 1 << 2,      ///< its picture is not proportional to its light, by its definition
    gains = 1 << 3,          ///< makes or loses light by POV-Ray's rules
    bends = 1 << 4,          ///< its shading normals are not those of the surface
    tiny_light = 1 << 5,     ///< a lamp that chance hardly finds
    sources = 1 << 6,        ///< light sources, which nobody sees
    glows = 1 << 7,          ///< emits light
    scatters = 1 << 8,       ///< media that scatter
    dims = 1 << 9,           ///< fog or media that are seen
    hides = 1 << 10,         ///< is not seen by all rays alike
    open_surface = 1 << 11,  ///< is no closed solid
    moves = 1 << 12,         ///< changes with the clock
    photon_light = 1 << 13,
    gathers = 1 << 14,  ///< radiosity
    endless = 1 << 15,  ///< fills more than its place on the stage
    aside = 1 << 16,    ///< of the run: it changes no mean
    refracts = 1 << 17,
    passes = 1 << 18,  ///< light passes it
    fogs = 1 << 19,    ///< fog or a rainbow
    veils = 1 << 20,   ///< dims every ray, however short it is
    in_lens = 1 << 21  ///< a lamp in glass that bends its light, and that photons do not aim at
};

/// A scene in the making.
struct Draft {
    explicit Draft(std::uint64_t seed) : dice(seed) {}

    Dice dice;
    Element shape;
    Element pigment = block("pigment", "rgb <0.8, 0.7, 0.6>");
    std::optional<Element> normal = {};
    Element finish = block("finish", "diffuse 0.7");
    /// Makes the textures of the three; empty: one plain texture.
    std::function<std::vector<Element>(Draft&, Element texture)> structure = {};
    std::vector<Element> modifiers = {};  ///< of the tested object
    std::function<Element(Draft&, Element object)> combine = {};
    std::vector<Element> settings = {};
    std::string lens = "perspective";
    std::vector<Element> camera = {};
    std::vector<Element> around = {};  ///< lights and surroundings
    std::vector<RunOption> options = {};
    int lights = 0;

    int new_light() { return lights++; }
};

struct Level {
    std::string name;
    unsigned traits = no_trait;
    std::function<void(Draft&)> add = {};
};

struct Factor {
    std::string_view name;
    std::vector<Level> levels;  ///< the first one is the plainest
};

/// All factors, in the order in which their levels are added to a draft.
const std::vector<Factor>& factors();

/// The levels without those traits, for each factor.
std::vector<std::vector<std::size_t>> levels_without(unsigned traits);

/// The draft with the levels of the row.
Draft drafted(const Row&, std::uint64_t seed);

/// The tested object with textures, modifiers and neighbours, around the origin.
Element tested_object(Draft&);

/// The ball that stands beside the tested object.
Element ball_beside();

/// The whole scene.
Script staged(Draft&);

/// The names of the row's levels that are not the plainest.
std::string described_row(const Row&);

// The parts of the table, one file each.
std::vector<Factor> object_factors();
std::vector<Factor> surface_factors();
std::vector<Factor> light_factors();
std::vector<Factor> run_factors();

}  // namespace candelabra::proof

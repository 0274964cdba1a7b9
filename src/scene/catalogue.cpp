// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/catalogue.h"

#include "pattern/use.h"
#include "scene/model_settings.h"
#include "scene/scene.h"
#include "surface/normal_map.h"

#include <array>

namespace candelabra {

namespace {

constexpr auto objects = std::array{&Switches::vocabulary};
constexpr auto surface = std::array{
    &BumpSettings::vocabulary, &Finish::vocabulary,     &Reflection::vocabulary, &Irid::vocabulary,
    &Microfacet::vocabulary,   &Subsurface::vocabulary, &Interior::vocabulary};
constexpr auto surroundings =
    std::array{&SkySphere::vocabulary, &Daylight::vocabulary, &Fog::vocabulary,
               &Rainbow::vocabulary,   &Media::vocabulary,    &Scattering::vocabulary};
constexpr auto parts_of_cameras = std::array{&MeshRays::vocabulary, &CameraFunctions::vocabulary};
constexpr auto films =
    std::array{&FilmSettings::vocabulary, &Glare::vocabulary, &Bokeh::vocabulary};
constexpr auto modifiers = std::array{&PatternModifiers::vocabulary};
constexpr auto settings = std::array{&GlobalSettings::vocabulary, &PhotometricUnits::vocabulary,
                                     &SubsurfaceSettings::vocabulary, &Radiosity::vocabulary,
                                     &PhotonSettings::vocabulary};
constexpr auto lamps = std::array{&LampData::vocabulary};
constexpr auto photons_of_objects = std::array{&ObjectPhotons::vocabulary};
constexpr auto photons_of_lights = std::array{&LightPhotons::vocabulary};

constexpr auto models = std::array{&ModelSettings::vocabulary};
constexpr auto lights = std::array{&PointLight::vocabulary};
constexpr auto meters = std::array{&Meter::vocabulary};

constexpr auto groups = std::array{
    ItemGroup{"Shapes", "What objects are made of.", Kinds<Shape>::infos},
    ItemGroup{"Objects",
              "What any object may have, beside its appearance, its interior and transformations.",
              objects},
    ItemGroup{"Models", "Objects in files.", models},
    ItemGroup{"Cameras",
              "The type is the first word in camera { }; perspective when there is none.",
              Kinds<Camera>::infos, "camera"},
    ItemGroup{"Parts of cameras", "What mesh_camera and user_defined have in braces.",
              parts_of_cameras, "camera"},
    ItemGroup{"Films",
              "What develops the light of a camera, and the opening of its lens: camera { film { "
              "glare { ... } ... } bokeh { ... } }.",
              films},
    ItemGroup{"Lights",
              "Lights without size. Every object whose finish has emission is a luminaire and "
              "lights the scene as well.",
              lights},
    ItemGroup{
        "Patterns",
        "What varies over a surface: the first word in pigment { }, usually with a color_map.",
        Kinds<Pattern>::infos, "pigment"},
    ItemGroup{"Pattern modifiers", "What may follow any pattern, beside transformations.",
              modifiers, "pigment"},
    ItemGroup{"Waves", "How a pattern's value runs through its map, again and again.",
              Kinds<Waveform>::infos, "pigment"},
    ItemGroup{"Warps", "What moves points before a pattern, in the order of the text.",
              Kinds<Warp>::infos, "warp"},
    ItemGroup{"Surfaces", "How objects answer light, and what is inside of them.", surface},
    ItemGroup{"Surroundings", "What lies around the objects, and between them.", surroundings},
    ItemGroup{"Meters", "What --measure measures, and where.", meters},
    ItemGroup{"Settings", "What holds for the whole scene.", settings},
    ItemGroup{"Lamps in numbers", "What luminaire { } has in a finish or an object.", lamps},
    ItemGroup{"Photons of objects", "What photons { } has in an object.", photons_of_objects},
    ItemGroup{"Photons of lights", "What photons { } has in a light_source.", photons_of_lights},
    ItemGroup{"Light samplers",
              "How luminaires are chosen at each point: global_settings { light_sampler { name ... "
              "} }, or --light-sampler.",
              Kinds<LightSampler>::infos, "light_sampler"},
    ItemGroup{
        "Indexes",
        "What finds the surfaces that a ray may meet: global_settings { index { name ... } }, "
        "or --index. All of them give equal pictures.",
        Kinds<RayIndex>::infos, "index"},
    ItemGroup{
        "Integrators",
        "How light is followed: global_settings { integrator { name ... } }, or --integrator.",
        Kinds<IntegratorSettings>::infos, "integrator"},
};

}  // namespace

std::span<const ItemGroup> catalogue() { return groups; }

}  // namespace candelabra

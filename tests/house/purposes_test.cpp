// SPDX-License-Identifier: GPL-3.0-or-later
// Each random number is drawn for a decision of its own: which files make which decision.
#include <catch2/catch.hpp>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <set>
#include <sstream>
#include <string>

namespace candelabra {

namespace fs = std::filesystem;

namespace {

using Files = std::set<std::string>;

const fs::path source_folder = fs::path(CANDELABRA_SOURCE_DIR) / "src";

/// The purposes, and the files that draw a number for them. Where there are several files, all of
/// them make the same decision: about paths of another kind, or in another strategy.
std::map<std::string, Files> files_of_purposes() {
    const Files pixels = {"film/contrast_rule.cpp", "film/corner_rule.cpp", "film/pixel_filter.cpp",
                          "preview/inspect.cpp", "render/pilot.cpp"},
                ways = {"render/light_balance.cpp", "transport/light_path.cpp",
                        "transport/path_traced.cpp", "transport/photon_path.cpp"},
                bounces = {"transport/light_path.cpp", "transport/lit_region.cpp",
                           "transport/povray.cpp", "transport/sky_starts.cpp",
                           "transport/surface_lobes.cpp"},
                sky = {"transport/sky_at_layer.cpp", "transport/sky_rays.cpp",
                       "transport/sky_starts.cpp"};
    std::map<std::string, Files> table = {
        {"light_choice",
         {"lighting/cluster_descent.cpp", "lighting/constant_alpha.cpp", "lighting/cut_octree.cpp",
          "lighting/light_bvh.cpp", "lighting/linear_alpha.cpp", "lighting/paper_octree.cpp"}},
        {"survey", {"lighting/survey_draw.h", "world/bent_normals.cpp", "world/volumes.cpp"}},
        {"texture_choice",
         {"render/light_balance.cpp", "transport/path_traced.cpp", "transport/photon_path.cpp"}},
        {"way_choice", ways},
        {"roulette",
         {"render/light_balance.cpp", "transport/light_path.cpp", "transport/path_traced.cpp"}},
        {"media_distance",
         {"medium/march.cpp", "transport/light_in_air.cpp", "transport/photon_path.cpp"}},
        {"media_transmittance", {"medium/march.cpp", "medium/transmittance.cpp"}},
        {"sender_choice",
         {"transport/flux_rays.cpp", "transport/lamp_rays.h", "transport/light_path.cpp"}},
        {"seen_place", {"transport/light_path.cpp", "transport/reflected_luminaires.cpp"}},
        {"pixel_x", pixels},
        {"pixel_y", pixels},
        {"bounce_u", bounces},
        {"bounce_v", bounces},
        {"sky_u", sky},
        {"sky_v", sky}};
    const std::map<std::string, std::string> by_file = {
        {"lighting/draw.h", "light_u light_v"},
        {"lighting/paper_octree.cpp", "dim_representative"},
        {"luminaire/composite.cpp", "survey_u survey_v"},
        {"meshing/scatter.cpp", "scatter_face scatter_u scatter_v"},
        {"render/light_balance.cpp", "sender_kind"},
        {"render/measure.cpp", "meter_u meter_v glare_u glare_v"},
        {"transport/air_photon_light.cpp", "photon_in_air"},
        {"transport/atmosphere.cpp", "rainbow"},
        {"transport/camera_ray.cpp", "lens_u lens_v"},
        {"transport/chosen_light.cpp", "light_roulette"},
        {"transport/lamp_rays.cpp", "sent_u sent_v sent_side"},
        {"transport/light_path.cpp",
         "behind_on_line media_lobe media_direction_u media_direction_v media_event"},
        {"transport/lit_layer.h", "grain"},
        {"transport/participating_media.cpp",
         "media_choice media_lobe media_direction_u media_direction_v near_reflection"},
        {"transport/path_steps.cpp", "facet_choice facet_u facet_v band_choice"},
        {"transport/path_traced.cpp", "media_event near_reflection other_light"},
        {"transport/photon_shooter.cpp", "photon_lamp photon_u photon_v photon_start"},
        {"transport/photons.cpp", "photon_offset"},
        {"transport/sky_at_layer.cpp", "sky_choice"},
        {"transport/source_light.cpp", "grid_u grid_v jitter_u jitter_v sun_u sun_v"},
        {"transport/source_rays.cpp", "sent_grid_u sent_grid_v"},
        {"transport/subsurface.cpp",
         "subsurface_choice subsurface_u subsurface_v subsurface_roulette"}};
    for (const auto& [file, purposes] : by_file) {
        std::istringstream words(purposes);
        for (std::string purpose; words >> purpose;) table[purpose].insert(file);
    }
    return table;
}

std::string whole_text(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    REQUIRE(file);
    return {std::istreambuf_iterator<char>(file), {}};
}

template <class Use>
void for_matches(const std::string& text, const std::regex& form, const Use& use) {
    for (std::sregex_iterator i(text.begin(), text.end(), form), end; i != end; ++i) use((*i)[1]);
}

/// The purposes that base/random.h names.
std::set<std::string> purposes_declared() {
    std::string text = whole_text(source_folder / "base/random.h");
    text = text.substr(text.find("enum class Purpose"));
    text = text.substr(text.find('{'), text.find("};") - text.find('{'));
    std::set<std::string> names;
    for_matches(text, std::regex(R"(\n +(\w+))"), [&](const std::string& n) { names.insert(n); });
    return names;
}

std::map<std::string, Files> purposes_drawn() {
    std::map<std::string, Files> files;
    for (const auto& entry : fs::recursive_directory_iterator(source_folder)) {
        const std::string name = fs::relative(entry.path(), source_folder).string();
        const std::string kind = entry.path().extension().string();
        if ((kind != ".h" && kind != ".cpp") || name.rfind("base/random", 0) == 0) continue;
        for_matches(whole_text(entry.path()), std::regex(R"(Purpose::(\w+))"),
                    [&](const std::string& purpose) { files[purpose].insert(name); });
    }
    return files;
}

}  // namespace

TEST_CASE("each random number is drawn for a purpose of its own", "[house]") {
    const std::map<std::string, Files> found = purposes_drawn(), expected = files_of_purposes();
    REQUIRE(purposes_declared().size() > 40);
    for (const std::string& purpose : purposes_declared()) {
        INFO(purpose);
        REQUIRE(found.count(purpose) == 1);
        REQUIRE(expected.count(purpose) == 1);
        CHECK(found.at(purpose) == expected.at(purpose));
    }
    for (const auto& [purpose, files] : expected) {
        INFO(purpose);
        CHECK(purposes_declared().count(purpose) == 1);
    }
}

}  // namespace candelabra

// SPDX-License-Identifier: GPL-3.0-or-later
#include "options/choice_options.h"

#include "options/read_words.h"

namespace candelabra {

TEST_CASE("each light sampler, index and integrator can be chosen by its name") {
    for (std::size_t kind = 0; kind < Kinds<LightSampler>::count; ++kind) {
        const std::string name(Kinds<LightSampler>::infos[kind]->name);
        CHECK(read({"--light-sampler=" + name}).render.light_sampler->index() == kind);
    }
    for (std::size_t kind = 0; kind < Kinds<RayIndex>::count; ++kind) {
        const std::string name(Kinds<RayIndex>::infos[kind]->name);
        CHECK(read({"--index=" + name}).render.index->index() == kind);
    }
    for (std::size_t kind = 0; kind < Kinds<IntegratorSettings>::count; ++kind) {
        const std::string name(Kinds<IntegratorSettings>::infos[kind]->name);
        CHECK(read({"--integrator=" + name}).render.integrator->index() == kind);
    }
    CHECK_FALSE(read({"+W5"}).render.index);
}

TEST_CASE("names that there are not choose nothing") {
    for (const char* bad :
         {"--index=kdtree", "--index=", "--light-sampler=kd_tree", "--integrator=radiosity"})
        read({bad}, false);
}

}  // namespace candelabra

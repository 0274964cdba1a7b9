// SPDX-License-Identifier: GPL-3.0-or-later
// A floor of facets under a thousand small lamps. Declare=Rough=0.3 is its roughness, Declare=Metal=0 makes it a lacquer, and
// Declare=Rival=1 lights it by `light_bvh { mis }`.
#version 3.7;
#ifndef (Rough) #declare Rough = 0.3; #end
#ifndef (Metal) #declare Metal = 1; #end
global_settings { assumed_gamma 1 light_sampler { #ifdef (Rival) light_bvh { mis } #else light_octree #end } }
#default { finish { ambient 0 } }
camera { location <0, 1.2, -6> look_at <0, 0, 2> angle 60 }
plane { y, 0 pigment { rgb 0.8 } finish { diffuse 1 microfacet { roughness Rough metallic Metal } } }
#declare S = seed(5);
#for (I, 1, 1000)
    sphere {
        <rand(S)*12 - 6, 0.2 + rand(S)*2.5, rand(S)*14 - 2>, 0.03
        pigment { rgb 1 }
        finish { diffuse 0 emission 20*(0.5 + rand(S)) }
    }
#end

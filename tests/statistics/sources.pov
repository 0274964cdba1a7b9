// SPDX-License-Identifier: GPL-3.0-or-later
// Light sources of all kinds, so many that some are chosen: points that fade in different ways, spots, beams, grids,
// lights that nothing stops, lamps in bulbs, a light behind a window, and light of one direction; two that take light away.
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 5, -7> look_at <0, 0.5, 0> right x up y angle 60 }
box { <-20, -1, -20>, <20, 0, 20> pigment { rgb 0.7 } finish { ambient 0 diffuse 0.8 specular 0.2 roughness 0.1 } }
#declare Random = seed(11);
#macro Anywhere() <4*rand(Random) - 2, 0.4 + 2*rand(Random), 4*rand(Random) - 2> #end
#for (I, 0, 11)
    light_source { Anywhere(), rgb 0.2*<1, rand(Random), 0.5> fade_distance 0.5 + rand(Random) fade_power mod(I, 4) }
    light_source { Anywhere(), rgb 0.3 spotlight point_at Anywhere() - 2.5*y radius 10 + 4*I falloff 20 + 4*I tightness mod(I, 3) }
    light_source { Anywhere(), rgb 0.02
        area_light 0.5*x, 0.5*z, 2, 2
        #if (mod(I, 3) = 0) area_illumination on #end
        #if (mod(I, 3) = 1) circular orient #end
    }
    light_source { Anywhere(), rgb 0.02 #if (mod(I, 2)) shadowless #else looks_like { sphere { 0, 0.1 pigment { rgb 1 } } } #end }
#end
#for (I, 0, 3)
    light_source { Anywhere(), rgb 0.4 cylinder point_at Anywhere() - 2.5*y radius 0.4 falloff 0.8 }
#end
light_source { <0, 5, 3>, rgb 0.3 projected_through { disc { <0, 3, 2>, y, 0.7 } } }
light_source { <1, 3, -2>, rgb -0.05 }
light_source { <-1, 2, 2>, rgb <0.05, -0.02, 0> }
#for (I, 0, 35)
    light_source { <20*rand(Random) - 10, 6, 20*rand(Random) - 10>, rgb 0.01*rand(Random) parallel point_at 0 }
#end
sphere { <-1, 0.6, -0.5>, 0.6 pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
sphere { <0.1, 0.5, 0.9>, 0.5 pigment { rgb 0.8 } finish { ambient 0 microfacet { roughness 0.5 metallic 1 } } }
box { <1, 0, -1>, <1.7, 1.2, 0> pigment { rgbt <0.8, 0.9, 0.8, 0.3> } finish { ambient 0 diffuse 0.7 } }
light_group {
    light_source { <-3, 2, 0>, rgb 0.3 }
    box { <-3, 0, 1>, <-2, 1, 2> pigment { rgb 0.8 } finish { ambient 0 diffuse 1 } }
    global_lights on
}

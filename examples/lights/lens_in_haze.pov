// SPDX-License-Identifier: CC0-1.0
// A glass ball gathers the light of three lamps into beams that cross the haze below it: photons
// light the air as well, because of the word media in the photons of global_settings.
#version 3.7;
global_settings {
    assumed_gamma 1.0
    max_trace_level 6
    photons { count 60000 media 4 }
}

camera {
    location <0, 1.9, -7>
    right 4/3*x
    up y
    angle 43
    look_at <0, 1.72, 0>
    film { exposure 0.7 response agx vignette 0.25 glare { veil 0.08 halo 0.006 } }
}

#declare Ball = <0, 2.35, 0>;
#macro Lamp(Place, Colour)
    light_source {
        Place, Colour
        spotlight
        point_at Ball
        radius 6.2
        falloff 7.4
        photons { refraction on reflection on }
    }
#end
Lamp(<-4.6, 7.6, -0.8>, 3.4*<1, 0.42, 0.08>)
Lamp(<0, 9, -1.2>, 2.6*<1, 0.12, 0.4>)
Lamp(<4.6, 7.6, -0.8>, 3.4*<0.06, 0.42, 1>)

sphere {
    Ball, 0.7
    pigment { rgbt 1 }
    finish {
        ambient 0
        diffuse 0
        specular 0.8
        roughness 0.004
        reflection { 0.02, 1 fresnel }
        conserve_energy
    }
    interior { ior 1.46 }
    photons { target refraction on reflection on }
}

#declare Dull = finish { ambient 0 diffuse 0.8 }
plane { y, 0 pigment { checker rgb 0.5, rgb 0.36 scale 0.6 rotate 45*y } finish { Dull } }
plane { -z, -4 pigment { rgb <0.10, 0.11, 0.14> } finish { Dull } }

media { scattering { 1, 0.06 extinction 0.6 } }

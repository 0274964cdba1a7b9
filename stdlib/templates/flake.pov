// SPDX-License-Identifier: CC0-1.0
// A sphereflake whose smallest spheres glow: the scene that this program was made for.
//   candelabra flake.pov +W960 +H720
#version 3.7;
global_settings { assumed_gamma 1 }
#default { finish { ambient 0 diffuse 0.8 } }

#declare Levels = 4;  // 5 has nine times as many lamps
#declare Glow = <1, 0.55, 0.2>;

camera {
    location <3, 2.1, -4.9> look_at <0, 0.05, 0> angle 54
    right x*image_width/image_height  // the shape of the picture
    film {
        exposure 0.8           // in stops
        response agx           // how bright light fades into white
        vignette 0.25
        glare { veil 0.08 halo 0.004 }
    }
}
background { rgb <0.006, 0.008, 0.014> }

// A floor that shows each lamp twice.
plane { y, -1.3
    pigment { rgb 0.2 }
    finish { microfacet { roughness 0.15 } diffuse 0.8 }
}

// Around each sphere sit nine of a third of its size.
#macro Flake(Centre, Radius, Up, Level)
    sphere { Centre, Radius
        #if (Level = 0)
            pigment { rgb Glow }
            finish { diffuse 0 emission 5 }
        #else
            pigment { rgb <0.75, 0.77, 0.8> }
            finish { microfacet { roughness 0.25 metallic 0.6 } }
        #end
    }
    #if (Level > 0)
        #local Side = vnormalize(vcross(Up, #if (abs(Up.x) < 0.9) x #else y #end));
        #local Front = vcross(Up, Side);
        #for (I, 0, 8)
            // Six around the middle, and three above.
            #local Angle = (I < 6 ? I*pi/3 : (I - 6)*2*pi/3 + pi/6);
            #local Height = (I < 6 ? 0 : 0.82);
            #local Out = vnormalize(sqrt(1 - Height*Height)*(cos(Angle)*Side + sin(Angle)*Front) + Height*Up);
            Flake(Centre + Out*Radius*4/3, Radius/3, Out, Level - 1)
        #end
    #end
#end

Flake(0, 1, y, Levels - 1)

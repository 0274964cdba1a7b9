// SPDX-License-Identifier: CC0-1.0
// A house whose front is a screen of 100,000 LEDs, row by row from below: Front[0..399] is the lowest
// row. The light of each is kept while the picture is rendered, and a show is played with it:
//   candelabra media_facade.pov +W640 +H360 --samples 64 --keep-lights front.lights
//   candelabra relight front.lights --csv media_facade.csv --movie front.mp4
//   candelabra relight front.lights --csv media_facade.csv --preview 8000
//   candelabra share front.lights --csv media_facade.csv -o front.html
#version 3.7;
global_settings { assumed_gamma 1 }

camera {
  location <-8, 1.7, -22> look_at <0.3, 5.6, 0> angle 58 right 16/9*x
  film { exposure 0.7 response filmic glare { veil 0.08 } }
}

#declare Across = 400;
#declare Up = 250;
#declare Led = sphere { 0, 0.012 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission 76.5 } }

// The house, with a door.
difference {
  box { <-8, 0, 0>, <8, 12.6, 6> }
  box { <-1.2, -1, -1>, <1.2, 2.6, 0.6> }
  pigment { rgb 0.12 } finish { ambient 0 diffuse 0.7 }
}
union {
  #for (Row, 0, Up - 1)
    #for (Column, 0, Across - 1)
      object { Led translate <-7.8 + 15.6*Column/(Across - 1), 3 + 9.3*Row/(Up - 1), -0.06> }
    #end
  #end
  light_name "Front"
}
// Two lanterns beside the door are the other lamps.
#declare Lantern = sphere {
  0, 0.18 pigment { rgb 1 } finish { ambient 0 diffuse 0 emission <12, 7, 3> }
}
union {
  #for (Side, -1, 1, 2) object { Lantern translate <1.9*Side, 2.2, -0.35> } #end
  light_name "Lanterns"
}

// The square before it, with trees in tubs and people who stop.
plane { y, 0
  pigment { checker rgb <0.42, 0.4, 0.38>, rgb <0.36, 0.35, 0.34> scale 1.5 }
  finish { ambient 0 diffuse 0.75 specular 0.15 roughness 0.05 }
}
#macro Tree(Place)
  union {
    cylinder { 0, 0.7*y, 0.55 pigment { rgb <0.3, 0.2, 0.15> } }
    cylinder { 0.7*y, 2*y, 0.06 pigment { rgb <0.25, 0.18, 0.1> } }
    sphere { 2.7*y, 0.95 pigment { rgb <0.15, 0.35, 0.12> } }
    finish { ambient 0 diffuse 0.8 }
    translate Place
  }
#end
Tree(<-6.5, 0, -3>) Tree(<-3.2, 0, -3>) Tree(<3.2, 0, -3>) Tree(<6.5, 0, -3>)
#macro Person(Place, Height)
  union {
    cone { 0, 0.2, 0.82*Height*y, 0.24 }
    sphere { 0.92*Height*y, 0.12 }
    pigment { rgb <0.35, 0.3, 0.32> } finish { ambient 0 diffuse 0.8 }
    translate Place
  }
#end
Person(<-1.6, 0, -8>, 1.75) Person(<-1.0, 0, -7.7>, 1.62)
Person(<3.6, 0, -6>, 1.8) Person(<4.1, 0, -9>, 1.2)

#!/bin/bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Scenes that would not end, or would want all memory: each ends within 10 seconds of one core (20
# where others use the core as well) and 1 GB, with a message that names a limit and, where it can
# be raised, the option. What a bomb costs grows with the limits, so a tenth of each limit is tried, within a fifth of
# the time; FULL=1 in the environment takes the limits as they are.
# Others are legal, and ask for more of something than there is use for: these make their picture within the same bounds.
# usage: bombs.sh CANDELABRA [NAME]     runs one bomb only, and shows what it says
# TIMES=1 in the environment: prints the seconds of each
set -u
program=$(realpath "$1")
only=${2:-}
limits=(--limit-steps 10000000 --limit-objects 2000000 --limit-files 10000 --limit-said 7 --limit-work 400
    --memory 300M)
seconds=4
[ -n "${FULL:-}" ] && limits=(--memory 1G) seconds=20
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
cd "$folder" || exit 1
count=0
failed=0

# explode NAME TEXT OPTION...: renders it, and leaves its status in $status and what it says in NAME.out. False: another one
# is asked for.
explode() {
    local name=$1 begun=$SECONDS
    [ -n "$only" ] && [ "$only" != "$name" ] && return 1
    count=$((count + 1))
    printf '#version 3.7;\n%s\n' "$2" > "$name.pov"
    (
        ulimit -t $seconds
        ulimit -c 0
        exec "$program" "$name.pov" "${limits[@]}" +W16 +H12 +WT1 -F -V "${@:3}"
    ) > "$name.out" 2>&1
    status=$?
    [ -n "${TIMES:-}" ] && echo "$name: $((SECONDS - begun)) s"
    return 0
}

# harmless NAME TEXT OPTION...: the scene must make its picture.
harmless() {
    local name=$1 status=0
    explode "$@" || return
    if [ $status -ne 0 ]; then
        echo "FAILED: $name: status $status, $(head -c 300 "$name.out" | head -3)"
        failed=$((failed + 1))
    fi
    [ -n "$only" ] && cat "$name.out"
    rm -f "$name.out"
}

# bomb NAME LIMIT TEXT OPTION...: the scene must end with an error that says LIMIT.
bomb() {
    local name=$1 limit=$2 status=0
    explode "$name" "${@:3}" || return
    if [ $status -lt 1 ] || [ $status -gt 3 ] || ! grep -q -e "$limit" "$name.out"; then
        echo "FAILED: $name: status $status, $(head -c 300 "$name.out" | head -3)"
        failed=$((failed + 1))
    fi
    [ -n "$only" ] && cat "$name.out"
    rm -f "$name.out"
}

# levels N FIRST NEXT: declarations, each made of the one before, which is @ in NEXT.
levels() {
    local i
    echo "#declare A0 = $2"
    for ((i = 1; i <= $1; ++i)); do echo "#declare A$i = ${3//@/A$((i - 1))}"; done
}

# nested N OPEN INNER CLOSE
nested() {
    local i text=""
    for ((i = 0; i < $1; ++i)); do text+=$2; done
    text+=$3
    for ((i = 0; i < $1; ++i)); do text+=$4; done
    echo "$text"
}

# Loops.
bomb while limit-steps '#while (1) #end'
bomb while_counting limit- '#declare I = 0; #while (1) #declare I = I + 1; #end'
bomb for limit-steps '#for (I, 1, 1e300) #end'
bomb for_backwards limit- '#for (I, 1, -1e18, -1) #declare A = I; #end'
bomb for_set_back limit- '#for (I, 1, 2) #declare I = 1; #end'
bomb loops_in_loops limit- '#for (I, 1, 1e6) #for (J, 1, 1e6) #for (K, 1, 1e6) #declare A = K; #end #end #end'
bomb loop_in_switch limit- '#while (1) #switch (1) #case (1) #range (0, 2) #declare A = 1; #end #end'
bomb loop_in_block limit- 'union { #while (1) sphere { 0, 1 } #end }'
bomb loop_in_vector limit- '#while (1) #declare V = <1, 2, 3> * vlength(<4, 5, 6>); #end'
bomb loop_of_locals limit- '#macro M() #while (1) #local A = 1; #end #end M()'
bomb loop_of_undef limit- '#while (1) #declare A = 1; #undef A #end'
bomb loop_of_conditions limit- '#while (1) #ifdef (A) #else #ifndef (A) #end #end #end'
bomb loop_of_defaults limit- '#while (1) #default { pigment { rgb 1 } } #end'
bomb loop_of_versions limit- '#while (1) #version 3.7; #end'
bomb loop_of_numbers limit- '#declare R = seed(1); #while (1) #declare A = rand(R) + sin(rand(R)); #end'
bomb loop_of_warnings limit- '#while (1) #warning "x" #end'

# Macros and recursion.
bomb recursion limit-depth '#macro M() M() #end M()'
bomb recursion_twice limit- '#macro M(N) #if (N > 0) M(N - 1) M(N - 1) #end #end M(60)'
bomb recursion_of_two limit-depth '#macro A() B() #end #macro B() A() #end A()'
bomb recursion_with_value limit- '#macro M(N) (M(N + 1) + M(N + 2)) #end #declare V = M(1);'
bomb macros_in_macros limit- "$(for ((i = 1; i <= 60; ++i)); do echo "#macro M$i() M$((i - 1))() M$((i - 1))() #end"; done; echo '#macro M0() #end M60()')"
bomb macro_of_arguments limit- '#macro M(A, B) M(concat(A, B), concat(B, A)) #end M("x", "y")'
bomb macro_defines_itself limit- '#macro M() #macro N() M() #end N() #end M()'

# Files.
for ((i = 1; i <= 40; ++i)); do printf '#include "f%d.inc"\n#include "f%d.inc"\n' $((i - 1)) $((i - 1)) > f$i.inc; done
: > f0.inc
echo '#include "itself.inc"' > itself.inc
bomb includes limit-files '#include "f40.inc"'
bomb include_itself limit-includes '#include "itself.inc"'
bomb include_in_loop limit- '#while (1) #include "f0.inc" #end'
bomb include_what_it_writes limit- '#while (1) #fopen F "w.inc" write #write (F, "#declare A = 1;") #fclose F #include "w.inc" #end'
bomb write limit-written '#fopen F "w.txt" write #while (1) #write (F, "0123456789012345678901234567890123456789012345678901234567890123456789", "0123456789012345678901234567890123456789012345678901234567890123456789") #end' --limit-written 200
bomb open_and_close limit- '#while (1) #fopen F "c.txt" append #fclose F #end'
bomb open_many 'limit-\|cannot be written' '#for (I, 1, 1e9) #fopen F concat("w", str(I, 0, 0), ".txt") write #undef F #end'
bomb read_again limit- '#fopen F "r.txt" write #write (F, "1,2,3,4,5") #fclose F #while (1) #fopen G "r.txt" read #while (defined(G)) #read (G, A) #end #end'
bomb exists limit- '#while (1) #declare A = file_exists("none.txt"); #end'

# Words.
bomb debug limit-said '#while (1) #debug "hello, world, hello, world, hello, world\n" #end'
bomb debug_of_nothing limit-said '#while (1) #debug "" #end'
bomb debug_of_much limit-said '#declare S = "0123456789"; #for (I, 1, 20) #declare S = concat(S, S); #end #while (1) #debug S #end'

# Strings.
bomb string_doubled limit-text '#declare S = "x"; #while (1) #declare S = concat(S, S); #end'
bomb string_grows limit- '#declare S = ""; #while (1) #declare S = concat(S, "0123456789"); #end'
bomb string_in_front limit- '#declare S = ""; #while (1) #declare S = concat("0123456789", S); #end'
bomb string_in_array limit- '#declare A = array[1] { "x" } #while (1) #declare A[0] = concat(A[0], A[0]); #end'
bomb strings_in_array limit- '#declare S = "0123456789"; #for (I, 1, 20) #declare S = concat(S, S); #end #declare A = array[100000] #for (I, 0, 99999) #declare A[I] = concat(S, str(I, 0, 0)); #end'
bomb string_upper limit- '#declare S = "abcdefghij"; #for (I, 1, 20) #declare S = concat(S, S); #end #while (1) #declare T = strupr(S); #end'
bomb string_cut limit- '#declare S = "abcdefghij"; #for (I, 1, 20) #declare S = concat(S, S); #end #while (1) #declare T = substr(S, 1, 10000000); #end'
bomb string_compared limit- '#declare S = "abcdefghij"; #for (I, 1, 20) #declare S = concat(S, S); #end #declare T = concat(S, ""); #while (1) #declare B = strcmp(S, T); #end'
bomb string_of_numbers limit- '#while (1) #declare S = vstr(5, <1, 2, 3, 4, 5>, ",", 1000, 1000); #end'
bomb string_measured limit- '#declare S = "abcdefghij"; #for (I, 1, 20) #declare S = concat(S, S); #end #while (1) #declare B = strlen(S); #end'

# Arrays.
bomb array_large 'not enough memory\|limit' '#declare A = array[100000000] #for (I, 0, 99999999) #declare A[I] = <1, 2, 3, 4, 5>; #end'
bomb array_too_large limit-elements '#declare A = array[1000000][1000000]'
bomb arrays_of_arrays limit- "$(levels 60 'array[2] { 1, 2 }' 'array[2] { @, @ }') #declare B = A60; #declare B[0][0][0][0][0] = A60;  #while (1) #declare B[0] = A59; #declare B[0][0] = 1; #end"
bomb arrays_many limit- '#declare A = array[1000000] #for (I, 0, 999999) #declare A[I] = array[1000000]; #declare A[I][0] = 1; #end'
bomb array_copied limit- '#declare A = array[1000000] #declare A[0] = 1; #while (1) #declare B = A; #declare B[0] = 2; #end'

# Functions.
bomb functions_twice limit-function "$(levels 60 'function(x) { x + 1 }' 'function(x) { @(x) + @(-x) }')"
bomb functions_deep 'the limit' "$(levels 200 'function(x) { x + 1 }' 'function(x) { @(x) + 1 }')"
bomb function_sums limit- '#declare F = function(x) { sum(i, 1, 1e5, i*x) } #while (1) #declare A = F(1); #end'
bomb function_sum_of_sums 'does not end' '#declare F = function(x) { sum(i, 1, 1e6, i*x) } #declare G = function(x) { sum(i, 1, 1e6, F(i)) } #declare A = G(1);' --limit-work 4000
bomb function_picture limit-work 'plane { y, -1 pigment { image_map { function 16384, 16384 { sum(i, 1, 100, sin(x*i*y)) } } } }'
bomb function_heights limit- 'height_field { function 16384, 16384 { sin(x)*cos(y)*sin(x*y)*cos(x/y)*sqrt(x)*sqrt(y)*sin(x*x)*cos(y*y)*exp(x)*exp(y) } }'
bomb functions_in_loop limit- '#while (1) #ifdef (F) #undef F #end #declare F = function(x) { x + 1 } #end'
bomb splines limit- '#while (1) #declare S = spline { natural_spline 0, 0, 1, 1, 2, 4 } #declare A = S(0.5); #end'
bomb spline_long 'limit' '#declare S = spline { natural_spline #for (I, 0, 1e9) I, I #end }'

# Objects.
bomb spheres limit- '#while (1) sphere { 0, 1 } #end'
bomb differences limit-objects "$(levels 60 'sphere { 0, 1 }' 'difference { object { @ } object { @ translate 0.1 } }') object { A60 }"
bomb unions limit-objects "$(levels 60 'sphere { 0, 1 }' 'union { object { @ } object { @ translate 0.1 } }') object { A60 }"
bomb merges_in_loop limit- '#declare D = sphere { 0, 1 } #while (1) #declare D = merge { object { D } object { D translate 1 } } #end'
bomb cutaway limit-objects "$(levels 60 'sphere { 0, 1 }' 'difference { object { @ } object { @ } cutaway_textures }') object { A60 }"
bomb clipped limit- "$(levels 60 'sphere { 0, 1 }' 'object { @ clipped_by { @ } }') object { A60 }"
bomb bounded limit- "$(levels 60 'sphere { 0, 1 }' 'object { @ bounded_by { @ } }') object { A60 }"
bomb wrapped limit-nesting '#declare D = sphere { 0, 1 } #while (1) #declare D = union { object { D } sphere { 1, 1 } } #end'
bomb nested_unions 'nested' "$(nested 30000 'union { ' 'sphere { 0, 1 }' ' }')"
bomb mesh limit- 'mesh { #while (1) triangle { 0, x, y } #end }'
bomb mesh_of_vertices limit- 'mesh2 { vertex_vectors { 1000000000 #while (1) , <1, 2, 3> #end } face_indices { 1, <0, 1, 2> } }'
bomb blob limit- 'blob { #while (1) sphere { 0, 1, 1 } #end }'
bomb lathe limit- 'lathe { linear_spline 1000000000 #while (1) , <1, 2> #end }'
bomb text limit- '#declare S = "abcdefghij"; #for (I, 1, 20) #declare S = concat(S, S); #end text { ttf "timrom.ttf" S 1, 0 }'
bomb lights limit- '#while (1) light_source { 0, 1 } #end'
bomb pigments limit- 'sphere { 0, 1 pigment { gradient x color_map { #while (1) [0 rgb 1] #end } } }'
bomb layers limit- '#declare T = texture { pigment { rgbt 1 } } #while (1) #declare T = texture { T } texture { T } #end'
bomb trace limit- '#declare S = sphere { 0, 1 } #while (1) #declare N = <0, 0, 0>; #declare P = trace(S, -5*z, z, N); #end'
bomb cells limit- '#declare R = seed(1); #declare P = array[3000]; #for (I, 0, 2999) #declare P[I] = <rand(R), rand(R)>; #end #while (1) #for (I, 0, 2999) #declare C = voronoi_cell(P, I, 0, 1); #end #end'
bomb scattered limit- '#while (1) #declare A = scatter(difference { sphere { 0, 1 } #for (I, 0, 3000) sphere { <rand(seed(I)), 0, 0>, 0.01 } #end }, 0.002); #end'
bomb mesh_of_union limit- 'mesh { union { #for (I, 0, 20000) sphere { <I*0.001, 0, 0>, 1 } #end } }'
bomb mesh_of_combs limit- '#declare N = 2000; mesh { intersection { union { #for (I, 0, N) box { <I*3, 0, 0>, <I*3 + 1, N*3, 1> } #end } union { #for (I, 0, N) box { <0, I*3, 0.2>, <N*3, I*3 + 1, 0.8> } #end } } }'
bomb extents limit- '#declare U = union { #for (I, 0, 99999) sphere { I, 1 } #end } #while (1) #declare E = min_extent(U); #end'
bomb trace_isosurface limit- '#declare S = isosurface { function { x*x + y*y + z*z - 1 } accuracy 1e-12 max_gradient 1e12 contained_by { sphere { 0, 2 } } } #while (1) #declare P = trace(S, <1, 0.3, -5>, z); #end'
bomb inside limit- '#declare S = union { #for (I, 1, 1000) sphere { I, 1 } #end } #while (1) #declare B = inside(S, <0.1, 0.2, 0.3>); #end'

# Rays.
facing='camera { location -3*z look_at 0 } light_source { <3, 4, -5>, 1 } box { -9, 9 pigment { rgbt 0.9 } finish { reflection 1 } interior { ior 1.5 } } sphere { 0, 1 pigment { rgbt 1 } finish { reflection 1 } interior { ior 1.2 } }'
slow='#declare F = function(x) { sum(i, 1, 3000, sum(j, 1, 3000, sin(i*j*x)*1e-7)) }'
harmless mirrors_in_time "global_settings { max_trace_level 256 adc_bailout 0 } $facing" --time 2
harmless functions_in_time "$slow camera { location -3*z } light_source { 9, 1 } sphere { 0, 1 pigment { average pigment_map { #for (I, 1, 50) [1 function { F(x + I) }] #end } } }" --time 2
harmless isosurface_in_time "$slow camera { location -3*z } light_source { 9, 1 } isosurface { function { x*x + y*y + z*z - 1 + F(x) } max_gradient 10 contained_by { box { -2, 2 } } }" --time 2
harmless blob_in_time 'camera { location -3*z } light_source { 9, 1 } blob { threshold 0.5 #for (I, 1, 20000) sphere { <sin(I), cos(2*I), sin(3*I)>*0.2, 1, 0.01 } #end }' --time 2

# Media.
view='camera { location -5*z look_at 0 } light_source { 9, 1 }'
inside='sphere { 0, 1 pigment { rgbt 1 } hollow interior { '
bomb media limit- "$view #while (1) media { emission 0.1 } #end"
bomb media_inside limit- "$view $inside #while (1) media { emission 0.1 } #end } }"
bomb densities limit- "$view $inside media { emission 1 #while (1) density { bozo } #end } } }"
bomb densities_of_densities 'nested' "$view $(levels 60 'density { bozo }' 'density { average density_map { [1 @] [1 @] } }') $inside media { emission 1 density { A60 } } } }"
bomb media_nested 'nested' "$view $(nested 30000 "$inside media { emission 1 density { " 'bozo' ' } } } }')"
harmless media_samples "$view $inside media { scattering { 1, 0.1 } samples 1000000000 intervals 1000000000 } } }"
harmless media_thick "$view sphere { 0, 1e15 pigment { rgbt 1 } hollow interior { media { scattering { 1, 1e15 } } } }"

# Photons, radiosity and paths.
glasses='box { I*x, I*x + 0.5 finish { reflection 1 } photons { target reflection on } }'
bomb photons_of_lights 'the limit of' "global_settings { photons { count 1000 } } camera { location -5*z } #for (I, 1, 30000) light_source { I*y, 1 photons { reflection on } } $glasses #end"
bomb photons_of_lamps 'the limit of' "global_settings { photons { count 1000 } } camera { location -5*z } #for (I, 1, 30000) sphere { I*y, 0.1 pigment { rgb 1 } finish { emission 1 } } $glasses #end"
harmless photons_dense "global_settings { photons { spacing 1e-9 } } $view sphere { 0, 1 photons { target reflection on } finish { reflection 1 } }"
harmless photons_many "global_settings { photons { count 1e12 media 1e9 } } $view sphere { 0, 1 photons { target reflection on } finish { reflection 1 } }"
harmless radiosity "global_settings { radiosity { count 1000000000 nearest_count 20 error_bound 1e-9 } } $view sphere { 0, 1 }"
bomb bounces 'must be from 0 to 1000' "global_settings { integrator { path_traced { bounces 1000000000 } } } $view sphere { 0, 1 }"
harmless bounces_without_loss 'global_settings { integrator { path_traced { bounces 1000 } } adc_bailout 0 } camera { location 0 } box { -1, 1 pigment { rgb 1 } finish { diffuse 1 } } sphere { 0.5, 0.1 finish { emission 1 } }'

# Cameras and films.
developed='+F +Odeveloped.png'
bomb mesh_camera limit- '#declare M = mesh { triangle { 0, x, y } } camera { mesh_camera { 1, 0 #while (1) mesh { M } #end } } sphere { 0, 1 }'
harmless mesh_camera_of_many '#declare M = mesh { triangle { 0, x, y } } camera { mesh_camera { 1, 1 #for (I, 1, 300000) mesh { M translate I*x } #end } } light_source { 9, 1 } sphere { 0, 1 }'
bomb filter_wide 'no place in' 'camera { location -5*z film { pixel_filter mitchell 1000000000 } } sphere { 0, 1 }'
bomb grain 'must be from 0 to 1' 'camera { location -5*z film { grain 1e300 } } sphere { 0, 1 }'
bomb glare_of_much limit-memory 'camera { location -5*z film { glare { } } } light_source { 9, 1 } sphere { 0, 1 }' $developed +W30000 +H30000
harmless glare_of_one_pixel 'camera { location -5*z film { glare { field 1e-300 blades 64 length 1e-300 } } } light_source { 9, 1 } sphere { 0, 1 }' $developed +W1 +H1
harmless denoised_infinities 'camera { location -5*z film { response agx exposure auto glare { } } } light_source { 9, 1e308 } sphere { 0, 1 finish { emission 1e308 diffuse 1e308 } } plane { y, -1 pigment { rgb -1e308 } }' $developed --denoise

# Tables and JSON.
yes '1.5,2.5,3.5,4.5' | head -n 4000000 > numbers.csv
yes 'a,b' | head -n 300000 > strings.csv
yes '1,2,3' | head -n 40000000 > wide.csv
{ echo '['; yes '{"a":1},' | head -n 1000000; echo '1]'; } > objects.json
head -c 1000000 /dev/zero | tr '\0' '[' > deep.json
bomb table_again limit- '#while (1) #declare A = read_csv("numbers.csv"); #end'
bomb strings_again limit- '#while (1) #declare A = read_csv("strings.csv"); #end'
bomb table_too_large limit- '#declare A = read_csv("wide.csv");'
bomb objects_again limit- '#while (1) #declare A = read_json("objects.json"); #end'
bomb deep_json 'which is the limit' '#declare A = read_json("deep.json");'
bomb names_again limit- '#declare A = read_csv("numbers.csv", "header"); #while (1) #declare N = column_names(A); #end'
bomb columns_again limit- '#declare A = read_csv("numbers.csv", "header"); #while (1) #declare N = find_column(A, "x"); #end'
bomb path_again limit- '#declare A = read_json("objects.json"); #while (1) #ifdef (A["0.a.b.c.d.e.f.g.h"]) #end #end'
bomb named_again limit- '#declare A = read_csv("strings.csv", "header"); #while (1) #ifdef (A[1]["a"]) #end #end'
rm -f numbers.csv strings.csv wide.csv objects.json deep.json

echo "$count bombs, $failed failed"
exit $((failed > 0))

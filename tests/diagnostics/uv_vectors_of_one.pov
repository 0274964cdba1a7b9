#version 3.7;
bicubic_patch { type 1 uv_vectors <0, 0> 0, x, x*2, x*3, y, y+x, y+x*2, y+x*3, y*2, y*2+x, y*2+x*2, y*2+x*3, y*3, y*3+x, y*3+x*2, y*3+x*3 }

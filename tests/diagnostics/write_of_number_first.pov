// SPDX-License-Identifier: GPL-3.0-or-later
// What is written before where to
#version 3.7;
#fopen F "lg_x.txt" write #write (1, F)

// SPDX-License-Identifier: GPL-3.0-or-later
// rand of a number that no seed gave
#version 3.7;
#declare A = rand(12);

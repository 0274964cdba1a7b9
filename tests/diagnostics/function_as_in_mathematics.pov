// SPDX-License-Identifier: GPL-3.0-or-later
// #declare F(X) = X*2;
#version 3.7;
#declare F(X) = X*2;

// SPDX-License-Identifier: GPL-3.0-or-later
// A function outside of its domain
#version 3.7;
sphere { 0, sqrt(-2) }
sphere { 0, 1 translate asin(2) }

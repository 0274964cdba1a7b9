// SPDX-License-Identifier: GPL-3.0-or-later
// #include of a number
#version 3.7;
#include 3

// SPDX-License-Identifier: GPL-3.0-or-later
// #include without quotes
#version 3.7;
#include colors.inc

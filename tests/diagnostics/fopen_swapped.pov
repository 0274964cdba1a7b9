// SPDX-License-Identifier: GPL-3.0-or-later
// The name of the file first
#version 3.7;
#fopen "a.txt" F write

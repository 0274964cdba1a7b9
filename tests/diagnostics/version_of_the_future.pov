// SPDX-License-Identifier: GPL-3.0-or-later
// A version that does not exist
#version 9.5;

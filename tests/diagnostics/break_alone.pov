// SPDX-License-Identifier: GPL-3.0-or-later
// A #break that leaves nothing
#version 3.7;
#break

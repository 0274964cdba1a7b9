// SPDX-License-Identifier: GPL-3.0-or-later
// Reads a model by Assimp alone, with the steps that the program asks for: the measure for the time
// that `model { }` takes.
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>

int main(int count, char** words) {
    if (count != 2) return 2;
    Assimp::Importer importer;
    importer.SetPropertyInteger(AI_CONFIG_PP_SBP_REMOVE,
                                aiPrimitiveType_POINT | aiPrimitiveType_LINE);
    return importer.ReadFile(words[1], aiProcess_Triangulate | aiProcess_SortByPType) ? 0 : 1;
}

// Deformation: what one work list of vertices is told.
#pragma once
#include "shared/language.h"
SHARED_BEGIN

const int kDeformGroup = 64;  // vertices
// In these buffers a vertex takes so many floats.
const int kRestFloats = 10;       // position, normal, tangent and its side
const int kAttributeFloats = 13;  // normal, tangent and its side; behind them what stays
// Bits of DeformJob.counts.w.
const int kDeformNormals = 1;   // there are any
const int kDeformTangents = 2;  // likewise
const int kDeformFlat = 4;      // normals are those of whole triangles, three vertices by three

/// One primitive of one deformer.
struct DeformJob {
    ivec4 counts;  ///< vertices, influences of each (0: unskinned), targets that count, flags
    ivec4 limits;  ///< x: joints
};

/// A morph target that counts: where its displacements start, in floats (-1: none), of positions,
/// normals and tangents; and the bits of its weight.
struct ActiveTarget {
    ivec4 starts;
};

SHARED_END

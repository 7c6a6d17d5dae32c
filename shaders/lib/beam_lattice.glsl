// The lattice of method `adaptive`: every kLatticeStep-th pixel of the picture each way. A cell is
// what lies between four points; those on the last column and row of points have only some of them.
// No light.

/// Whether a cell, named by its lowest point, has all its four points.
bool isWholeCell(ivec2 cell, ivec2 points) {
    return cell.x + 1 < points.x && cell.y + 1 < points.y;
}

/// Where a pixel lies in its cell, 0..1 each way.
vec2 latticeFraction(ivec2 pixel) {
    ivec2 cell = pixel / kLatticeStep;
    return vec2(pixel - cell * kLatticeStep) / float(kLatticeStep);
}

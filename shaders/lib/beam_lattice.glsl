// The lattice of method `adaptive`: every kLatticeStep-th pixel of the picture each way, and a finer
// one of every kFineStep-th. A square is what lies between four points, a cell of the lattice, a quad
// of the finer one; those on the last column and row of points have only some of them. No light.

/// Whether a square, named by its lowest point, has all its four points.
bool isWholeSquare(ivec2 square, ivec2 points) {
    return square.x + 1 < points.x && square.y + 1 < points.y;
}

/// Where a pixel lies in its square of side `step` pixels, 0..1 each way.
vec2 latticeFraction(ivec2 pixel, int step) {
    ivec2 square = pixel / step;
    return vec2(pixel - square * step) / float(step);
}

/// Of the kNewPoints that halving the step adds to a square: places from the square's lowest point, in
/// halves of its side.
ivec2 newPoint(int index) {
    return ivec2((index + 1) % 2, (index + 1) / 2);
}

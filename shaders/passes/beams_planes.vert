// Beams, method `planes`: the thesis's view-aligned sampling planes, one an instance, over the whole
// view, optionally with the smooth factor evaluated at the corners of cells (Pessoa 2007, equation 8).
#include "shared/slots.h"
#include "shared/view.h"
#include "shared/lamp.h"
#include "shared/beams.h"
#include "lib/haze.glsl"
#include "lib/spot_light.glsl"
#include "lib/phase_function.glsl"
#include "lib/beam_radiance.glsl"
#include "lib/view_ray.glsl"
#include "passes/beams_planes_factor.glsl"

out vec3 viewPosition;
#ifdef CELLS
out float smoothFactor;
#endif

void main() {
    // Two triangles a cell; without cells the plane is one cell.
    ivec2 cells = max(settings.cells.xy, ivec2(1));
    int cell = gl_VertexID / 6;
    int corner = gl_VertexID % 6;
    ivec2 at = ivec2(cell % cells.x, cell / cells.x) +
               ivec2(corner == 1 || corner == 2 || corner == 4, corner == 2 || corner == 4 || corner == 5);
    vec2 ndc = 2.0 * vec2(at) / vec2(cells) - 1.0;

    float distanceMetres = settings.planes.y + (float(gl_InstanceID) + 0.5) * settings.planes.z;
    vec3 direction = viewRayDirection(ndc, view.halfExtent);
    viewPosition = viewRayOrigin(ndc, view.halfExtent) + direction * (distanceMetres / -direction.z);
#ifdef CELLS
    smoothFactor = sheetFactor(viewPosition);
#endif
    gl_Position = view.clipFromView * vec4(viewPosition, 1.0);
}

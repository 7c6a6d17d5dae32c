// What every OpenGL context of the program is set up with, whatever opened it.
#pragma once

namespace ribalta {

/// Sets the current context up: its complaints are told, depth is the same on both sides of the
/// projection.
void prepareContext();

}  // namespace ribalta

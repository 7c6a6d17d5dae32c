// Pointer and keys: what a person does over the picture, as changes of the view and the look.
#pragma once

#include <set>
#include <vector>

#include <glm/glm.hpp>

#include "viewer/stage_view.h"
#include "viewer/viewer_state.h"
#include "viewer/window.h"

namespace ribalta {

class Pointer {
  public:
    /// Turns this frame's movements of the mouse and the keys that are held (`keys` went down in
    /// it) into those of the camera, of the lamp that is chosen and of its aim, and draws the marks
    /// over the picture. `window` in pixels, `scale`: pixels for one unit of the pointer's
    /// coordinates.
    void steer(const std::vector<KeyPress>& keys, ViewerState& state, const StageView& stage,
               glm::ivec2 window, glm::vec2 scale);

    /// A key is held that moves the camera, of which no more events come.
    bool isWalking() const { return walking_; }
    bool isOverPanels() const { return overPanels_; }
    /// Pixels from the window's upper left.
    glm::dvec2 at() const { return at_; }

  private:
    void dragCamera(ViewerState& state, glm::ivec2 window, glm::dvec2 moved) const;
    void dragAim(ViewerState& state, const StageView& stage, glm::ivec2 window) const;
    bool walkByKeys(const std::vector<KeyPress>& keys, ViewerState& state, const StageView& stage);

    std::set<int> held_;  ///< keys that walk, and went down without Ctrl
    bool walking_ = false;
    bool overPanels_ = false;
    bool aiming_ = false;   ///< the chosen lamp's cross is being dragged
    bool onLamp_ = false;   ///< the button went down on a lamp's mark or cross
    bool dragged_ = false;  ///< since then: no click
    glm::dvec2 at_{0.0};
};

/// What keys ask for that went down. `stage` may be null.
void handleKeys(const std::vector<KeyPress>& keys, ViewerState& state, const StageView* stage,
                glm::ivec2 window);

}  // namespace ribalta

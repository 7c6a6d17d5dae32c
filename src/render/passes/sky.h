// Sky: what is behind everything and the air in front of it, by tables that are kept while what
// they depend on stays the same.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/texture.h"
#include "render/frame_plan.h"
#include "render/frame_targets.h"
#include "render/passes/sky_baseline.h"
#include "render/sky_lighting.h"
#include "render/sky_textures.h"

namespace ribalta {

class SkyPass {
  public:
    /// `files`: where tables are kept from one run to the next; null: nowhere.
    explicit SkyPass(const FileCache* files) : files_(files) {}

    /// Makes the tables of the air that the work asks for. Returns what the scene is lit with.
    const SkyLighting& prepare(const SkyWork& work);
    /// Makes the tables of the view, and draws. The view must be bound to its slot.
    void draw(const SkyWork& work, const FramePlan& plan, const FrameTargets& targets);
    /// Leaves the sky's uniform block bound, for surfaces too.
    void uploadFrame(const SkyWork& work, const Camera& camera);

  private:
    void makeTable(Program& program, const std::string& shader, const Texture2D& table,
                   glm::ivec3 size);
    void makeViewTable(const SkyWork& work);
    /// An empty list of the picture's tiles, and what draws those that it was filled with.
    void beginEdgeTiles(const FramePlan& plan);
    void drawEdgeTiles();

    void prepareTables(const SkyWork& work);

    const FileCache* files_;
    SkyTextures textures_;
    std::optional<BaselineSky> baseline_;  ///< in the place of the renderer's own model
    std::optional<SkyDrawing> lit_;
    SkyLighting lighting_;
    std::vector<std::string> defines_;
    Buffer frame_;
    Program view_;
    Program aerial_;
    Program edgesProgram_;
    Program edgeTilesProgram_;
    std::map<std::pair<int, bool>, Program> composite_;  ///< by the haze's phase function, edges
    Texture2D viewTable_;
    Buffer edges_;  ///< where that is not to be interpolated
    Buffer edgeTiles_;
    Texture2D aerialTable_;
};

}  // namespace ribalta

// Shadow pyramid: the least and the greatest depth of ever larger blocks of shadow maps, by which
// beams tell that a run of sheets is lit or dark without looking at each.
#pragma once

#include <vector>

#include "gl/buffer.h"
#include "gl/program.h"
#include "gl/sampler.h"
#include "gl/texture.h"

namespace ribalta {

class ShadowPyramidPass {
  public:
    ShadowPyramidPass();
    /// Makes the given layers' pyramids from their maps, which are as large as those before or all
    /// given.
    void draw(const std::vector<int>& layers, const Texture2D& shadowMaps);

    /// RG32F (least, greatest), as many layers as the maps. Level 0: blocks of 4 x 4 texels; level
    /// n: blocks of 4 << n with their next neighbours to the right and above.
    const Texture2D& pyramid() const { return pyramid_; }

  private:
    Program fromMaps_;
    Program fromLevel_;
    Handle<deleteSampler> depthSampler_;  ///< reads shadow maps as depths, without comparing
    Texture2D pyramid_;
    Buffer layers_;
};

}  // namespace ribalta

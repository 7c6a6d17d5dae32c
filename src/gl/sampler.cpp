#include "gl/sampler.h"

namespace ribalta {

Handle<deleteSampler> makeDepthSampler() {
    GLuint name = 0;
    glCreateSamplers(1, &name);
    Handle<deleteSampler> sampler(name);
    glSamplerParameteri(name, GL_TEXTURE_COMPARE_MODE, GL_NONE);
    glSamplerParameteri(name, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glSamplerParameteri(name, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return sampler;
}

}  // namespace ribalta

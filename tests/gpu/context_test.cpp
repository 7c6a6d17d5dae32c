// The headless context, and that the tests would see an error of OpenGL.
#include "gl/context.h"

#include "gl/debug_output.h"
#include "gpu_test.h"

namespace ribalta::test {
namespace {

class ContextTest : public GpuTest {};

TEST_F(ContextTest, OffersOpenGl45Core) {
    GLint major = 0;
    GLint minor = 0;
    GLint profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_GE(10 * major + minor, 45);
    EXPECT_EQ(profile, GL_CONTEXT_CORE_PROFILE_BIT);
    GLint depthMode = 0;
    glGetIntegerv(GL_CLIP_DEPTH_MODE, &depthMode);
    EXPECT_EQ(depthMode, GL_ZERO_TO_ONE);
}

TEST_F(ContextTest, ErrorsOfOpenGlAreKept) {
    glEnable(GL_TEXTURE_2D_ARRAY);  // no capability
    EXPECT_EQ(takeGlErrors().size(), 1U);
    EXPECT_TRUE(takeGlErrors().empty());
    EXPECT_EQ(glGetError(), GLenum(GL_INVALID_ENUM));
}

}  // namespace
}  // namespace ribalta::test

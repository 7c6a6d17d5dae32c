// Evaluates GLSL of the shader library on the GPU for many inputs at once.
#pragma once

#include <string>
#include <vector>

namespace ribalta::test {

/// Runs `body`, GLSL statements that read a(0) ... a(inputs - 1) and call put(0, x) ...
/// put(outputs - 1, x), once for every `inputs` values, with all of shaders/lib to call. Returns
/// `outputs` values each. Fails the test where it does not compile.
std::vector<float> evaluateGlsl(const std::string& body, const std::vector<float>& values,
                                int inputs, int outputs);

}  // namespace ribalta::test

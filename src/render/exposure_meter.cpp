#include "render/exposure_meter.h"

#include <shared/slots.h>

#include "gl/counters.h"

namespace ribalta {

namespace {

// As the shaders' block Exposure.
struct ExposureBlock {
    float ev100 = 0.0F;
    int toneCurve = 0;
};

}  // namespace

void ExposureMeter::draw(const std::optional<double>& ev100, ToneCurve curve,
                         const Texture2D& color) {
    const std::vector<ExposureBlock> given = {{float(ev100.value_or(0.0)), int(curve)}};
    exposure_.write("exposure", bytesOf(given));
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, gpu::kExposureSlot, exposure_.name());
    if (ev100) {
        return;
    }
    if (!program_) {
        program_ = Program({"passes/exposure.comp"}, defines_);
    }
    glUseProgram(program_.name());
    glBindTextureUnit(gpu::kColorUnit, color.name());
    glDispatchCompute(1, 1, 1);
    ++glCounters().drawCalls;
    glMemoryBarrier(GL_SHADER_STORAGE_BARRIER_BIT | GL_BUFFER_UPDATE_BARRIER_BIT);
}

double ExposureMeter::ev100() const {
    std::vector<ExposureBlock> block(1);
    exposure_.read(std::as_writable_bytes(std::span(block)));
    return double(block[0].ev100);
}

}  // namespace ribalta

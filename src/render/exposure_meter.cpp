#include "render/exposure_meter.h"

#include <shared/slots.h>

#include "gl/counters.h"

namespace ribalta {

void ExposureMeter::draw(const std::optional<double>& ev100, const Texture2D& color) {
    const std::vector<float> given = {float(ev100.value_or(0.0))};
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
    std::vector<float> value(1);
    exposure_.read(std::as_writable_bytes(std::span(value)));
    return double(value[0]);
}

}  // namespace ribalta

#include "gl/timer.h"

namespace ribalta {
namespace {

Handle<deleteQuery> stamp() {
    GLuint name = 0;
    glCreateQueries(GL_TIMESTAMP, 1, &name);
    glQueryCounter(name, GL_TIMESTAMP);
    return Handle<deleteQuery>(name);
}

GLuint64 nanoseconds(const Handle<deleteQuery>& query) {
    GLuint64 value = 0;
    glGetQueryObjectui64v(query.name(), GL_QUERY_RESULT, &value);
    return value;
}

}  // namespace

void PassTimer::begin(const std::string& name) {
    end();
    passes_.push_back({name, std::chrono::steady_clock::now(), 0.0, stamp(), {}});
    running_ = true;
}

void PassTimer::end() {
    if (!running_) {
        return;
    }
    running_ = false;
    Pass& pass = passes_.back();
    pass.endStamp = stamp();
    pass.cpuMs =
        std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - pass.start)
            .count();
}

std::vector<PassTime> PassTimer::take() {
    end();
    std::vector<PassTime> times;
    for (const Pass& pass : passes_) {
        const auto gpu = nanoseconds(pass.endStamp) - nanoseconds(pass.startStamp);
        times.push_back({pass.name, pass.cpuMs, double(gpu) * 1e-6});
    }
    passes_.clear();
    return times;
}

}  // namespace ribalta

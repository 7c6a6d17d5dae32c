// PassTimer: how long each pass of a frame took, on the CPU and on the GPU.
#pragma once

#include <chrono>
#include <string>
#include <vector>

#include "gl/handle.h"

namespace ribalta {

struct PassTime {
    std::string name;
    double cpuMs = 0.0;  ///< giving the commands
    double gpuMs = 0.0;  ///< carrying them out, by the driver's time stamps
};

inline void deleteQuery(GLuint name) {
    glDeleteQueries(1, &name);
}

class PassTimer {
  public:
    /// Ends the pass before and starts another.
    void begin(const std::string& name);
    void end();
    /// The times of all passes since the last call; waits for the GPU.
    std::vector<PassTime> take();

  private:
    struct Pass {
        std::string name;
        std::chrono::steady_clock::time_point start;
        double cpuMs = 0.0;
        Handle<deleteQuery> startStamp;
        Handle<deleteQuery> endStamp;
    };

    std::vector<Pass> passes_;
    bool running_ = false;
};

}  // namespace ribalta

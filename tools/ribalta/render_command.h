// `ribalta render`: one frame without a window.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

void addRenderCommand(CLI::App& app);

}  // namespace ribalta

// `ribalta inspect`: what a file holds, what was ignored or repaired.
#pragma once

namespace CLI {
class App;
}

namespace ribalta {

void addInspectCommand(CLI::App& app);

}  // namespace ribalta
